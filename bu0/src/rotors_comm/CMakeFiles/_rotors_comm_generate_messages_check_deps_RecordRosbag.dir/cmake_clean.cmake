file(REMOVE_RECURSE
  "CMakeFiles/_rotors_comm_generate_messages_check_deps_RecordRosbag"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/_rotors_comm_generate_messages_check_deps_RecordRosbag.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
