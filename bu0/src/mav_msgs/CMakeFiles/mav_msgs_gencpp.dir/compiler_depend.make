# Empty custom commands generated dependencies file for mav_msgs_gencpp.
# This may be replaced when dependencies are built.
