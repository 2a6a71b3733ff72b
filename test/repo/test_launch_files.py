#!/usr/bin/python3
"""What the launch files hand to the nodes, asked of roslaunch; nothing is started."""
import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import yaml

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
LAUNCH = os.path.join(ROOT, "launch")


class LaunchFiles(unittest.TestCase):
    def parameters(self, name, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            env = dict(os.environ, PWD=folder, ROS_HOME=folder, ROS_LOG_DIR=folder)
            dump = subprocess.run(["/usr/bin/roslaunch", "--dump-params", os.path.join(LAUNCH, name), *arguments],
                                  cwd=folder, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual(dump.returncode, 0, dump.stdout + dump.stderr)
            return yaml.safe_load(dump.stdout), folder

    def test_relative_paths_mean_the_callers_folder(self):
        found, folder = self.parameters("experiment.launch", "config:=a/b.yaml", "out:=007")
        self.assertEqual(found["/experiment/out"], folder + "/007")
        for node in ("/experiment", "/gazebo", "/time_manager", "/hummingbird/attitude_altitude_controller"):
            self.assertEqual(found[node + "/config"], folder + "/a/b.yaml")
        found, folder = self.parameters("sim.launch", "config:=a.yaml")
        self.assertEqual(found["/gazebo/config"], folder + "/a.yaml")
        found, folder = self.parameters("replay.launch", "config:=a.yaml", "bag:=b.bag")
        self.assertEqual(found["/hummingbird/attitude_altitude_controller/config"], folder + "/a.yaml")

    def test_absolute_paths_and_values_arrive_unchanged(self):
        found, _ = self.parameters("experiment.launch", "config:=/c d/e.yaml", "out:=/results/true", "mode:=wallclock",
                                   "command_timeout:=7", "rate:=2", "force:=true", "namespace:=bee", "status:=/s", "real_time_factor:=3")
        self.assertTrue(found["/use_sim_time"])
        self.assertEqual({k.rpartition("/")[2]: v for k, v in found.items() if k.startswith("/experiment/")},
                         {"config": "/c d/e.yaml", "out": "/results/true", "mode": "wallclock", "rate": 2.0, "force": True,
                          "status": "/s", "command_timeout": 7.0})
        self.assertEqual(found["/bee/attitude_altitude_controller/config"], "/c d/e.yaml")
        self.assertEqual(found["/time_manager/mode"], "wallclock")
        self.assertEqual({k.rpartition("/")[2]: v for k, v in found.items() if k.startswith("/gazebo/")},
                         {"config": "/c d/e.yaml", "publish_every": 0, "paused": True, "real_time_factor": 3.0})

    def test_defaults(self):
        found, _ = self.parameters("experiment.launch", "out:=/r")
        self.assertTrue(os.path.samefile(os.path.dirname(os.path.dirname(found["/experiment/config"])), ROOT))
        self.assertTrue(os.path.isfile(found["/experiment/config"]))
        self.assertEqual((found["/experiment/mode"], found["/experiment/rate"], found["/experiment/force"]), ("", 0.0, False))

    def test_waypoints(self):
        found, folder = self.parameters("waypoints.launch", "file:=w.txt", "namespace:=bee", "real_time_factor:=2")
        self.assertEqual(found["/bee/waypoints/file"], folder + "/w.txt")
        self.assertIs(found["/gazebo/vehicles/bee/hover"], False)
        self.assertEqual(found["/gazebo/real_time_factor"], 2.0)
        self.assertEqual(found["/gazebo/config"], found["/bee/controller/config"])
        self.assertTrue(os.path.isfile(found["/bee/controller/config"]))
        found, _ = self.parameters("waypoints.launch")
        self.assertTrue(os.path.isfile(found["/hummingbird/waypoints/file"]))

    def test_every_node_but_the_monitor_is_required(self):
        for name in ("experiment.launch", "sim.launch", "waypoints.launch", "headless/roscore.xml"):
            nodes = list(ElementTree.parse(os.path.join(LAUNCH, name)).getroot().iter("node"))
            self.assertTrue(nodes)
            for node in nodes:
                required = node.get("required", "").replace("$(arg required)", "true") == "true"
                self.assertEqual(required, node.get("name") != "monitor", node.get("name"))


if __name__ == "__main__":
    unittest.main()
