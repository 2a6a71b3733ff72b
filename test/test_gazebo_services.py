#!/usr/bin/python3
"""Vehicles that come and go, links and their wrenches, every topic and service. For gazebo_services.test."""
import glob
import math
import os
import sys

import rosgraph
import rospy
import rostest
from gazebo_msgs import msg as gazebo
from gazebo_msgs import srv as ask
from geometry_msgs.msg import Point, Pose, Vector3, Wrench, WrenchStamped
from mav_msgs.msg import Actuators
from std_srvs.srv import Empty

from gazebo_case import G, LEVEL, MASS, GazeboCase, call, eventually, link, plugin, saved, step


class GazeboServices(GazeboCase):
    def test_the_seed_of_the_launch_file_reaches_every_vehicle(self):
        self.assertTrue(self.spawn("bee").success)
        for vehicle in ("hummingbird", "bee"):
            self.assertIn(", seed 7\n", saved(vehicle))

    # All of it.

    def test_every_topic_speaks(self):
        self.assertTrue(self.spawn("moth", added=self.wind_and_bag()).success)
        published, _, _ = rosgraph.Master("/test").getSystemState()
        topics = [t for t, nodes in published if nodes == ["/gazebo"] and not t.startswith("/rosout")]
        self.assertGreaterEqual(len(topics), 20 + 21 + 5)  # of two vehicles, one with wind, and of the world
        heard = set()
        for topic in topics:
            self.listen(topic, rospy.AnyMsg, lambda _, t=topic: heard.add(t))
        eventually(lambda: step(20) and len(heard) == len(topics))
        self.assertEqual(sorted(set(topics) - heard), [])

    def test_every_service_is_documented_and_asked_by_some_test(self):
        self.assertTrue(self.spawn("bee", added=self.wind_and_bag()).success)
        _, _, services = rosgraph.Master("/test").getSystemState()
        offered = {s for s, nodes in services if nodes == ["/gazebo"] and not s.endswith(("get_loggers", "set_logger_level"))}
        self.assertGreaterEqual(len(offered), 24)
        here = os.path.dirname(os.path.realpath(__file__))
        tests = "".join(open(f, encoding="utf-8").read() for f in glob.glob(os.path.join(here, "*.[cp][py]*")))
        with open(os.path.join(here, "..", "docs", "coming_from_rotors.md"), encoding="utf-8") as file:
            page = file.read()
        for service in offered:
            self.assertTrue(service + '"' in tests, service)
            self.assertTrue(service.rsplit("/", 1)[1] + "`" in page, service)

    # Vehicles that come and go.

    def test_a_spawned_vehicle_joins_and_the_others_do_not_notice(self):
        step(50)
        alone_now = saved("hummingbird")
        step(50)
        alone_later, clock = saved("hummingbird"), step(0).stamp
        call("/gazebo/reset_simulation", Empty)
        step(50)
        answer = self.spawn("bee")
        self.assertTrue(answer.success, answer.status_message)
        self.assertEqual(saved("hummingbird"), alone_now)
        self.assertEqual(call("/gazebo/get_world_properties", ask.GetWorldProperties).model_names,
                         ["ground_plane", "hummingbird", "bee"])
        self.assertEqual(step(50).stamp, clock)
        self.assertEqual(saved("hummingbird"), alone_later)
        fallen = call("/gazebo/get_model_state", ask.GetModelState, "bee", "")
        self.assertAlmostEqual(fallen.pose.position.x, 4, delta=1e-9)
        self.assertAlmostEqual(fallen.pose.position.z, 3 - G / 2 * 0.05 ** 2, delta=1e-6)  # rotors at rest: it falls
        self.assertTrue(call("/gazebo/delete_model", ask.DeleteModel, "bee").success)
        self.assertEqual(saved("hummingbird"), alone_later)
        self.assertFalse(call("/gazebo/get_model_state", ask.GetModelState, "bee", "").success)

    def test_a_spawned_vehicle_listens_and_speaks_while_the_physics_runs(self):
        call("/gazebo/unpause_physics", Empty)
        answer = self.spawn("bee", z=10.0, initial_pose=Pose(Point(0, 0, 10), LEVEL), reference_frame="hummingbird")
        self.assertTrue(answer.success, answer.status_message)
        heard = []
        self.listen("/bee/motor_speed", Actuators, heard.append)
        commands = rospy.Publisher("/bee/command/motor_speed", Actuators, queue_size=1, latch=True)
        self.addCleanup(commands.unregister)  # or the next "bee" would hear it too
        commands.publish(angular_velocities=[500] * 4)
        self.assertTrue(eventually(lambda: heard and min(map(abs, heard[-1].angular_velocities)) > 499))
        call("/gazebo/pause_physics", Empty)
        call("/gazebo/reset_simulation", Empty)
        self.assertAlmostEqual(link("bee::base_link").link_state.pose.position.z, 15, delta=0.5)  # 5 m above, where spawned

    def test_what_cannot_be_spawned_or_deleted_says_why(self):
        for fields, words in ((dict(name="hummingbird"), "is there already"),
                              (dict(name="9bee"), "must be a ROS name"),
                              (dict(name="bee", robot_namespace="/wasp"), "must be empty or the model_name"),
                              (dict(name="bee", z=-1.0), "must be >= 0"),
                              (dict(name="bee", reference_frame="wasp"), "no model 'wasp'"),
                              (dict(name="bee", model_xml="<sdf/>"), "no <robot> element"),
                              (dict(name="bee", added=plugin("libnothing.so")), "no plugin is called libnothing.so"),
                              (dict(name="bee", added=plugin("librotors_gazebo_bag_plugin.so")), "linkName is missing"),
                              (dict(name="bee", added=self.wind_and_bag(waitToRecordBag="perhaps")), "must be true or false"),
                              (dict(name="bee", added=self.wind_and_bag(bagFileName="/nowhere/x", waitToRecordBag="false")),
                               "cannot be written")):
            with self.subTest(words=words):
                answer = self.spawn(**fields)
                self.assertFalse(answer.success)
                self.assertIn(words, answer.status_message)
        sdf = call("/gazebo/spawn_sdf_model", ask.SpawnModel, model_name="bee", model_xml="<sdf/>")
        self.assertFalse(sdf.success)
        self.assertIn("spawn_urdf_model", sdf.status_message)
        self.assertIn("the last vehicle", call("/gazebo/delete_model", ask.DeleteModel, "hummingbird").status_message)
        self.assertIn("no model 'wasp'", call("/gazebo/delete_model", ask.DeleteModel, "wasp").status_message)
        self.assertEqual(len(call("/gazebo/get_world_properties", ask.GetWorldProperties).model_names), 2)

    # Links.

    def test_link_states_are_those_of_the_parts(self):
        heard = []
        self.listen("/gazebo/link_states", gazebo.LinkStates, heard.append)
        self.assertTrue(eventually(lambda: step(0) and heard))
        names = heard[-1].name
        self.assertEqual(names[:2], ["ground_plane::link", "hummingbird::hummingbird/base_link"])
        rotor = names.index("hummingbird::hummingbird/rotor_1")
        self.assertAlmostEqual(heard[-1].pose[rotor].position.y, 0.17, delta=1e-6)
        # The joint turns ten times slower than the rotor, counter-clockwise; 465 rad/s carries 0.73 kg to a part in thirty.
        self.assertAlmostEqual(heard[-1].twist[rotor].angular.z, 46, delta=1.5)
        state = link("hummingbird::rotor_1").link_state
        self.assertEqual(state.pose.position.y, heard[-1].pose[rotor].position.y)
        back = link("hummingbird/base_link", "hummingbird::hummingbird/rotor_1").link_state
        self.assertAlmostEqual(math.hypot(back.pose.position.x, back.pose.position.y), 0.17, delta=1e-9)
        self.assertIn("no link 'wing'", link("wing").status_message)

    def test_a_link_takes_the_vehicle_along(self):
        wanted = gazebo.LinkState("hummingbird::hummingbird/odometry_sensor1_link", Pose(Point(1, 2, 7), LEVEL), None, "world")
        wanted.twist = link("hummingbird/base_link").link_state.twist
        wanted.twist.linear.x = 3
        answer = call("/gazebo/set_link_state", ask.SetLinkState, wanted)
        self.assertTrue(answer.success, answer.status_message)
        state = link("hummingbird/base_link").link_state
        self.assertAlmostEqual(state.pose.position.x, 1, delta=1e-12)
        self.assertAlmostEqual(state.twist.linear.x, 3, delta=1e-12)
        publisher = rospy.Publisher("/gazebo/set_link_state", gazebo.LinkState, queue_size=1)
        self.assertTrue(eventually(lambda: publisher.get_num_connections() > 0))
        wanted.pose.position.y = -2
        publisher.publish(wanted)
        self.assertTrue(eventually(lambda: abs(link("hummingbird/base_link").link_state.pose.position.y + 2) < 1e-9))
        wanted.link_name = "hummingbird::rotor_0"
        self.assertIn("fixed to base_link", call("/gazebo/set_link_state", ask.SetLinkState, wanted).status_message)

    def test_properties_are_those_of_the_urdf(self):
        model = call("/gazebo/get_model_properties", ask.GetModelProperties, "hummingbird")
        self.assertEqual(model.canonical_body_name, "hummingbird/base_link")
        self.assertEqual(model.joint_names, ["hummingbird/rotor_%d_joint" % i for i in range(4)])
        self.assertFalse(call("/gazebo/get_model_properties", ask.GetModelProperties, "wasp").success)
        rotor = call("/gazebo/get_link_properties", ask.GetLinkProperties, "hummingbird::hummingbird/rotor_0")
        self.assertEqual(rotor.mass, 0.009)
        self.assertGreater(rotor.izz, rotor.ixx)
        self.assertFalse(call("/gazebo/get_link_properties", ask.GetLinkProperties, "wing").success)
        step(10)
        joint = call("/gazebo/get_joint_properties", ask.GetJointProperties, "hummingbird/rotor_0_joint")
        self.assertEqual(joint.type, joint.CONTINUOUS)
        self.assertAlmostEqual(joint.rate[0], -46, delta=1.5)  # clockwise
        self.assertFalse(call("/gazebo/get_joint_properties", ask.GetJointProperties, "knee").success)

    def push(self, body="hummingbird::base_link", frame="", point=Point(), force=Vector3(), torque=Vector3(), start=0, duration=-1.0):
        return call("/gazebo/apply_body_wrench", ask.ApplyBodyWrench, body, frame, point, Wrench(force, torque),
                    rospy.Time(start), rospy.Duration(duration))

    def test_a_wrench_acts_from_its_start_for_its_duration(self):
        # On a spawned vehicle, whose rotors rest: nothing else pushes sideways, and no air drags.
        self.assertTrue(self.spawn("bee", z=50.0).success)
        self.assertTrue(self.push("bee::base_link", force=Vector3(2, 0, 0), start=0.1, duration=0.05).success)
        self.assertTrue(self.push("bee::base_link", force=Vector3(0, 1, 0)).success)
        step(99)
        self.assertEqual(link("bee::base_link").link_state.twist.linear.x, 0)
        step(101)
        velocity = link("bee::base_link").link_state.twist.linear
        self.assertAlmostEqual(velocity.x, 2 * 0.05 / MASS, delta=1e-9)
        self.assertAlmostEqual(velocity.y, 1 * 0.2 / MASS, delta=1e-9)
        self.assertEqual(link("hummingbird::base_link").link_state.twist.linear.y, 0)
        call("/gazebo/clear_body_wrenches", ask.BodyRequest, "bee::base_link")
        step(100)
        self.assertAlmostEqual(link("bee::base_link").link_state.twist.linear.y, velocity.y, delta=1e-12)
        with self.assertRaises(rospy.ServiceException):
            call("/gazebo/clear_body_wrenches", ask.BodyRequest, "wing")
        self.assertIn("no link 'wing'", self.push("wing").status_message)
        self.assertIn("fixed to base_link", self.push("bee::rotor_0").status_message)
        self.assertIn("finite", self.push("bee::base_link", force=Vector3(math.nan, 0, 0)).status_message)

    def test_a_wrench_off_the_centre_turns_and_is_saved_with_the_world(self):
        self.assertTrue(self.spawn("bee", z=50.0).success)
        self.assertTrue(self.push("bee::base_link", "bee::base_link", Point(0.1, 0, 0), Vector3(0, 0.02, 0), duration=0.1).success)
        before = saved("bee")
        step(50)
        # 0.1 m times 0.02 N on 0.013 kg m² for 0.05 s, to the few per cent to which that inertia is known here.
        self.assertAlmostEqual(link("bee::base_link").link_state.twist.angular.z, 0.002 * 0.05 / 0.0131, delta=5e-4)
        call("/gazebo/reset_simulation", Empty)
        self.assertNotEqual(saved("bee"), before)  # the reset took the push away
        step(50)
        self.assertEqual(link("bee::base_link").link_state.twist.angular.z, 0)

    # Wind.

    def test_external_force_is_the_winds(self):
        self.assertTrue(self.spawn("bee", added=self.wind_and_bag()).success)
        heard = []
        self.listen("/bee/external_force", WrenchStamped, heard.append)
        self.assertTrue(eventually(lambda: step(10) and heard))
        self.assertEqual(heard[-1].wrench.force.x, 0.5)
        self.assertEqual(heard[-1].header.frame_id, "world")


if __name__ == "__main__":
    rospy.init_node("test_gazebo_services", disable_rostime=True)
    rostest.rosrun("quad_tests", "gazebo_services", GazeboServices, sys.argv)
