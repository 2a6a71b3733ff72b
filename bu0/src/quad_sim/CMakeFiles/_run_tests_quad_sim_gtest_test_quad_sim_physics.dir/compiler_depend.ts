# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for _run_tests_quad_sim_gtest_test_quad_sim_physics.
