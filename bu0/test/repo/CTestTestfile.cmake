# CMake generated Testfile for 
# Source directory: /work/wt/unity/test/repo
# Build directory: /work/wt/unity/bu0/test/repo
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
add_test(test_layers "/usr/bin/python3" "-W" "error::ResourceWarning" "/work/wt/unity/test/repo/test_layers.py")
set_tests_properties(test_layers PROPERTIES  TIMEOUT "60" _BACKTRACE_TRIPLES "/work/wt/unity/test/repo/CMakeLists.txt;7;add_test;/work/wt/unity/test/repo/CMakeLists.txt;11;quad_add_repo_test;/work/wt/unity/test/repo/CMakeLists.txt;0;")
add_test(test_setup_and_doctor "/usr/bin/python3" "-W" "error::ResourceWarning" "/work/wt/unity/test/repo/test_setup_and_doctor.py")
set_tests_properties(test_setup_and_doctor PROPERTIES  TIMEOUT "120" _BACKTRACE_TRIPLES "/work/wt/unity/test/repo/CMakeLists.txt;7;add_test;/work/wt/unity/test/repo/CMakeLists.txt;12;quad_add_repo_test;/work/wt/unity/test/repo/CMakeLists.txt;0;")
add_test(test_launch_files "/usr/bin/python3" "-W" "error::ResourceWarning" "/work/wt/unity/test/repo/test_launch_files.py")
set_tests_properties(test_launch_files PROPERTIES  TIMEOUT "120" _BACKTRACE_TRIPLES "/work/wt/unity/test/repo/CMakeLists.txt;7;add_test;/work/wt/unity/test/repo/CMakeLists.txt;13;quad_add_repo_test;/work/wt/unity/test/repo/CMakeLists.txt;0;")
add_test(test_monitor "/usr/bin/python3" "-W" "error::ResourceWarning" "/work/wt/unity/test/repo/test_monitor.py")
set_tests_properties(test_monitor PROPERTIES  TIMEOUT "180" _BACKTRACE_TRIPLES "/work/wt/unity/test/repo/CMakeLists.txt;7;add_test;/work/wt/unity/test/repo/CMakeLists.txt;14;quad_add_repo_test;/work/wt/unity/test/repo/CMakeLists.txt;0;")
add_test(test_experiment_runner "/usr/bin/python3" "-W" "error::ResourceWarning" "/work/wt/unity/test/repo/test_experiment_runner.py")
set_tests_properties(test_experiment_runner PROPERTIES  TIMEOUT "600" _BACKTRACE_TRIPLES "/work/wt/unity/test/repo/CMakeLists.txt;7;add_test;/work/wt/unity/test/repo/CMakeLists.txt;15;quad_add_repo_test;/work/wt/unity/test/repo/CMakeLists.txt;0;")
add_test(test_readme "/usr/bin/python3" "-W" "error::ResourceWarning" "/work/wt/unity/test/repo/test_readme.py")
set_tests_properties(test_readme PROPERTIES  RUN_SERIAL "TRUE" TIMEOUT "3600" _BACKTRACE_TRIPLES "/work/wt/unity/test/repo/CMakeLists.txt;7;add_test;/work/wt/unity/test/repo/CMakeLists.txt;16;quad_add_repo_test;/work/wt/unity/test/repo/CMakeLists.txt;0;")
