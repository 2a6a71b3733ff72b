file(REMOVE_RECURSE
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/_LinkState.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/_LinkStates.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/_ModelState.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/_ModelStates.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/_ODEPhysics.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/_PerformanceMetrics.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/_SensorPerformanceMetric.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/msg/__init__.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_ApplyBodyWrench.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_BodyRequest.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_DeleteModel.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_GetJointProperties.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_GetLinkProperties.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_GetLinkState.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_GetModelProperties.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_GetModelState.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_GetPhysicsProperties.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_GetWorldProperties.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_SetLinkState.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_SetModelState.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_SetPhysicsProperties.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/_SpawnModel.py"
  "../../devel/lib/python3/dist-packages/gazebo_msgs/srv/__init__.py"
  "CMakeFiles/gazebo_msgs_generate_messages_py"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/gazebo_msgs_generate_messages_py.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
