
# Consider dependencies only in project.
set(CMAKE_DEPENDS_IN_PROJECT_ONLY OFF)

# The set of languages for which implicit dependencies are needed:
set(CMAKE_DEPENDS_LANGUAGES
  )

# The set of dependency files which are needed:
set(CMAKE_DEPENDS_DEPENDENCY_FILES
  "/work/wt/unity/bu0/src/explore_opt/CMakeFiles/explore_opt.dir/Unity/unity_0_cxx.cxx" "src/explore_opt/CMakeFiles/explore_opt.dir/Unity/unity_0_cxx.cxx.o" "gcc" "src/explore_opt/CMakeFiles/explore_opt.dir/Unity/unity_0_cxx.cxx.o.d"
  )

# Targets to which this target links.
set(CMAKE_TARGET_LINKED_INFO_FILES
  "/work/wt/unity/bu0/src/quad_support/CMakeFiles/quad_support.dir/DependInfo.cmake"
  )

# Fortran module output directory.
set(CMAKE_Fortran_TARGET_MODULE_DIR "")
