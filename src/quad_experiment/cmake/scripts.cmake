# The package's Python programs: the flight's monitor. Included by ../CMakeLists.txt.
catkin_install_python(PROGRAMS scripts/monitor DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
