# generated from catkin/cmake/template/pkg.context.pc.in
CATKIN_PACKAGE_PREFIX = ""
PROJECT_PKG_CONFIG_INCLUDE_DIRS = "/work/wt/unity/src/explore_opt/include".split(';') if "/work/wt/unity/src/explore_opt/include" != "" else []
PROJECT_CATKIN_DEPENDS = "quad_support".replace(';', ' ')
PKG_CONFIG_LIBRARIES_WITH_PREFIX = "-lexplore_opt".split(';') if "-lexplore_opt" != "" else []
PROJECT_NAME = "explore_opt"
PROJECT_SPACE_DIR = "/work/wt/unity/bu0/devel"
PROJECT_VERSION = "0.1.0"
PROJECT_LIB_DIR = "lib"
