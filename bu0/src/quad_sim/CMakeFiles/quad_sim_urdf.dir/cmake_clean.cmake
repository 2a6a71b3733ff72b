file(REMOVE_RECURSE
  "../../urdf/firefly.urdf"
  "../../urdf/hummingbird.urdf"
  "../../urdf/pelican.urdf"
  "CMakeFiles/quad_sim_urdf"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_sim_urdf.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
