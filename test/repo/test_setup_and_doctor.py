#!/usr/bin/python3
"""scripts/setup --check and scripts/doctor, in copies of the tree that miss something. Nothing is installed."""
import os
import shutil
import subprocess
import tempfile
import unittest

HERE = os.path.dirname(os.path.realpath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


class Tree(unittest.TestCase):
    """A folder with the scripts, a package that every Debian has, and no PyPI package."""

    def setUp(self):
        self.tree = os.path.realpath(tempfile.mkdtemp(prefix="setup test "))
        self.addCleanup(shutil.rmtree, self.tree, ignore_errors=True)
        shutil.copytree(os.path.join(ROOT, "scripts"), self.path("scripts"))
        self.write("packages.txt", "# needed\nbase-files\n\ndpkg\n")
        self.write("requirements.txt", "")
        self.write(".deps/stamp", "")

    def path(self, name):
        return os.path.join(self.tree, name)

    def write(self, name, content, mode=0o644):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w") as file:
            file.write(content)
        os.chmod(self.path(name), mode)

    def run_it(self, *command, **environment):
        done = subprocess.run([self.path(command[0]), *command[1:]], cwd="/", text=True, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=dict(os.environ, **environment))
        return done.returncode, done.stdout, done.stderr


class Setup(Tree):
    def test_check_of_a_complete_machine(self):
        self.assertEqual(self.run_it("scripts/setup", "--check"), (0, "", ""))

    def test_check_names_each_missing_package(self):
        self.write("packages.txt", "base-files\n# not-this-one\nno-such-package\ndpkg\nnor-this-one\n")
        code, stdout, _ = self.run_it("scripts/setup", "--check")
        self.assertEqual(code, 5)
        self.assertEqual(stdout.splitlines(), ["missing Debian packages: no-such-package nor-this-one",
                                               "to install them: scripts/setup"])

    def test_extras_can_be_left_out(self):
        self.write("packages.txt", "base-files\n# extras: more\n# ... and more\nno-such-package\n")
        self.assertEqual(self.run_it("scripts/setup", "--without-extras", "--check"), (0, "", ""))
        self.assertEqual(self.run_it("scripts/setup", "--without-extras"), (0, "", ""))
        code, stdout, _ = self.run_it("scripts/setup", "--check")
        self.assertEqual(code, 5)
        self.assertIn("no-such-package", stdout)

    def test_check_sees_changed_requirements(self):
        self.write("requirements.txt", "xacro==1.13.3\n")
        code, stdout, _ = self.run_it("scripts/setup", "--check")
        self.assertEqual(code, 5)
        self.assertIn("missing PyPI packages: xacro==1.13.3", stdout)

    def test_does_nothing_when_nothing_is_missing(self):
        before = sorted(os.walk(self.tree))
        self.assertEqual(self.run_it("scripts/setup"), (0, "", ""))
        self.assertEqual(sorted(os.walk(self.tree)), before)

    def pretend(self, **programs):
        """PATH with these shell scripts in front of the real programs; each call is noted in calls.txt."""
        for name, script in programs.items():
            self.write("bin/" + name, '#!/bin/sh\necho "%s $*" >>"%s"\n%s\n' % (name, self.path("calls.txt"), script), 0o755)
        return self.path("bin") + ":" + os.environ["PATH"]

    def calls(self):
        with open(self.path("calls.txt")) as file:
            return [line.split()[:3] for line in file]

    def test_installs_only_what_is_missing_with_sudo(self):
        self.write("packages.txt", "dpkg\nno-such-package\n")
        path = self.pretend(sudo='exec "$@"', id="echo 1000", **{"apt-get": 'case "$*" in *" dpkg"*) exit 9;; esac'})
        code, stdout, stderr = self.run_it("scripts/setup", PATH=path)
        self.assertEqual((code, stdout, stderr), (0, "", "scripts/setup: installing no-such-package\n"))
        self.assertEqual([c[:2] for c in self.calls() if c[0] != "id"],
                         [["sudo", "apt-get"], ["apt-get", "update"], ["sudo", "env"], ["apt-get", "install"]])

    def test_root_needs_no_sudo(self):
        self.write("packages.txt", "no-such-package\n")
        path = self.pretend(sudo="exit 9", id="echo 0", **{"apt-get": ""})
        self.assertEqual(self.run_it("scripts/setup", PATH=path)[0], 0)
        self.assertNotIn("sudo", [c[0] for c in self.calls()])

    def test_failed_installation(self):
        self.write("packages.txt", "no-such-package\n")
        path = self.pretend(id="echo 0", **{"apt-get": "exit 100"})
        code, _, stderr = self.run_it("scripts/setup", PATH=path)
        self.assertEqual(code, 5)
        self.assertIn("run it by hand to see why: apt-get install no-such-package", stderr)

    def test_a_failed_download_leaves_what_was_there(self):
        self.write("requirements.txt", "xacro==1.13.3\n")
        self.write(".deps/python/xacro.py", "")
        code, _, stderr = self.run_it("scripts/setup", PIP_INDEX_URL="http://127.0.0.1:9/", PIP_RETRIES="0",
                                      PIP_CONFIG_FILE="/dev/null", PIP_NO_INDEX="1")
        self.assertEqual(code, 5)
        self.assertIn("pip could not fetch xacro==1.13.3", stderr)
        self.assertTrue(os.path.exists(self.path(".deps/python/xacro.py")))
        self.assertEqual(sorted(os.listdir(self.tree)), [".deps", "packages.txt", "requirements.txt", "scripts"])

    def test_unknown_argument(self):
        self.assertEqual(self.run_it("scripts/setup", "--chekc")[0], 2)


class Doctor(Tree):
    """On the machine of the test itself, which has the packages: it has just built the workspace."""

    def setUp(self):
        super().setUp()
        self.write(".deps/python/xacro.py", "")
        self.write("build/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=%s\n" % self.tree)
        self.write("src/quad_sim/src/a.cpp", "")
        self.write("CMakeLists.txt", "")
        self.write("build/devel/lib/quad_experiment/quad_experiment", "", 0o755)
        self.write("build/devel/etc/catkin/profile.d/50.quad.sh", "")
        self.write("build/.built", "")

    def failures(self, **environment):
        code, stdout, stderr = self.run_it("scripts/doctor", **environment)
        self.assertEqual(stderr, "")
        failures = [line for line in stdout.splitlines() if line.startswith("FAIL")]
        self.assertEqual(stdout.count("to mend: "), len(failures), stdout)     # each says what to do
        self.assertEqual(code, 5 if failures else 0, stdout)
        return "\n".join(failures)

    def test_healthy(self):
        self.assertEqual(self.failures(), "")

    def test_missing_package(self):
        self.write("packages.txt", "no-such-package\n")
        self.assertIn("missing Debian packages: no-such-package", self.failures())

    def test_missing_extras_are_no_failure(self):
        self.write("packages.txt", "# extras\nno-such-package\n")
        self.assertEqual(self.failures(), "")

    def test_missing_xacro(self):
        os.remove(self.path(".deps/python/xacro.py"))
        self.assertIn("xacro", self.failures())

    def test_hidden_ros_python(self):
        self.write("elsewhere/rospy.py", "raise ImportError('hidden')\n")
        self.assertIn("cannot import ROS", self.failures(PYTHONPATH=self.path("elsewhere")))

    def test_no_build(self):
        shutil.rmtree(self.path("build"))
        self.assertIn("not built yet", self.failures())

    def test_incomplete_build(self):
        os.remove(self.path("build/devel/lib/quad_experiment/quad_experiment"))
        self.assertIn("the build is not complete", self.failures())

    def test_old_build(self):
        os.utime(self.path("src/quad_sim/src/a.cpp"), (4e9, 4e9))
        self.assertIn("the build is older than src/quad_sim/src/a.cpp", self.failures())

    def test_moved_folder(self):
        self.write("build/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n")
        self.assertIn("was made for another folder (/elsewhere)", self.failures())

    def test_name_that_does_not_resolve(self):
        self.assertIn("ROS_HOSTNAME=no.such.invalid", self.failures(ROS_HOSTNAME="no.such.invalid"))

    def test_unknown_argument(self):
        self.assertEqual(self.run_it("scripts/doctor", "--fix")[0], 2)


if __name__ == "__main__":
    unittest.main()
