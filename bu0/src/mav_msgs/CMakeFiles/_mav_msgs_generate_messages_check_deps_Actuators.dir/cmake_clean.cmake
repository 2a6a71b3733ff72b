file(REMOVE_RECURSE
  "CMakeFiles/_mav_msgs_generate_messages_check_deps_Actuators"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_mav_msgs_generate_messages_check_deps_Actuators.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
