# generated from genmsg/cmake/pkg-genmsg.cmake.em

message(STATUS "quad_sim: 0 messages, 4 services")

set(MSG_I_FLAGS "-Istd_msgs:/usr/share/std_msgs/cmake/../msg;-Igeometry_msgs:/usr/share/geometry_msgs/msg;-Inav_msgs:/usr/share/nav_msgs/msg;-Imav_msgs:/work/wt/unity/src/mav_msgs/msg;-Iactionlib_msgs:/usr/share/actionlib_msgs/msg")

# Find all generators
find_package(gencpp REQUIRED)
find_package(genlisp REQUIRED)
find_package(genpy REQUIRED)

add_custom_target(quad_sim_generate_messages ALL)

# verify that message/service dependencies have not changed since configure



get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/CommandReport.srv" NAME_WE)
add_custom_target(_quad_sim_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "quad_sim" "/work/wt/unity/src/quad_sim/srv/CommandReport.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/RestoreState.srv" NAME_WE)
add_custom_target(_quad_sim_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "quad_sim" "/work/wt/unity/src/quad_sim/srv/RestoreState.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/SaveState.srv" NAME_WE)
add_custom_target(_quad_sim_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "quad_sim" "/work/wt/unity/src/quad_sim/srv/SaveState.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/Step.srv" NAME_WE)
add_custom_target(_quad_sim_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "quad_sim" "/work/wt/unity/src/quad_sim/srv/Step.srv" "std_msgs/Header:geometry_msgs/PoseWithCovariance:geometry_msgs/Twist:nav_msgs/Odometry:geometry_msgs/Point:geometry_msgs/TwistWithCovariance:geometry_msgs/Vector3:geometry_msgs/Quaternion:geometry_msgs/Pose:mav_msgs/Actuators"
)

#
#  langs = gencpp;genlisp;genpy
#

### Section generating for lang: gencpp
### Generating Messages

### Generating Services
_generate_srv_cpp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/CommandReport.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/quad_sim
)
_generate_srv_cpp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/RestoreState.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/quad_sim
)
_generate_srv_cpp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/SaveState.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/quad_sim
)
_generate_srv_cpp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/Step.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/std_msgs/cmake/../msg/Header.msg;/usr/share/geometry_msgs/msg/PoseWithCovariance.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/nav_msgs/msg/Odometry.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/TwistWithCovariance.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Pose.msg;/work/wt/unity/src/mav_msgs/msg/Actuators.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/quad_sim
)

### Generating Module File
_generate_module_cpp(quad_sim
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/quad_sim
  "${ALL_GEN_OUTPUT_FILES_cpp}"
)

add_custom_target(quad_sim_generate_messages_cpp
  DEPENDS ${ALL_GEN_OUTPUT_FILES_cpp}
)
add_dependencies(quad_sim_generate_messages quad_sim_generate_messages_cpp)

# add dependencies to all check dependencies targets
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/CommandReport.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_cpp _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/RestoreState.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_cpp _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/SaveState.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_cpp _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/Step.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_cpp _quad_sim_generate_messages_check_deps_${_filename})

# target for backward compatibility
add_custom_target(quad_sim_gencpp)
add_dependencies(quad_sim_gencpp quad_sim_generate_messages_cpp)

# register target for catkin_package(EXPORTED_TARGETS)
list(APPEND ${PROJECT_NAME}_EXPORTED_TARGETS quad_sim_generate_messages_cpp)

### Section generating for lang: genlisp
### Generating Messages

### Generating Services
_generate_srv_lisp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/CommandReport.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/quad_sim
)
_generate_srv_lisp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/RestoreState.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/quad_sim
)
_generate_srv_lisp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/SaveState.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/quad_sim
)
_generate_srv_lisp(quad_sim
  "/work/wt/unity/src/quad_sim/srv/Step.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/std_msgs/cmake/../msg/Header.msg;/usr/share/geometry_msgs/msg/PoseWithCovariance.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/nav_msgs/msg/Odometry.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/TwistWithCovariance.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Pose.msg;/work/wt/unity/src/mav_msgs/msg/Actuators.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/quad_sim
)

### Generating Module File
_generate_module_lisp(quad_sim
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/quad_sim
  "${ALL_GEN_OUTPUT_FILES_lisp}"
)

add_custom_target(quad_sim_generate_messages_lisp
  DEPENDS ${ALL_GEN_OUTPUT_FILES_lisp}
)
add_dependencies(quad_sim_generate_messages quad_sim_generate_messages_lisp)

# add dependencies to all check dependencies targets
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/CommandReport.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_lisp _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/RestoreState.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_lisp _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/SaveState.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_lisp _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/Step.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_lisp _quad_sim_generate_messages_check_deps_${_filename})

# target for backward compatibility
add_custom_target(quad_sim_genlisp)
add_dependencies(quad_sim_genlisp quad_sim_generate_messages_lisp)

