# Where the machine's own name does not resolve, ROS cannot contact itself; the loopback name always works.
if [ -z "$ROS_HOSTNAME" ] && [ -z "$ROS_IP" ]; then
  export ROS_HOSTNAME=localhost
fi
