file(REMOVE_RECURSE
  "../../devel/share/common-lisp/ros/quad_sim/srv/CommandReport.lisp"
  "../../devel/share/common-lisp/ros/quad_sim/srv/RestoreState.lisp"
  "../../devel/share/common-lisp/ros/quad_sim/srv/SaveState.lisp"
  "../../devel/share/common-lisp/ros/quad_sim/srv/Step.lisp"
  "CMakeFiles/quad_sim_generate_messages_lisp"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/quad_sim_generate_messages_lisp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
