# CMake generated Testfile for 
# Source directory: /work/wt/unity
# Build directory: /work/wt/unity/bu0
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
subdirs("src/gazebo_msgs")
subdirs("src/mav_msgs")
subdirs("src/quad_support")
subdirs("src/explore_opt")
subdirs("src/rotors_comm")
subdirs("src/quad_sim")
subdirs("src/quad_control")
subdirs("src/quad_experiment")
subdirs("test")
