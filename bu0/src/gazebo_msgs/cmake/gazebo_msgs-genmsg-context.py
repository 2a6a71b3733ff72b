# generated from genmsg/cmake/pkg-genmsg.context.in

messages_str = "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg;/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg;/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg;/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg;/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg;/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg;/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
services_str = "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv;/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv;/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv;/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv;/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv;/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv;/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv;/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv;/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv;/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv;/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv;/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv;/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv;/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv"
pkg_name = "gazebo_msgs"
dependencies_str = "std_msgs;geometry_msgs"
langs = "gencpp;genlisp;genpy"
dep_include_paths_str = "gazebo_msgs;/work/wt/unity/src/gazebo_msgs/msg;std_msgs;/usr/share/std_msgs/cmake/../msg;geometry_msgs;/usr/share/geometry_msgs/msg"
PYTHON_EXECUTABLE = "/usr/bin/python3"
package_has_static_sources = '' == 'TRUE'
genmsg_check_deps_script = "/usr/lib/genmsg/genmsg_check_deps.py"
