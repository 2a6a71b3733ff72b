# generated from catkin/cmake/template/pkg.context.pc.in
CATKIN_PACKAGE_PREFIX = ""
PROJECT_PKG_CONFIG_INCLUDE_DIRS = "/work/wt/unity/bu0/devel/include;/work/wt/unity/src/quad_control/include".split(';') if "/work/wt/unity/bu0/devel/include;/work/wt/unity/src/quad_control/include" != "" else []
PROJECT_CATKIN_DEPENDS = "quad_support;quad_sim;message_runtime;nav_msgs;mav_msgs".replace(';', ' ')
PKG_CONFIG_LIBRARIES_WITH_PREFIX = "-lquad_control".split(';') if "-lquad_control" != "" else []
PROJECT_NAME = "quad_control"
PROJECT_SPACE_DIR = "/work/wt/unity/bu0/devel"
PROJECT_VERSION = "0.1.0"
PROJECT_LIB_DIR = "lib"
