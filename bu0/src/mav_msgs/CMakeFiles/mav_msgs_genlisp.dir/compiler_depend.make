# Empty custom commands generated dependencies file for mav_msgs_genlisp.
# This may be replaced when dependencies are built.
