file(REMOVE_RECURSE
  "CMakeFiles/_quad_sim_generate_messages_check_deps_Step"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_quad_sim_generate_messages_check_deps_Step.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
