# generated from genmsg/cmake/pkg-genmsg.context.in

messages_str = ""
services_str = "/work/wt/unity/src/quad_control/srv/Advance.srv;/work/wt/unity/src/quad_control/srv/Begin.srv;/work/wt/unity/src/quad_control/srv/FlightRecord.srv;/work/wt/unity/src/quad_control/srv/SetFlightPlan.srv;/work/wt/unity/src/quad_control/srv/TimingReport.srv"
pkg_name = "quad_control"
dependencies_str = "nav_msgs;mav_msgs"
langs = "gencpp;genlisp;genpy"
dep_include_paths_str = "nav_msgs;/usr/share/nav_msgs/msg;mav_msgs;/work/wt/unity/src/mav_msgs/msg;geometry_msgs;/usr/share/geometry_msgs/msg;std_msgs;/usr/share/std_msgs/cmake/../msg;actionlib_msgs;/usr/share/actionlib_msgs/msg"
PYTHON_EXECUTABLE = "/usr/bin/python3"
package_has_static_sources = '' == 'TRUE'
genmsg_check_deps_script = "/usr/lib/genmsg/genmsg_check_deps.py"
