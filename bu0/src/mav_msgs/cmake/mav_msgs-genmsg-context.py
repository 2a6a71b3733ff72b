# generated from genmsg/cmake/pkg-genmsg.context.in

messages_str = "/work/wt/unity/src/mav_msgs/msg/Actuators.msg;/work/wt/unity/src/mav_msgs/msg/AttitudeThrust.msg;/work/wt/unity/src/mav_msgs/msg/RateThrust.msg"
services_str = ""
pkg_name = "mav_msgs"
dependencies_str = "std_msgs;geometry_msgs"
langs = "gencpp;genlisp;genpy"
dep_include_paths_str = "mav_msgs;/work/wt/unity/src/mav_msgs/msg;std_msgs;/usr/share/std_msgs/cmake/../msg;geometry_msgs;/usr/share/geometry_msgs/msg"
PYTHON_EXECUTABLE = "/usr/bin/python3"
package_has_static_sources = '' == 'TRUE'
genmsg_check_deps_script = "/usr/lib/genmsg/genmsg_check_deps.py"
