# generated from catkin/cmake/template/cfg-extras.context.py.in
DEVELSPACE = 'TRUE' == 'TRUE'
INSTALLSPACE = 'FALSE' == 'TRUE'

CATKIN_DEVEL_PREFIX = '/work/wt/unity/bu0/devel'

CATKIN_GLOBAL_BIN_DESTINATION = 'bin'
CATKIN_GLOBAL_ETC_DESTINATION = 'etc'
CATKIN_GLOBAL_INCLUDE_DESTINATION = 'include'
CATKIN_GLOBAL_LIB_DESTINATION = 'lib'
CATKIN_GLOBAL_LIBEXEC_DESTINATION = 'lib'
CATKIN_GLOBAL_PYTHON_DESTINATION = 'lib/python3/dist-packages'
CATKIN_GLOBAL_SHARE_DESTINATION = 'share'

CATKIN_PACKAGE_BIN_DESTINATION = 'lib/quad_support'
CATKIN_PACKAGE_ETC_DESTINATION = 'etc/quad_support'
CATKIN_PACKAGE_INCLUDE_DESTINATION = 'include/quad_support'
CATKIN_PACKAGE_LIB_DESTINATION = 'lib'
CATKIN_PACKAGE_LIBEXEC_DESTINATION = 'lib/quad_support'
CATKIN_PACKAGE_PYTHON_DESTINATION = 'lib/python3/dist-packages/quad_support'
CATKIN_PACKAGE_SHARE_DESTINATION = 'share/quad_support'

CMAKE_BINARY_DIR = '/work/wt/unity/bu0'
CMAKE_CURRENT_BINARY_DIR = '/work/wt/unity/bu0/src/quad_support'
CMAKE_CURRENT_SOURCE_DIR = '/work/wt/unity/src/quad_support'
CMAKE_INSTALL_PREFIX = '/work/wt/unity/bu0/install'
CMAKE_SOURCE_DIR = '/work/wt/unity'

PKG_CMAKE_DIR = '/work/wt/unity/bu0/devel/share/quad_support/cmake'

PROJECT_NAME = 'quad_support'
PROJECT_BINARY_DIR = '/work/wt/unity/bu0/src/quad_support'
PROJECT_SOURCE_DIR = '/work/wt/unity/src/quad_support'