# register target for catkin_package(EXPORTED_TARGETS)
list(APPEND ${PROJECT_NAME}_EXPORTED_TARGETS quad_sim_generate_messages_lisp)

### Section generating for lang: genpy
### Generating Messages

### Generating Services
_generate_srv_py(quad_sim
  "/work/wt/unity/src/quad_sim/srv/CommandReport.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim
)
_generate_srv_py(quad_sim
  "/work/wt/unity/src/quad_sim/srv/RestoreState.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim
)
_generate_srv_py(quad_sim
  "/work/wt/unity/src/quad_sim/srv/SaveState.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim
)
_generate_srv_py(quad_sim
  "/work/wt/unity/src/quad_sim/srv/Step.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/std_msgs/cmake/../msg/Header.msg;/usr/share/geometry_msgs/msg/PoseWithCovariance.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/nav_msgs/msg/Odometry.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/TwistWithCovariance.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Pose.msg;/work/wt/unity/src/mav_msgs/msg/Actuators.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim
)

### Generating Module File
_generate_module_py(quad_sim
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim
  "${ALL_GEN_OUTPUT_FILES_py}"
)

add_custom_target(quad_sim_generate_messages_py
  DEPENDS ${ALL_GEN_OUTPUT_FILES_py}
)
add_dependencies(quad_sim_generate_messages quad_sim_generate_messages_py)

# add dependencies to all check dependencies targets
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/CommandReport.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_py _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/RestoreState.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_py _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/SaveState.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_py _quad_sim_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/quad_sim/srv/Step.srv" NAME_WE)
add_dependencies(quad_sim_generate_messages_py _quad_sim_generate_messages_check_deps_${_filename})

# target for backward compatibility
add_custom_target(quad_sim_genpy)
add_dependencies(quad_sim_genpy quad_sim_generate_messages_py)

# register target for catkin_package(EXPORTED_TARGETS)
list(APPEND ${PROJECT_NAME}_EXPORTED_TARGETS quad_sim_generate_messages_py)



if(gencpp_INSTALL_DIR AND EXISTS ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/quad_sim)
  # install generated code
  install(
    DIRECTORY ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/quad_sim
    DESTINATION ${gencpp_INSTALL_DIR}
  )
endif()
if(TARGET std_msgs_generate_messages_cpp)
  add_dependencies(quad_sim_generate_messages_cpp std_msgs_generate_messages_cpp)
endif()
if(TARGET geometry_msgs_generate_messages_cpp)
  add_dependencies(quad_sim_generate_messages_cpp geometry_msgs_generate_messages_cpp)
endif()
if(TARGET nav_msgs_generate_messages_cpp)
  add_dependencies(quad_sim_generate_messages_cpp nav_msgs_generate_messages_cpp)
endif()
if(TARGET mav_msgs_generate_messages_cpp)
  add_dependencies(quad_sim_generate_messages_cpp mav_msgs_generate_messages_cpp)
endif()

if(genlisp_INSTALL_DIR AND EXISTS ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/quad_sim)
  # install generated code
  install(
    DIRECTORY ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/quad_sim
    DESTINATION ${genlisp_INSTALL_DIR}
  )
endif()
if(TARGET std_msgs_generate_messages_lisp)
  add_dependencies(quad_sim_generate_messages_lisp std_msgs_generate_messages_lisp)
endif()
if(TARGET geometry_msgs_generate_messages_lisp)
  add_dependencies(quad_sim_generate_messages_lisp geometry_msgs_generate_messages_lisp)
endif()
if(TARGET nav_msgs_generate_messages_lisp)
  add_dependencies(quad_sim_generate_messages_lisp nav_msgs_generate_messages_lisp)
endif()
if(TARGET mav_msgs_generate_messages_lisp)
  add_dependencies(quad_sim_generate_messages_lisp mav_msgs_generate_messages_lisp)
endif()

if(genpy_INSTALL_DIR AND EXISTS ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim)
  install(CODE "execute_process(COMMAND \"/usr/bin/python3\" -m compileall \"${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim\")")
  # install generated code
  install(
    DIRECTORY ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/quad_sim
    DESTINATION ${genpy_INSTALL_DIR}
  )
endif()
if(TARGET std_msgs_generate_messages_py)
  add_dependencies(quad_sim_generate_messages_py std_msgs_generate_messages_py)
endif()
if(TARGET geometry_msgs_generate_messages_py)
  add_dependencies(quad_sim_generate_messages_py geometry_msgs_generate_messages_py)
endif()
if(TARGET nav_msgs_generate_messages_py)
  add_dependencies(quad_sim_generate_messages_py nav_msgs_generate_messages_py)
endif()
if(TARGET mav_msgs_generate_messages_py)
  add_dependencies(quad_sim_generate_messages_py mav_msgs_generate_messages_py)
endif()
