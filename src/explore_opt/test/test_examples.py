#!/usr/bin/python3
"""The worked examples: the program's as it stands, the library's as a plain CMake project against an installed copy.
Arguments: folder of the build, folder of the program."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PACKAGE = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
BUILD, PROGRAMS = "", ""


class Examples(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="explore_opt_examples.")
        self.addCleanup(shutil.rmtree, self.folder)

    def run_in_folder(self, *command, **environment):
        env = {k: v for k, v in os.environ.items()
               if k not in ("CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH", "LD_LIBRARY_PATH", "DESTDIR")}
        done = subprocess.run(command, cwd=self.folder, env=dict(env, **environment), text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, 0, "%s\n%s" % (" ".join(command), done.stdout))
        return done.stdout

    def test_program(self):
        examples = os.path.join(PACKAGE, "examples")
        output = self.run_in_folder(os.path.join(examples, "flexible_structure.sh"), examples,
                                    PATH=PROGRAMS + ":" + os.environ["PATH"])
        self.assertRegex(output, r"targeted +0\.")
        self.assertTrue(os.path.exists(os.path.join(self.folder, "model.json")))

    def test_library(self):
        with open(os.path.join(BUILD, "CMakeCache.txt")) as cache:
            prefix = re.search(r"(?m)^CMAKE_INSTALL_PREFIX:\w+=(.*)$", cache.read()).group(1)
        stage = os.path.join(self.folder, "stage")
        for package in ("quad_support", "explore_opt"):
            self.run_in_folder("cmake", "--install", os.path.join(BUILD, "src", package), DESTDIR=stage)
        installed = stage + prefix
        source = os.path.join(PACKAGE, "examples", "library")
        configured = self.run_in_folder("cmake", "-S", source, "-B", "build", "-DCMAKE_PREFIX_PATH=" + installed,
                                        "-DCMAKE_BUILD_TYPE=")
        self.assertNotIn("catkin", configured.lower().replace(self.folder.lower(), ""))
        self.run_in_folder("cmake", "--build", "build")
        output = self.run_in_folder(os.path.join(self.folder, "build", "oscillator"))
        self.assertIn("promise kept", output)
        # The installed program needs no environment either.
        program = os.path.join(installed, "lib", "explore_opt", "explore_opt")
        self.assertIn("Subcommands", self.run_in_folder(program, "--help"))


if __name__ == "__main__":
    BUILD, PROGRAMS = (os.path.abspath(path) for path in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
