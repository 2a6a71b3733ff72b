file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_audit"
  "../../devel/lib/explore_opt/test_audit.pdb"
  "CMakeFiles/test_audit.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_audit.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_audit.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
