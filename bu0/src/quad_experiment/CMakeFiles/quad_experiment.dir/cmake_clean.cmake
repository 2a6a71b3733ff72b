file(REMOVE_RECURSE
  "../../devel/lib/libquad_experiment.pdb"
  "../../devel/lib/libquad_experiment.so"
  "CMakeFiles/quad_experiment.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/quad_experiment.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/quad_experiment.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
