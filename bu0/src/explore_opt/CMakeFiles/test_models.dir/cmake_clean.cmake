file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/test_models"
  "../../devel/lib/explore_opt/test_models.pdb"
  "CMakeFiles/test_models.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/test_models.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/test_models.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
