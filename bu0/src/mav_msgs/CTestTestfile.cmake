# CMake generated Testfile for 
# Source directory: /work/wt/unity/src/mav_msgs
# Build directory: /work/wt/unity/bu0/src/mav_msgs
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
