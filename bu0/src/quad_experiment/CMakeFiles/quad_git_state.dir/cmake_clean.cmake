file(REMOVE_RECURSE
  "CMakeFiles/quad_git_state"
  "quad_git_state.h"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_git_state.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
