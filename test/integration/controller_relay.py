#!/usr/bin/python3
"""Node between controller and simulator: passes rotor speeds on, late or changed. Parameters: ~offset [rad/s] added to
each, ~delay [s] of computing on the wall clock, ~keep_stamp (false: forgets what a controller has to copy)."""
import time

import rospy
from mav_msgs.msg import Actuators


def main():
    rospy.init_node("relay", disable_rostime=True)
    offset, delay = rospy.get_param("~offset", 0.0), rospy.get_param("~delay", 0.0)
    keep_stamp = rospy.get_param("~keep_stamp", True)
    out = rospy.Publisher("command/motor_speed", Actuators, queue_size=10)

    def relay(message):
        end = time.monotonic() + delay
        while time.monotonic() < end:
            pass    # computing, not sleeping
        message.angular_velocities = [w + offset for w in message.angular_velocities]
        if not keep_stamp:
            message.header.stamp = rospy.Time(0)
        out.publish(message)

    rospy.Subscriber("controller/motor_speed", Actuators, relay, queue_size=10, tcp_nodelay=True)
    rospy.spin()


if __name__ == "__main__":
    main()
