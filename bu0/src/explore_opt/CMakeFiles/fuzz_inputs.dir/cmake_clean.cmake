file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/fuzz_inputs"
  "../../devel/lib/explore_opt/fuzz_inputs.pdb"
  "CMakeFiles/fuzz_inputs.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/fuzz_inputs.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/fuzz_inputs.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
