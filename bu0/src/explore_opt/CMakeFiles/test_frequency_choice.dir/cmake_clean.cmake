file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_frequency_choice"
  "../../devel/lib/explore_opt/test_frequency_choice.pdb"
  "CMakeFiles/test_frequency_choice.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_frequency_choice.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_frequency_choice.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
