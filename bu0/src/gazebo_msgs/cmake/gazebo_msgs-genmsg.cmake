# generated from genmsg/cmake/pkg-genmsg.cmake.em

message(STATUS "gazebo_msgs: 7 messages, 14 services")

set(MSG_I_FLAGS "-Igazebo_msgs:/work/wt/unity/src/gazebo_msgs/msg;-Istd_msgs:/usr/share/std_msgs/cmake/../msg;-Igeometry_msgs:/usr/share/geometry_msgs/msg")

# Find all generators
find_package(gencpp REQUIRED)
find_package(genlisp REQUIRED)
find_package(genpy REQUIRED)

add_custom_target(gazebo_msgs_generate_messages ALL)

# verify that message/service dependencies have not changed since configure



get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:geometry_msgs/Quaternion"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:geometry_msgs/Quaternion"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:geometry_msgs/Quaternion"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:geometry_msgs/Quaternion"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg" ""
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg" "std_msgs/Header:gazebo_msgs/SensorPerformanceMetric"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg" ""
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv" "geometry_msgs/Vector3:geometry_msgs/Point:geometry_msgs/Wrench"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv" "geometry_msgs/Quaternion:geometry_msgs/Point:geometry_msgs/Pose"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:gazebo_msgs/LinkState:geometry_msgs/Quaternion"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:geometry_msgs/Quaternion:std_msgs/Header"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv" "geometry_msgs/Vector3:gazebo_msgs/ODEPhysics"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv" ""
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:gazebo_msgs/LinkState:geometry_msgs/Quaternion"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv" "geometry_msgs/Pose:geometry_msgs/Twist:geometry_msgs/Point:geometry_msgs/Vector3:gazebo_msgs/ModelState:geometry_msgs/Quaternion"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv" "geometry_msgs/Vector3:gazebo_msgs/ODEPhysics"
)

get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv" NAME_WE)
add_custom_target(_gazebo_msgs_generate_messages_check_deps_${_filename}
  COMMAND ${CATKIN_ENV} ${PYTHON_EXECUTABLE} ${GENMSG_CHECK_DEPS_SCRIPT} "gazebo_msgs" "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv" "geometry_msgs/Quaternion:geometry_msgs/Point:geometry_msgs/Pose"
)

#
#  langs = gencpp;genlisp;genpy
#

### Section generating for lang: gencpp
### Generating Messages
_generate_msg_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/std_msgs/cmake/../msg/Header.msg;/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)

### Generating Services
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Wrench.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Pose.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/std_msgs/cmake/../msg/Header.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_cpp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Pose.msg"
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
)

### Generating Module File
_generate_module_cpp(gazebo_msgs
  ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
  "${ALL_GEN_OUTPUT_FILES_cpp}"
)

add_custom_target(gazebo_msgs_generate_messages_cpp
  DEPENDS ${ALL_GEN_OUTPUT_FILES_cpp}
)
add_dependencies(gazebo_msgs_generate_messages gazebo_msgs_generate_messages_cpp)

# add dependencies to all check dependencies targets
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_cpp _gazebo_msgs_generate_messages_check_deps_${_filename})

# target for backward compatibility
add_custom_target(gazebo_msgs_gencpp)
add_dependencies(gazebo_msgs_gencpp gazebo_msgs_generate_messages_cpp)

# register target for catkin_package(EXPORTED_TARGETS)
list(APPEND ${PROJECT_NAME}_EXPORTED_TARGETS gazebo_msgs_generate_messages_cpp)

### Section generating for lang: genlisp
### Generating Messages
_generate_msg_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/std_msgs/cmake/../msg/Header.msg;/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)

### Generating Services
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Wrench.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Pose.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/std_msgs/cmake/../msg/Header.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_lisp(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Pose.msg"
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
)

### Generating Module File
_generate_module_lisp(gazebo_msgs
  ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
  "${ALL_GEN_OUTPUT_FILES_lisp}"
)

add_custom_target(gazebo_msgs_generate_messages_lisp
  DEPENDS ${ALL_GEN_OUTPUT_FILES_lisp}
)
add_dependencies(gazebo_msgs_generate_messages gazebo_msgs_generate_messages_lisp)

# add dependencies to all check dependencies targets
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_lisp _gazebo_msgs_generate_messages_check_deps_${_filename})

