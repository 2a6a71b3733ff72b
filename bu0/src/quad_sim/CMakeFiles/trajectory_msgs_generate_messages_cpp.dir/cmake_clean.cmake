
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/trajectory_msgs_generate_messages_cpp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
