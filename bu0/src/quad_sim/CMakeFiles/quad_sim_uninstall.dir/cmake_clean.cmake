file(REMOVE_RECURSE
  "CMakeFiles/quad_sim_uninstall"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_sim_uninstall.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
