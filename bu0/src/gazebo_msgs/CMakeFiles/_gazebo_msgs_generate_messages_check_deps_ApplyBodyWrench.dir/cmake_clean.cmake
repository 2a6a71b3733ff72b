file(REMOVE_RECURSE
  "CMakeFiles/_gazebo_msgs_generate_messages_check_deps_ApplyBodyWrench"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_gazebo_msgs_generate_messages_check_deps_ApplyBodyWrench.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
