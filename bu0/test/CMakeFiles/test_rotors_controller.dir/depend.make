# Empty dependencies file for test_rotors_controller.
# This may be replaced when dependencies are built.
