file(REMOVE_RECURSE
  "../../devel/lib/libquad_control_ros.a"
)
