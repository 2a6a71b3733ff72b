file(REMOVE_RECURSE
  "../../devel/lib/libexplore_opt.pdb"
  "../../devel/lib/libexplore_opt.so"
  "CMakeFiles/explore_opt.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/explore_opt.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/explore_opt.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
