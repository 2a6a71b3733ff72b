file(REMOVE_RECURSE
  "../../devel/share/common-lisp/ros/rotors_comm/msg/WindSpeed.lisp"
  "../../devel/share/common-lisp/ros/rotors_comm/srv/RecordRosbag.lisp"
  "CMakeFiles/rotors_comm_generate_messages_lisp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/rotors_comm_generate_messages_lisp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
