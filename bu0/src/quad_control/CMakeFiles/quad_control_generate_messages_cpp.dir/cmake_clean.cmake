file(REMOVE_RECURSE
  "../../devel/include/quad_control/Advance.h"
  "../../devel/include/quad_control/Begin.h"
  "../../devel/include/quad_control/FlightRecord.h"
  "../../devel/include/quad_control/SetFlightPlan.h"
  "../../devel/include/quad_control/TimingReport.h"
  "CMakeFiles/quad_control_generate_messages_cpp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_control_generate_messages_cpp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
