file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_problem_class"
  "../../devel/lib/explore_opt/test_problem_class.pdb"
  "CMakeFiles/test_problem_class.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_problem_class.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_problem_class.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
