file(REMOVE_RECURSE
  "../../devel/share/common-lisp/ros/gazebo_msgs/msg/LinkState.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/msg/LinkStates.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/msg/ModelState.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/msg/ModelStates.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/msg/ODEPhysics.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/msg/PerformanceMetrics.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/msg/SensorPerformanceMetric.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/ApplyBodyWrench.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/BodyRequest.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/DeleteModel.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/GetJointProperties.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/GetLinkProperties.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/GetLinkState.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/GetModelProperties.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/GetModelState.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/GetPhysicsProperties.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/GetWorldProperties.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/SetLinkState.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/SetModelState.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/SetPhysicsProperties.lisp"
  "../../devel/share/common-lisp/ros/gazebo_msgs/srv/SpawnModel.lisp"
  "CMakeFiles/gazebo_msgs_generate_messages_lisp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/gazebo_msgs_generate_messages_lisp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
