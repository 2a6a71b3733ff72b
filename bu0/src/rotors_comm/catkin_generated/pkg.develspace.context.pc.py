# generated from catkin/cmake/template/pkg.context.pc.in
CATKIN_PACKAGE_PREFIX = ""
PROJECT_PKG_CONFIG_INCLUDE_DIRS = "/work/wt/unity/bu0/devel/include".split(';') if "/work/wt/unity/bu0/devel/include" != "" else []
PROJECT_CATKIN_DEPENDS = "message_runtime;std_msgs;geometry_msgs".replace(';', ' ')
PKG_CONFIG_LIBRARIES_WITH_PREFIX = "".split(';') if "" != "" else []
PROJECT_NAME = "rotors_comm"
PROJECT_SPACE_DIR = "/work/wt/unity/bu0/devel"
PROJECT_VERSION = "0.1.0"
PROJECT_LIB_DIR = "lib"
