# CMake generated Testfile for 
# Source directory: /work/wt/unity/src/quad_support
# Build directory: /work/wt/unity/bu0/src/quad_support
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
add_test(_ctest_quad_support_gtest_test_support "/work/wt/unity/bu0/catkin_generated/env_cached.sh" "/usr/bin/python3" "/usr/share/catkin/cmake/test/run_tests.py" "/work/wt/unity/bu0/test_results/quad_support/gtest-test_support.xml" "--working-dir" "/work/wt/unity/src/quad_support" "--return-code" "/work/wt/unity/bu0/devel/lib/quad_support/test_support --gtest_output=xml:/work/wt/unity/bu0/test_results/quad_support/gtest-test_support.xml")
set_tests_properties(_ctest_quad_support_gtest_test_support PROPERTIES  _BACKTRACE_TRIPLES "/usr/share/catkin/cmake/test/tests.cmake;160;add_test;/usr/share/catkin/cmake/test/gtest.cmake;98;catkin_run_tests_target;/usr/share/catkin/cmake/test/gtest.cmake;37;_catkin_add_google_test;/work/wt/unity/bu0/devel/share/quad_support/cmake/quad_support-extras.cmake;14;catkin_add_gtest;/work/wt/unity/src/quad_support/CMakeLists.txt;29;quad_add_gtest;/work/wt/unity/src/quad_support/CMakeLists.txt;0;")
