file(REMOVE_RECURSE
  "../../devel/include/rotors_comm/RecordRosbag.h"
  "../../devel/include/rotors_comm/WindSpeed.h"
  "CMakeFiles/rotors_comm_generate_messages_cpp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/rotors_comm_generate_messages_cpp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
