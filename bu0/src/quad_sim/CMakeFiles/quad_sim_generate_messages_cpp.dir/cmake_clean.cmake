file(REMOVE_RECURSE
  "../../devel/include/quad_sim/CommandReport.h"
  "../../devel/include/quad_sim/RestoreState.h"
  "../../devel/include/quad_sim/SaveState.h"
  "../../devel/include/quad_sim/Step.h"
  "CMakeFiles/quad_sim_generate_messages_cpp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_sim_generate_messages_cpp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
