file(REMOVE_RECURSE
  "../../devel/lib/explore_opt/explore_opt"
  "../../devel/lib/explore_opt/explore_opt.pdb"
  "CMakeFiles/explore_opt_program.dir/Unity/unity_0_cxx.cxx.o"
  "CMakeFiles/explore_opt_program.dir/Unity/unity_0_cxx.cxx.o.d"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/explore_opt_program.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
