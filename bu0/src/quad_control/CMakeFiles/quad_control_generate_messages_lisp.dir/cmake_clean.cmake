file(REMOVE_RECURSE
  "../../devel/share/common-lisp/ros/quad_control/srv/Advance.lisp"
  "../../devel/share/common-lisp/ros/quad_control/srv/Begin.lisp"
  "../../devel/share/common-lisp/ros/quad_control/srv/FlightRecord.lisp"
  "../../devel/share/common-lisp/ros/quad_control/srv/SetFlightPlan.lisp"
  "../../devel/share/common-lisp/ros/quad_control/srv/TimingReport.lisp"
  "CMakeFiles/quad_control_generate_messages_lisp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_control_generate_messages_lisp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
