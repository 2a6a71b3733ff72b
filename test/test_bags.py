#!/usr/bin/python3
"""The bags that vehicles record. For gazebo_services.test, the last one by name: it ends the simulator."""
import glob
import os
import signal
import sys
import time
import xmlrpc.client

import rosbag
import rosgraph
import rospy
import rostest
from gazebo_msgs import srv as ask
from geometry_msgs.msg import Point, Pose, PoseStamped
from mav_msgs.msg import Actuators
from rotors_comm.srv import RecordRosbag

from gazebo_case import G, LEVEL, MASS, GazeboCase, call, eventually, link, step


class Bags(GazeboCase):
    def bags(self):
        return sorted(glob.glob(os.path.join(self.folder, "*")))

    def record(self, on):
        return call("/bee/record_rosbag", RecordRosbag, on).success

    def test_a_flight_is_recorded_from_start_to_stop(self):
        self.assertTrue(self.spawn("bee", z=0.1, added=self.wind_and_bag()).success)
        poses = rospy.Publisher("/bee/command/pose", PoseStamped, queue_size=1)
        commands = rospy.Publisher("/bee/command/motor_speed", Actuators, queue_size=1)
        step(20)
        self.assertEqual(self.bags(), [])
        self.assertFalse(self.record(False))
        self.assertTrue(self.record(True))
        self.assertFalse(self.record(True))
        self.assertTrue(eventually(lambda: poses.get_num_connections() > 0 and commands.get_num_connections() > 0))
        poses.publish(PoseStamped())
        commands.publish(angular_velocities=[1, 2, 3, 4])
        self.assertTrue(all(name.endswith(".bag.active") for name in self.bags()))
        for _ in range(20):  # in the world's pace what comes by topic comes in time; in steps it needs wall time
            step(20)
            time.sleep(0.02)
        end = step(0).stamp
        self.assertTrue(self.record(False))
        name, = self.bags()
        self.assertRegex(os.path.basename(name), r"^flight_\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d\.bag$")
        with rosbag.Bag(name) as bag:
            read = {}
            for topic, message, stamp in bag.read_messages():
                read.setdefault(topic, []).append((stamp, message))
        topics = {"/bee/" + t for t in ("ground_truth/pose", "ground_truth/twist", "motor_speed", "wrench", "imu", "external_force",
                                        "wind_speed", "command/pose", "command/motor_speed")}
        self.assertEqual(set(read), topics)
        stamps = [stamp.to_nsec() for stamp, _ in read["/bee/ground_truth/pose"]]
        self.assertEqual(stamps, list(range(30000000, end.to_nsec() + 1, 10000000)))  # from the first instant after 20 ms
        for topic in ("ground_truth/pose", "ground_truth/twist", "motor_speed", "imu"):
            for stamp, message in read["/bee/" + topic]:
                self.assertEqual(stamp, message.header.stamp)
        pose, twist = read["/bee/ground_truth/pose"][-1][1], read["/bee/ground_truth/twist"][-1][1]
        self.assertEqual(pose.header.frame_id, "bee/base_link")
        true = link("bee::base_link").link_state
        self.assertEqual(str(pose.pose), str(true.pose))  # rosbag makes classes of its own
        self.assertEqual(str(twist.twist), str(true.twist))
        # At rest on the ground, which carries it: to what the contact's softness leaves after 0.3 s.
        self.assertAlmostEqual(read["/bee/wrench"][-1][1].wrench.force.z, MASS * G, delta=0.01)
        self.assertIn("bee::hummingbird/base_link--ground_plane", read["/bee/wrench"][-1][1].header.frame_id)
        self.assertEqual(read["/bee/external_force"][-1][1].wrench.force.x, 0.5)
        self.assertEqual(read["/bee/command/motor_speed"][0][1].angular_velocities, (1, 2, 3, 4))
        self.assertTrue(self.record(True))
        step(10)
        self.assertTrue(self.record(False))
        self.assertEqual(len(self.bags()), 2)

    def test_deleting_a_vehicle_completes_its_bag(self):
        self.assertTrue(self.spawn("bee", added=self.wind_and_bag(waitToRecordBag="false", updateRate="1000",
                                                                  bagFileName=os.path.join(self.folder, "deleted"))).success)
        step(30)
        self.assertTrue(call("/gazebo/delete_model", ask.DeleteModel, "bee").success)
        name, = (n for n in self.bags() if "deleted" in n)
        with rosbag.Bag(name) as bag:
            self.assertEqual(bag.get_message_count("/bee/ground_truth/pose"), 30)

    def test_zz_an_interrupted_node_completes_its_bag(self):
        """The last one: no simulator is left afterwards."""
        file = os.path.join(self.folder, "interrupted")
        added = self.wind_and_bag(waitToRecordBag="false", bagFileName=file)
        request = dict(model_name="bee", model_xml=self.urdf.replace("</robot>", added + "</robot>"),
                       initial_pose=Pose(Point(4, 0, 3), LEVEL))
        self.assertTrue(call("/gazebo/spawn_urdf_model", ask.SpawnModel, **request).success)
        step(100)
        uri = rosgraph.Master("/test").lookupNode("/gazebo")
        _, _, pid = xmlrpc.client.ServerProxy(uri).getPid("/test")
        os.kill(pid, signal.SIGINT)
        self.assertTrue(eventually(lambda: glob.glob(file + "_*.bag")))
        with rosbag.Bag(glob.glob(file + "_*.bag")[0]) as bag:
            self.assertEqual(bag.get_message_count("/bee/ground_truth/pose"), 10)


if __name__ == "__main__":
    rospy.init_node("test_bags", disable_rostime=True)
    rostest.rosrun("quad_tests", "recorded_bags", Bags, sys.argv)
