file(REMOVE_RECURSE
  "../../devel/lib/python3/dist-packages/rotors_comm/msg/_WindSpeed.py"
  "../../devel/lib/python3/dist-packages/rotors_comm/msg/__init__.py"
  "../../devel/lib/python3/dist-packages/rotors_comm/srv/_RecordRosbag.py"
  "../../devel/lib/python3/dist-packages/rotors_comm/srv/__init__.py"
  "CMakeFiles/rotors_comm_generate_messages_py"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/rotors_comm_generate_messages_py.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
