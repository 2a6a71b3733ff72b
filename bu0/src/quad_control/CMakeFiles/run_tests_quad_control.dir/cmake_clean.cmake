
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/run_tests_quad_control.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
