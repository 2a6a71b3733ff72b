# generated from catkin/cmake/template/pkg.context.pc.in
CATKIN_PACKAGE_PREFIX = ""
PROJECT_PKG_CONFIG_INCLUDE_DIRS = "/work/wt/unity/bu0/devel/include;/work/wt/unity/src/quad_sim/include;/work/wt/unity/src/quad_sim/src/ros/include;/usr/include/eigen3".split(';') if "/work/wt/unity/bu0/devel/include;/work/wt/unity/src/quad_sim/include;/work/wt/unity/src/quad_sim/src/ros/include;/usr/include/eigen3" != "" else []
PROJECT_CATKIN_DEPENDS = "quad_support;message_runtime;nav_msgs;mav_msgs".replace(';', ' ')
PKG_CONFIG_LIBRARIES_WITH_PREFIX = "-lquad_sim;-lquad_sim_ros".split(';') if "-lquad_sim;-lquad_sim_ros" != "" else []
PROJECT_NAME = "quad_sim"
PROJECT_SPACE_DIR = "/work/wt/unity/bu0/devel"
PROJECT_VERSION = "0.1.0"
PROJECT_LIB_DIR = "lib"
