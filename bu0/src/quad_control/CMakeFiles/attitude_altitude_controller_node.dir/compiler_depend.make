# Empty compiler generated dependencies file for attitude_altitude_controller_node.
# This may be replaced when dependencies are built.
