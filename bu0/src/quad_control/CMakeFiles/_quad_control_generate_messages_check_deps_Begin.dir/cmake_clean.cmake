file(REMOVE_RECURSE
  "CMakeFiles/_quad_control_generate_messages_check_deps_Begin"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_quad_control_generate_messages_check_deps_Begin.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
