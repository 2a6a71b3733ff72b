
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_control_genpy.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
