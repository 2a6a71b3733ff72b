# Empty dependencies file for test_frequency_choice.
# This may be replaced when dependencies are built.
