file(REMOVE_RECURSE
  "../../devel/lib/python3/dist-packages/quad_control/srv/_Advance.py"
  "../../devel/lib/python3/dist-packages/quad_control/srv/_Begin.py"
  "../../devel/lib/python3/dist-packages/quad_control/srv/_FlightRecord.py"
  "../../devel/lib/python3/dist-packages/quad_control/srv/_SetFlightPlan.py"
  "../../devel/lib/python3/dist-packages/quad_control/srv/_TimingReport.py"
  "../../devel/lib/python3/dist-packages/quad_control/srv/__init__.py"
  "CMakeFiles/quad_control_generate_messages_py"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_control_generate_messages_py.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
