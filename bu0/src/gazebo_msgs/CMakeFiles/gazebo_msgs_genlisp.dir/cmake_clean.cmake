
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/gazebo_msgs_genlisp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
