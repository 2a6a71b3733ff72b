file(REMOVE_RECURSE
  "../../devel/lib/python3/dist-packages/quad_sim/srv/_CommandReport.py"
  "../../devel/lib/python3/dist-packages/quad_sim/srv/_RestoreState.py"
  "../../devel/lib/python3/dist-packages/quad_sim/srv/_SaveState.py"
  "../../devel/lib/python3/dist-packages/quad_sim/srv/_Step.py"
  "../../devel/lib/python3/dist-packages/quad_sim/srv/__init__.py"
  "CMakeFiles/quad_sim_generate_messages_py"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_sim_generate_messages_py.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
