# generated from genmsg/cmake/pkg-genmsg.context.in

messages_str = "/work/wt/unity/src/rotors_comm/msg/WindSpeed.msg"
services_str = "/work/wt/unity/src/rotors_comm/srv/RecordRosbag.srv"
pkg_name = "rotors_comm"
dependencies_str = "std_msgs;geometry_msgs"
langs = "gencpp;genlisp;genpy"
dep_include_paths_str = "rotors_comm;/work/wt/unity/src/rotors_comm/msg;std_msgs;/usr/share/std_msgs/cmake/../msg;geometry_msgs;/usr/share/geometry_msgs/msg"
PYTHON_EXECUTABLE = "/usr/bin/python3"
package_has_static_sources = '' == 'TRUE'
genmsg_check_deps_script = "/usr/lib/genmsg/genmsg_check_deps.py"
