#!/usr/bin/python3
"""Watches quad_experiment_node fly and judges by what it writes. For experiment_node.test."""
import hashlib
import json
import os
import shutil
import sys
import time
import unittest

import rospy
import rostest
from mav_msgs.msg import Actuators
from nav_msgs.msg import Odometry
from std_msgs.msg import String


class WatchExperiment(unittest.TestCase):
    def test_flies_judges_and_tells(self):
        out = rospy.get_param("~out")   # a new folder
        self.addCleanup(shutil.rmtree, out, ignore_errors=True)
        seen, stamps, commands = [], [], []
        rospy.Subscriber("/experiment/status", String, lambda m: seen.append(json.loads(m.data)), queue_size=100)
        rospy.Subscriber("/hummingbird/odometry_sensor1/odometry", Odometry, lambda m: stamps.append(m.header.stamp), queue_size=1000)
        rospy.Subscriber("/hummingbird/command/motor_speed", Actuators, lambda m: commands.append(m), queue_size=1000)
        end = time.monotonic() + 40
        while not os.path.exists(os.path.join(out, "status.json")) and time.monotonic() < end:
            time.sleep(0.05)
        with open(os.path.join(out, "status.json")) as file:
            status = json.load(file)
        with open(os.path.join(out, "results", "summary.json")) as file:
            summary = json.load(file)
        message = status.pop("message")
        self.assertEqual(status, {"exit_code": summary["exit_code"], "results": os.path.join(out, "results")})
        self.assertRegex(message, "^$" if summary["ok"] else "^the promise was broken: ")
        self.assertIn(summary["exit_code"], (0, 3))
        self.assertEqual(summary["ok"], summary["exit_code"] == 0)
        self.assertEqual(summary["mode"], "lockstep")
        for flight in ("targeted", "random"):
            with open(os.path.join(out, "results", flight, "trajectory.csv"), "rb") as file:
                self.assertEqual(hashlib.sha256(file.read()).hexdigest(), summary["log_sha256"][flight])

        self.assertIn(("random", "explore"), {(s["flight"], s["phase"]) for s in seen})   # the end of the story at least
        self.assertEqual(seen[-1]["phase"], "done")
        self.assertGreater(len(stamps), 20)
        self.assertGreater(len(commands), 20)
        self.assertTrue(all(len(c.angular_velocities) == 4 for c in commands))
        self.assertTrue(set(c.header.stamp for c in commands[:-1]) & set(stamps))   # copied


if __name__ == "__main__":
    rospy.init_node("watch_experiment", disable_rostime=True)
    rostest.rosrun("quad_tests", "experiment_node", WatchExperiment, sys.argv)
