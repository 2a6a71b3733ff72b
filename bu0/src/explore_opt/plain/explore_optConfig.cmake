# find_package(explore_opt) of a plain CMake project: the target explore_opt::explore_opt. The variables serve catkin
# packages, which may meet this file too.

####### Expanded from @PACKAGE_INIT@ by configure_package_config_file() #######
####### Any changes to this file will be overwritten by the next CMake run ####
####### The input file was explore_optConfig.cmake.in                            ########

get_filename_component(PACKAGE_PREFIX_DIR "${CMAKE_CURRENT_LIST_DIR}/../../../" ABSOLUTE)

macro(set_and_check _var _file)
  set(${_var} "${_file}")
  if(NOT EXISTS "${_file}")
    message(FATAL_ERROR "File or directory ${_file} referenced by variable ${_var} does not exist !")
  endif()
endmacro()

macro(check_required_components _NAME)
  foreach(comp ${${_NAME}_FIND_COMPONENTS})
    if(NOT ${_NAME}_${comp}_FOUND)
      if(${_NAME}_FIND_REQUIRED_${comp})
        set(${_NAME}_FOUND FALSE)
      endif()
    endif()
  endforeach()
endmacro()

####################################################################################
set_and_check(explore_opt_INCLUDE_DIRS "${PACKAGE_PREFIX_DIR}/include")
set(_explore_opt_library "${PACKAGE_PREFIX_DIR}/lib/libexplore_opt.so")
set(_explore_opt_support "${PACKAGE_PREFIX_DIR}/lib/libquad_support.so")
set(explore_opt_LIBRARIES "${_explore_opt_library};${_explore_opt_support}")

# Only now: the configurations of others change PACKAGE_PREFIX_DIR.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(nlohmann_json)

if(NOT TARGET explore_opt::explore_opt)
  add_library(explore_opt::explore_opt SHARED IMPORTED)
  set_target_properties(explore_opt::explore_opt PROPERTIES
    IMPORTED_LOCATION "${_explore_opt_library}"
    INTERFACE_INCLUDE_DIRECTORIES "${explore_opt_INCLUDE_DIRS}"
    INTERFACE_COMPILE_FEATURES cxx_std_17
    INTERFACE_LINK_LIBRARIES "${_explore_opt_support};Eigen3::Eigen;nlohmann_json::nlohmann_json")
endif()
check_required_components(explore_opt)
