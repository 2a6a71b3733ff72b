# CMake generated Testfile for 
# Source directory: /work/wt/unity/src/gazebo_msgs
# Build directory: /work/wt/unity/bu0/src/gazebo_msgs
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
