# Install script for directory: /work/wt/unity/src/gazebo_msgs

# Set the install prefix
if(NOT DEFINED CMAKE_INSTALL_PREFIX)
  set(CMAKE_INSTALL_PREFIX "/work/wt/unity/bu0/install")
endif()
string(REGEX REPLACE "/$" "" CMAKE_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")

# Set the install configuration name.
if(NOT DEFINED CMAKE_INSTALL_CONFIG_NAME)
  if(BUILD_TYPE)
    string(REGEX REPLACE "^[^A-Za-z0-9_]+" ""
           CMAKE_INSTALL_CONFIG_NAME "${BUILD_TYPE}")
  else()
    set(CMAKE_INSTALL_CONFIG_NAME "Release")
  endif()
  message(STATUS "Install configuration: \"${CMAKE_INSTALL_CONFIG_NAME}\"")
endif()

# Set the component getting installed.
if(NOT CMAKE_INSTALL_COMPONENT)
  if(COMPONENT)
    message(STATUS "Install component: \"${COMPONENT}\"")
    set(CMAKE_INSTALL_COMPONENT "${COMPONENT}")
  else()
    set(CMAKE_INSTALL_COMPONENT)
  endif()
endif()

# Install shared libraries without execute permission?
if(NOT DEFINED CMAKE_INSTALL_SO_NO_EXE)
  set(CMAKE_INSTALL_SO_NO_EXE "1")
endif()

# Is this installation the result of a crosscompile?
if(NOT DEFINED CMAKE_CROSSCOMPILING)
  set(CMAKE_CROSSCOMPILING "FALSE")
endif()

# Set default install directory permissions.
if(NOT DEFINED CMAKE_OBJDUMP)
  set(CMAKE_OBJDUMP "/usr/bin/objdump")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/gazebo_msgs/msg" TYPE FILE FILES
    "/work/wt/unity/src/gazebo_msgs/msg/LinkState.msg"
    "/work/wt/unity/src/gazebo_msgs/msg/LinkStates.msg"
    "/work/wt/unity/src/gazebo_msgs/msg/ModelState.msg"
    "/work/wt/unity/src/gazebo_msgs/msg/ModelStates.msg"
    "/work/wt/unity/src/gazebo_msgs/msg/ODEPhysics.msg"
    "/work/wt/unity/src/gazebo_msgs/msg/PerformanceMetrics.msg"
    "/work/wt/unity/src/gazebo_msgs/msg/SensorPerformanceMetric.msg"
    )
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/gazebo_msgs/srv" TYPE FILE FILES
    "/work/wt/unity/src/gazebo_msgs/srv/ApplyBodyWrench.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/BodyRequest.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/DeleteModel.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/GetJointProperties.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/GetLinkProperties.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/GetLinkState.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/GetModelProperties.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/GetModelState.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/GetPhysicsProperties.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/GetWorldProperties.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/SetLinkState.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/SetModelState.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/SetPhysicsProperties.srv"
    "/work/wt/unity/src/gazebo_msgs/srv/SpawnModel.srv"
    )
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/gazebo_msgs/cmake" TYPE FILE FILES "/work/wt/unity/bu0/src/gazebo_msgs/catkin_generated/installspace/gazebo_msgs-msg-paths.cmake")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/include" TYPE DIRECTORY FILES "/work/wt/unity/bu0/devel/include/gazebo_msgs")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/common-lisp/ros" TYPE DIRECTORY FILES "/work/wt/unity/bu0/devel/share/common-lisp/ros/gazebo_msgs")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  execute_process(COMMAND "/usr/bin/python3" -m compileall "/work/wt/unity/bu0/devel/lib/python3/dist-packages/gazebo_msgs")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages" TYPE DIRECTORY FILES "/work/wt/unity/bu0/devel/lib/python3/dist-packages/gazebo_msgs")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/pkgconfig" TYPE FILE FILES "/work/wt/unity/bu0/src/gazebo_msgs/catkin_generated/installspace/gazebo_msgs.pc")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/gazebo_msgs/cmake" TYPE FILE FILES "/work/wt/unity/bu0/src/gazebo_msgs/catkin_generated/installspace/gazebo_msgs-msg-extras.cmake")
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/gazebo_msgs/cmake" TYPE FILE FILES
    "/work/wt/unity/bu0/src/gazebo_msgs/catkin_generated/installspace/gazebo_msgsConfig.cmake"
    "/work/wt/unity/bu0/src/gazebo_msgs/catkin_generated/installspace/gazebo_msgsConfig-version.cmake"
    )
endif()

if(CMAKE_INSTALL_COMPONENT STREQUAL "Unspecified" OR NOT CMAKE_INSTALL_COMPONENT)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/gazebo_msgs" TYPE FILE FILES "/work/wt/unity/src/gazebo_msgs/package.xml")
endif()

