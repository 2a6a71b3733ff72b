file(REMOVE_RECURSE
  "../../devel/share/common-lisp/ros/mav_msgs/msg/Actuators.lisp"
  "../../devel/share/common-lisp/ros/mav_msgs/msg/AttitudeThrust.lisp"
  "../../devel/share/common-lisp/ros/mav_msgs/msg/RateThrust.lisp"
  "CMakeFiles/mav_msgs_generate_messages_lisp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/mav_msgs_generate_messages_lisp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
