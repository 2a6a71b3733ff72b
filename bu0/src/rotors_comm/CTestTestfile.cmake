# CMake generated Testfile for 
# Source directory: /work/wt/unity/src/rotors_comm
# Build directory: /work/wt/unity/bu0/src/rotors_comm
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
