
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/mav_msgs_genpy.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
