#!/usr/bin/python3
"""The experiment from roslaunch, by path and by package name, from devel space and from an installed copy. roslaunch itself
always exits 0: summary.json is the judge."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest

from flights import DEVEL, FlightCase, ROOT, Results, shipped, sourced

BUILD = os.environ.get("QUAD_BUILD") or os.path.join(ROOT, "build")


class Spaces(FlightCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        with open(os.path.join(BUILD, "CMakeCache.txt")) as cache:
            prefix = re.search(r"(?m)^CMAKE_INSTALL_PREFIX:\w+=(.*)$", cache.read()).group(1)
        # Staged elsewhere, not `--prefix`: catkin writes its setup files where it was configured to. Nor can they stand a
        # space in their path.
        stage = tempfile.mkdtemp(prefix="installed.")
        cls.addClassCleanup(shutil.rmtree, stage)
        cls.prefix = stage + prefix
        install = subprocess.run(["cmake", "--install", BUILD], env=dict(os.environ, DESTDIR=stage), stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True)
        if install.returncode != 0:
            raise AssertionError("not installed:\n" + install.stdout)
        cls.installed = sourced(os.path.join(cls.prefix, "setup.sh"), _CATKIN_SETUP_DIR=cls.prefix)

    def setUp(self):
        super().setUp()
        self.write("flight.yaml", shipped("smoke.yaml", ("comparison: [gaussian]", "comparison: []")))
        self.expected = self.results(self.in_process("flight.yaml", "in_process"), "in_process").hashes()

    def roslaunch(self, env, *arguments):
        env = dict(env, ROS_HOME=self.path("ros_home"), ROS_MASTER_URI="http://localhost:11311", PWD=self.folder)
        port = str(20000 + os.getpid() % 20000)
        return self.finish(self.start(["/usr/bin/roslaunch", "-p", port, "--skip-log-check", *arguments], env=env), 60)

    def assert_flies(self, env, *launch, folder):
        """Relative paths mean the caller's folder."""
        answer = self.roslaunch(env, *launch, "config:=flight.yaml", "out:=run")
        self.assertTrue(os.path.exists(self.path("run", "summary.json")), answer)
        self.assertEqual(Results(self.path("run")).hashes(), self.expected)
        used = re.search(r'urdf: "(.*)"', Results(self.path("run")).bytes("config.yaml").decode()).group(1)
        self.assertTrue(os.path.samefile(os.path.commonpath([used, os.path.realpath(folder)]), folder), used)

    def test_devel_by_name(self):
        self.assert_flies(self.environment, "quad_experiment", "experiment.launch", folder=BUILD)

    def test_devel_by_path(self):
        self.assert_flies(self.environment, os.path.join(ROOT, "launch", "experiment.launch"), folder=BUILD)

    def test_installed_by_name(self):
        self.assertNotIn(os.path.realpath(DEVEL), self.installed["CMAKE_PREFIX_PATH"])
        self.assert_flies(self.installed, "quad_experiment", "experiment.launch", folder=self.prefix)

    def test_installed_by_path(self):
        self.assert_flies(self.installed, os.path.join(self.prefix, "share", "quad_experiment", "launch", "experiment.launch"),
                          folder=self.prefix)

    def test_installed_configuration_and_vehicle(self):
        """The shipped configuration beside the shipped launch file: nothing but `out` has to be given."""
        answer = self.roslaunch(self.installed, "quad_experiment", "experiment.launch", "out:=run")
        self.assertTrue(os.path.exists(self.path("run", "summary.json")), answer)
        results = Results(self.path("run"))
        self.assertEqual((results.summary["mode"], results.summary["design"]["T"]), ("lockstep", 370))
        self.assertEqual(results.hashes(), results.summary["log_sha256"])


if __name__ == "__main__":
    unittest.main()