# target for backward compatibility
add_custom_target(gazebo_msgs_genlisp)
add_dependencies(gazebo_msgs_genlisp gazebo_msgs_generate_messages_lisp)

# register target for catkin_package(EXPORTED_TARGETS)
list(APPEND ${PROJECT_NAME}_EXPORTED_TARGETS gazebo_msgs_generate_messages_lisp)

### Section generating for lang: genpy
### Generating Messages
_generate_msg_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg"
  "${MSG_I_FLAGS}"
  "/usr/share/std_msgs/cmake/../msg/Header.msg;/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_msg_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)

### Generating Services
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Wrench.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Pose.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/std_msgs/cmake/../msg/Header.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv"
  "${MSG_I_FLAGS}"
  ""
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Pose.msg;/usr/share/geometry_msgs/msg/Twist.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg;/usr/share/geometry_msgs/msg/Quaternion.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Vector3.msg;/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)
_generate_srv_py(gazebo_msgs
  "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv"
  "${MSG_I_FLAGS}"
  "/usr/share/geometry_msgs/msg/Quaternion.msg;/usr/share/geometry_msgs/msg/Point.msg;/usr/share/geometry_msgs/msg/Pose.msg"
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
)

### Generating Module File
_generate_module_py(gazebo_msgs
  ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
  "${ALL_GEN_OUTPUT_FILES_py}"
)

add_custom_target(gazebo_msgs_generate_messages_py
  DEPENDS ${ALL_GEN_OUTPUT_FILES_py}
)
add_dependencies(gazebo_msgs_generate_messages gazebo_msgs_generate_messages_py)

# add dependencies to all check dependencies targets
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})
get_filename_component(_filename "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv" NAME_WE)
add_dependencies(gazebo_msgs_generate_messages_py _gazebo_msgs_generate_messages_check_deps_${_filename})

# target for backward compatibility
add_custom_target(gazebo_msgs_genpy)
add_dependencies(gazebo_msgs_genpy gazebo_msgs_generate_messages_py)

# register target for catkin_package(EXPORTED_TARGETS)
list(APPEND ${PROJECT_NAME}_EXPORTED_TARGETS gazebo_msgs_generate_messages_py)



if(gencpp_INSTALL_DIR AND EXISTS ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs)
  # install generated code
  install(
    DIRECTORY ${CATKIN_DEVEL_PREFIX}/${gencpp_INSTALL_DIR}/gazebo_msgs
    DESTINATION ${gencpp_INSTALL_DIR}
  )
endif()
if(TARGET std_msgs_generate_messages_cpp)
  add_dependencies(gazebo_msgs_generate_messages_cpp std_msgs_generate_messages_cpp)
endif()
if(TARGET geometry_msgs_generate_messages_cpp)
  add_dependencies(gazebo_msgs_generate_messages_cpp geometry_msgs_generate_messages_cpp)
endif()

if(genlisp_INSTALL_DIR AND EXISTS ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs)
  # install generated code
  install(
    DIRECTORY ${CATKIN_DEVEL_PREFIX}/${genlisp_INSTALL_DIR}/gazebo_msgs
    DESTINATION ${genlisp_INSTALL_DIR}
  )
endif()
if(TARGET std_msgs_generate_messages_lisp)
  add_dependencies(gazebo_msgs_generate_messages_lisp std_msgs_generate_messages_lisp)
endif()
if(TARGET geometry_msgs_generate_messages_lisp)
  add_dependencies(gazebo_msgs_generate_messages_lisp geometry_msgs_generate_messages_lisp)
endif()

if(genpy_INSTALL_DIR AND EXISTS ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs)
  install(CODE "execute_process(COMMAND \"/usr/bin/python3\" -m compileall \"${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs\")")
  # install generated code
  install(
    DIRECTORY ${CATKIN_DEVEL_PREFIX}/${genpy_INSTALL_DIR}/gazebo_msgs
    DESTINATION ${genpy_INSTALL_DIR}
  )
endif()
if(TARGET std_msgs_generate_messages_py)
  add_dependencies(gazebo_msgs_generate_messages_py std_msgs_generate_messages_py)
endif()
if(TARGET geometry_msgs_generate_messages_py)
  add_dependencies(gazebo_msgs_generate_messages_py geometry_msgs_generate_messages_py)
endif()
