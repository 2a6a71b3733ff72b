file(REMOVE_RECURSE
  "../../devel/lib/quad_experiment/test_batch"
  "../../devel/lib/quad_experiment/test_batch.pdb"
  "CMakeFiles/test_batch.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_batch.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_batch.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
