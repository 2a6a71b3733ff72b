# generated from genmsg/cmake/pkg-genmsg.context.in

messages_str = ""
services_str = "/work/wt/unity/src/quad_sim/srv/CommandReport.srv;/work/wt/unity/src/quad_sim/srv/RestoreState.srv;/work/wt/unity/src/quad_sim/srv/SaveState.srv;/work/wt/unity/src/quad_sim/srv/Step.srv"
pkg_name = "quad_sim"
dependencies_str = "std_msgs;geometry_msgs;nav_msgs;mav_msgs"
langs = "gencpp;genlisp;genpy"
dep_include_paths_str = "std_msgs;/usr/share/std_msgs/cmake/../msg;geometry_msgs;/usr/share/geometry_msgs/msg;nav_msgs;/usr/share/nav_msgs/msg;mav_msgs;/work/wt/unity/src/mav_msgs/msg;actionlib_msgs;/usr/share/actionlib_msgs/msg"
PYTHON_EXECUTABLE = "/usr/bin/python3"
package_has_static_sources = '' == 'TRUE'
genmsg_check_deps_script = "/usr/lib/genmsg/genmsg_check_deps.py"
