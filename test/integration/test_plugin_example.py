#!/usr/bin/python3
"""examples/plugin, built against an installed copy of the simulator only, is loaded by a vehicle that names it and acts as its formula
says."""
import csv
import math
import os
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
BUILD = os.environ.get("QUAD_BUILD") or os.path.join(ROOT, "build")
DRAG_AREA, DENSITY, MASS, GRAVITY = 0.05, 1.225, 0.73103, 9.8


def run(*command, **kwargs):
    answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **kwargs)
    if answer.returncode != 0:
        raise AssertionError("%s:\n%s" % (" ".join(command), answer.stdout))
    return answer.stdout


class PluginExample(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="plugin.")
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.prefix = os.path.join(cls.folder, "install")
        for package in ("quad_support", "quad_sim"):
            run("cmake", "-DCMAKE_INSTALL_PREFIX=" + cls.prefix, "-P",
                os.path.join(BUILD, "src", package, "cmake_install.cmake"))
        cls.library = os.path.join(cls.folder, "build")
        run("cmake", "-S", os.path.join(ROOT, "examples", "plugin"), "-B", cls.library, "-DCMAKE_PREFIX_PATH=" + cls.prefix,
            "-DCMAKE_CXX_COMPILER_LAUNCHER=" + os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", ""))
        with open(os.path.join(cls.library, "CMakeCache.txt")) as cache:
            text = cache.read()
        assert cls.prefix + "/include" in text and cls.prefix + "/lib/libquad_sim.so" in text, "built against something else"
        run("cmake", "--build", cls.library)

    def vehicle(self, filename):
        """The installed Hummingbird with the plugin."""
        with open(os.path.join(self.prefix, "share", "quad_sim", "urdf", "hummingbird.urdf")) as urdf:
            text = urdf.read()
        element = ('<gazebo><plugin name="drag" filename="%s"><dragArea>%g</dragArea></plugin></gazebo></robot>'
                   % (filename, DRAG_AREA))
        path = os.path.join(self.folder, "vehicle.urdf")
        with open(path, "w") as urdf:
            urdf.write(text.replace("</robot>", element))
        return path

    def simulate(self, filename, libraries):
        commands = os.path.join(self.folder, "commands.csv")
        with open(commands, "w") as out:
            out.write("t,w0,w1,w2,w3\n0,0,0,0,0\n")
        environment = dict(os.environ, LD_LIBRARY_PATH=os.pathsep.join([os.path.join(self.prefix, "lib")] + libraries))
        return subprocess.run([os.path.join(self.prefix, "lib", "quad_sim", "quad_sim"), "simulate", "--urdf", self.vehicle(filename),
                               "--commands", commands, "--duration", "2", "--every", "100", "--out",
                               os.path.join(self.folder, "states.csv")],
                              env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def assert_falls_against_the_air(self):
        with open(os.path.join(self.folder, "states.csv")) as states:
            rows = list(csv.DictReader(states))
        # v(t) = v_end tanh(g t / v_end), v_end = sqrt(2 m g / (rho c_d A)). Drag is taken at a step's start: 1 ms late of 1.6 s.
        end = math.sqrt(2 * MASS * GRAVITY / (DENSITY * DRAG_AREA))
        for row in rows:
            self.assertAlmostEqual(float(row["vz"]), -end * math.tanh(GRAVITY * float(row["t"]) / end), delta=1e-3 * end)
        self.assertLess(abs(float(rows[-1]["vz"])), 0.9 * GRAVITY * 2)  # without the plugin it would be 19.6

    def test_by_name(self):
        answer = self.simulate("libbody_drag.so", [self.library])
        self.assertEqual(answer.returncode, 0, answer.stdout)
        self.assert_falls_against_the_air()

    def test_by_path(self):
        answer = self.simulate(os.path.join(self.library, "libbody_drag.so"), [])
        self.assertEqual(answer.returncode, 0, answer.stdout)
        self.assert_falls_against_the_air()

    def test_where_it_is_not_found(self):
        answer = self.simulate("libbody_drag.so", [])
        self.assertEqual(answer.returncode, 2)
        for word in ("vehicle.urdf:", "libbody_drag.so", "built in are", "librotors_gazebo_motor_model.so", "cannot open shared object"):
            self.assertIn(word, answer.stdout)


if __name__ == "__main__":
    unittest.main()
