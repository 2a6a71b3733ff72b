#!/usr/bin/python3
"""Waits until waypoint_node has judged the flight. For waypoints.test."""
import sys
import time
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry
from std_msgs.msg import UInt32


class WatchWaypoints(unittest.TestCase):
    def test_both_are_reached(self):
        reached, places = [], []
        rospy.Subscriber("/hummingbird/waypoints_reached", UInt32, lambda m: reached.append(m.data), queue_size=10)
        rospy.Subscriber("/hummingbird/odometry_sensor1/odometry", Odometry, lambda m: places.append(m), queue_size=1)
        end = time.monotonic() + 80
        while (not reached or reached[-1] < 2) and time.monotonic() < end:
            time.sleep(0.1)
        self.assertEqual(reached[-1:], [2])
        p = places[-1].pose.pose.position
        # waypoint_node calls 0.15 m reached; it may have drifted by a little since.
        for got, wanted in ((p.x, 1), (p.y, 0.5), (p.z, 1.5)):
            self.assertAlmostEqual(got, wanted, delta=0.2)


if __name__ == "__main__":
    rospy.init_node("watch_waypoints", disable_rostime=True)
    rostest.rosrun("quad_tests", "waypoints", WatchWaypoints, sys.argv)
