# Empty dependencies file for waypoint_node.
# This may be replaced when dependencies are built.
