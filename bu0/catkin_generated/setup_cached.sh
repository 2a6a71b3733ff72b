#!/usr/bin/env sh
# generated from catkin/python/catkin/environment_cache.py

# based on a snapshot of the environment before and after calling the setup script
# it emulates the modifications of the setup script without recurring computations

# new environment variables
export CMAKE_PREFIX_PATH='/work/wt/unity/bu0/devel'
export LD_LIBRARY_PATH='/work/wt/unity/bu0/devel/lib'
export PYTHONPATH='/work/wt/unity/bu0/devel/lib/python3/dist-packages'
export ROS_DISTRO='Debian'
export ROS_ETC_DIR='//etc/ros'
export ROS_HOSTNAME='localhost'
export ROS_MASTER_URI='http://localhost:11311'
export ROS_PACKAGE_PATH='/work/wt/unity'
export ROS_PYTHON_VERSION='3'
export ROS_VERSION='1'

# modified environment variables
export PKG_CONFIG_PATH='/work/wt/unity/bu0/devel/lib/pkgconfig'