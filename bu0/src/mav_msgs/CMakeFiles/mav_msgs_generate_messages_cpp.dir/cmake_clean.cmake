file(REMOVE_RECURSE
  "../../devel/include/mav_msgs/Actuators.h"
  "../../devel/include/mav_msgs/AttitudeThrust.h"
  "../../devel/include/mav_msgs/RateThrust.h"
  "CMakeFiles/mav_msgs_generate_messages_cpp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/mav_msgs_generate_messages_cpp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
