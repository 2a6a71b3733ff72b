# CMAKE generated file: DO NOT EDIT!
# Timestamp file for compiler generated dependencies management for attitude_altitude_controller_node.
