file(REMOVE_RECURSE
  "../../devel/lib/python3/dist-packages/mav_msgs/msg/_Actuators.py"
  "../../devel/lib/python3/dist-packages/mav_msgs/msg/_AttitudeThrust.py"
  "../../devel/lib/python3/dist-packages/mav_msgs/msg/_RateThrust.py"
  "../../devel/lib/python3/dist-packages/mav_msgs/msg/__init__.py"
  "CMakeFiles/mav_msgs_generate_messages_py"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/mav_msgs_generate_messages_py.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
