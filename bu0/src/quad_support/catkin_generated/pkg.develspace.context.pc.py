# generated from catkin/cmake/template/pkg.context.pc.in
CATKIN_PACKAGE_PREFIX = ""
PROJECT_PKG_CONFIG_INCLUDE_DIRS = "/work/wt/unity/src/quad_support/include".split(';') if "/work/wt/unity/src/quad_support/include" != "" else []
PROJECT_CATKIN_DEPENDS = "".replace(';', ' ')
PKG_CONFIG_LIBRARIES_WITH_PREFIX = "-lquad_support".split(';') if "-lquad_support" != "" else []
PROJECT_NAME = "quad_support"
PROJECT_SPACE_DIR = "/work/wt/unity/bu0/devel"
PROJECT_VERSION = "0.1.0"
PROJECT_LIB_DIR = "lib"
