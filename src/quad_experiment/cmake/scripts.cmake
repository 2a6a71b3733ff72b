# The package's Python programs: the flight's monitor, the exporter that `quad_experiment export` calls, and the replay of its bags.
# Included by ../CMakeLists.txt.
catkin_install_python(PROGRAMS scripts/monitor scripts/export_run scripts/replay_bag DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY scripts/quad_export DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION} FILES_MATCHING PATTERN "*.py")
