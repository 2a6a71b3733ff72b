# generated from catkin/cmake/template/pkg.context.pc.in
CATKIN_PACKAGE_PREFIX = ""
PROJECT_PKG_CONFIG_INCLUDE_DIRS = "\${prefix}/include".split(';') if "\${prefix}/include" != "" else []
PROJECT_CATKIN_DEPENDS = "quad_support;quad_sim;quad_control;explore_opt".replace(';', ' ')
PKG_CONFIG_LIBRARIES_WITH_PREFIX = "-lquad_experiment".split(';') if "-lquad_experiment" != "" else []
PROJECT_NAME = "quad_experiment"
PROJECT_SPACE_DIR = "/work/wt/unity/bu0/install"
PROJECT_VERSION = "0.1.0"
PROJECT_LIB_DIR = "lib"
