file(REMOVE_RECURSE
  "../../devel/lib/quad_experiment/quad_experiment"
  "../../devel/lib/quad_experiment/quad_experiment.pdb"
  "CMakeFiles/quad_experiment_program.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_experiment_program.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_experiment_program.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
