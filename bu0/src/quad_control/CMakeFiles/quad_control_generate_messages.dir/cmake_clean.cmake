
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_control_generate_messages.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
