#!/usr/bin/python3
"""scripts/experiment with the real roslaunch and launch file, but programs that only pretend to be nodes."""
import glob
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.realpath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.dirname(HERE))
import marked_processes  # noqa: E402

PROGRAMS = ("quad_sim/quad_sim_node", "quad_control/attitude_altitude_controller_node",
            "quad_control/time_manager_node", "quad_experiment/quad_experiment_node", "quad_experiment/quad_experiment",
            "quad_experiment/monitor")
CONFIG = "vehicle:\n  namespace: bee\ntiming:\n  mode: lockstep\n"


class Runner(unittest.TestCase):
    def setUp(self):
        self.tree = os.path.realpath(tempfile.mkdtemp(prefix="runner test "))   # with a space, as home folders have
        self.addCleanup(shutil.rmtree, self.tree, ignore_errors=True)
        for folder in ("scripts", "pids", "tmp"):
            os.mkdir(self.path(folder))
        shutil.copy(os.path.join(ROOT, "scripts", "experiment"), self.path("scripts/experiment"))
        shutil.copytree(os.path.join(ROOT, "scripts", "quad_runner"), self.path("scripts/quad_runner"))
        shutil.copytree(os.path.join(ROOT, "launch"), self.path("launch"))
        devel = self.path("build/devel")
        for program in PROGRAMS:
            package = program.split("/")[0]
            os.makedirs(os.path.join(devel, "lib", package), exist_ok=True)
            shutil.copy(os.path.join(HERE, "fake_node.py"), os.path.join(devel, "lib", program))
            os.chmod(os.path.join(devel, "lib", program), 0o755)
            os.makedirs(os.path.join(devel, "share", package), exist_ok=True)
            with open(os.path.join(devel, "share", package, "package.xml"), "w") as manifest:
                manifest.write("<package><name>%s</name><version>0.0.0</version><description/>"
                               "<maintainer email='a@b.c'>a</maintainer><license>BSD</license></package>" % package)
        with open(os.path.join(devel, ".catkin"), "w"):
            pass
        with open(os.path.join(devel, "setup.sh"), "w") as setup:
            setup.write('export CMAKE_PREFIX_PATH="%s:/usr" ROS_PACKAGE_PATH="%s/share:/usr/share" '
                        'PYTHONPATH=/usr/lib/python3/dist-packages\n' % (devel, devel))
        with open(self.path("config.yaml"), "w") as config:
            config.write(CONFIG)
        self.out = self.path("results/run")

    def path(self, name):
        return os.path.join(self.tree, name)

    def wrap(self, program, script):
        """Puts a shell script of this name first in the workspace's PATH."""
        folder = self.path("build/devel/bin")
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, program), "w") as file:
            file.write("#!/bin/sh\n%s\n" % script)
        os.chmod(os.path.join(folder, program), 0o755)
        with open(self.path("build/devel/setup.sh"), "a") as setup:
            setup.write('export PATH="%s:$PATH"\n' % folder)

    def start(self, *arguments, stderr=subprocess.PIPE, environment=(), before=None, **fakes):
        env = dict(os.environ, FAKE_PIDS=self.path("pids"), TMPDIR=self.path("tmp"))
        for name in ("CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH", "ROS_MASTER_URI", "PYTHONPATH"):
            env.pop(name, None)     # as in a shell that has sourced nothing
        env.update({"FAKE_" + name: task for name, task in fakes.items()}, **dict(environment))
        return subprocess.Popen([self.path("scripts/experiment"), "--config", "config.yaml", "--out", "results/run",
                                 *arguments], cwd=self.tree, env=env, stdin=subprocess.DEVNULL, text=True,
                                stdout=subprocess.PIPE, stderr=stderr, preexec_fn=before)

    def finish(self, process, limit=30):
        """(exit code, stdout, stderr); nothing that was started may be left then."""
        try:
            stdout, stderr = process.communicate(timeout=limit)
        finally:
            process.kill()
        left = processes_with(self.path("pids"))
        for pid in left:
            os.kill(pid, signal.SIGKILL)
        self.assertEqual(left, {}, "processes outlived the runner; it said: %s" % stderr)
        return process.returncode, stdout, stderr

    def run_it(self, *arguments, **fakes):
        return self.finish(self.start(*arguments, **fakes))

    def wait_for(self, *names):
        """Waits until these nodes run; returns the process id of the first."""
        end = time.monotonic() + 20
        while time.monotonic() < end:
            found = [glob.glob(self.path("pids/%s.*" % glob.escape(name))) for name in names]
            if all(found):
                return int(found[0][0].rpartition(".")[2])
            time.sleep(0.02)
        self.fail("%s did not start" % (names,))

    def assert_logs_kept(self, stderr):
        folder = re.search(r"logs of this run: (.*)", stderr).group(1)
        self.assertTrue(glob.glob(os.path.join(glob.escape(folder), "*", "roslaunch.log")), stderr)

    def assert_nothing_left(self):
        self.assertEqual(os.listdir(self.path("tmp")), [])

    # --- answers

    def test_done(self):
        code, stdout, stderr = self.run_it("--mode", "lockstep", "--rate", "2.5", experiment="answer:0")
        self.assertEqual((code, stdout, stderr), (0, "thesis | ours\nresults: results/run\n", ""))
        with open(os.path.join(self.out, "summary.json")) as summary:
            self.assertEqual(json.load(summary)["arguments"],
                             {"config": self.path("config.yaml"), "mode": "lockstep", "rate": 2.5, "force": False})
        self.assert_nothing_left()

    def test_namespace_comes_from_the_configuration(self):
        process = self.start()
        self.wait_for("attitude_altitude_controller", "experiment")
        arguments = [line for line in processes_with(self.path("pids")).values() if "attitude_altitude" in line]
        process.send_signal(signal.SIGTERM)
        self.finish(process)
        self.assertIn("bee-attitude_altitude_controller", arguments[0])   # in the name of its log file

    def test_negative_answer_still_prints_the_table(self):
        code, stdout, stderr = self.run_it(experiment="answer:3:condition not met")
        self.assertEqual((code, stdout), (3, "thesis | ours\nresults: results/run\n"))
        self.assertEqual(stderr, "scripts/experiment: condition not met\n")
        self.assert_nothing_left()

    def test_failed_simulation_keeps_the_logs(self):
        code, stdout, stderr = self.run_it(experiment="answer:4:reached the ground")
        self.assertEqual((code, stdout), (4, ""))
        self.assertIn("scripts/experiment: reached the ground\n", stderr)
        self.assert_logs_kept(stderr)

    def test_ending_without_an_answer(self):
        code, _, stderr = self.run_it(experiment="exit:0")
        self.assertEqual(code, 5, stderr)
        self.assertIn("ended without an answer (exit code 0)", stderr)
        self.assert_logs_kept(stderr)

    def test_an_orphan_in_its_own_session_is_killed_too(self):
        code, _, stderr = self.run_it(gazebo="orphan", time_manager="deaf", experiment="exit:1")
        self.assertEqual(code, 5, stderr)
        self.wait_for("orphan")   # it had really been there

    def test_a_shell_with_other_settings(self):
        """Another python3 first in PATH, another workspace sourced, another master, a name that does not resolve."""
        os.mkdir(self.path("shims"))
        for name in ("python3", "python"):
            with open(self.path("shims/" + name), "w") as shim:
                shim.write("#!/bin/sh\nexit 9\n")
            os.chmod(self.path("shims/" + name), 0o755)
        code, stdout, stderr = self.run_it(experiment="answer:0", environment={
            "PATH": self.path("shims") + ":" + os.environ["PATH"], "CMAKE_PREFIX_PATH": "/elsewhere/devel:/usr",
            "ROS_PACKAGE_PATH": "/elsewhere/src", "ROS_MASTER_URI": "http://no.such.invalid:1",
            "ROS_HOSTNAME": "no.such.invalid", "ROS_NAMESPACE": "nested"})
        self.assertEqual((code, stdout, stderr), (0, "thesis | ours\nresults: results/run\n", ""))

    # --- bad input

    def test_refused_configuration_leaves_nothing(self):
        code, stdout, stderr = self.run_it(check="2:config.yaml:3: seed = x; must be a whole number")
        self.assertEqual((code, stdout), (2, ""))
        self.assertEqual(stderr, "scripts/experiment: config.yaml:3: seed = x; must be a whole number\n")
        self.assertFalse(os.path.exists(self.path("results")))
        self.assert_nothing_left()

    def test_existing_results_need_force(self):
        self.assertEqual(self.run_it(experiment="answer:0")[0], 0)
        code, _, stderr = self.run_it(experiment="answer:0")
        self.assertEqual(code, 2)
        self.assertIn("results/run: exists already", stderr)
        self.assertEqual(self.run_it("--force", experiment="answer:0")[0], 0)

    def test_force_does_not_replace_other_folders(self):
        os.makedirs(self.out)
        with open(os.path.join(self.out, "letter.txt"), "w"):
            pass
        code, _, stderr = self.run_it("--force", experiment="answer:0")
        self.assertEqual(code, 2)
        self.assertIn("holds other files", stderr)
        self.assertEqual(os.listdir(self.out), ["letter.txt"])

    def test_rate_needs_lockstep(self):
        code, _, stderr = self.run_it("--mode", "wallclock", "--rate", "1")
        self.assertEqual(code, 2)
        self.assertIn("leave --rate out", stderr)

    def test_arguments_are_checked(self):
        for wrong in (["--mode", "fast"], ["--rate", "-1"], ["--rate", "nan"], ["--timeout", "-3"], ["--launch", "none.launch"], ["--speed"]):
            with self.subTest(wrong):
                self.assertEqual(self.run_it(*wrong)[0], 2)

    # --- the environment fails

    def test_timeout(self):
        code, _, stderr = self.run_it("--timeout", "3", gazebo="deaf", experiment="partial")
        self.assertEqual(code, 5)
        self.assertIn("not finished after 3 s", stderr)
        self.assertEqual(os.listdir(self.path("results")), [], "half-written results are left")

    def test_any_lost_node_ends_the_run(self):
        for name in ("gazebo", "attitude_altitude_controller", "time_manager", "experiment"):
            with self.subTest(name):
                self.setUp()
                process = self.start(experiment="partial", gazebo="deaf", time_manager="deaf")
                self.wait_for("writing", "gazebo", "time_manager", "attitude_altitude_controller")
                begin = time.monotonic()
                os.kill(self.wait_for(name), signal.SIGKILL)
                code, _, stderr = self.finish(process)
                self.assertLess(time.monotonic() - begin, 5.0)
                self.assertEqual(code, 5, stderr)
                self.assertIn("SIGKILL", stderr)
                self.assertIn(name, stderr.splitlines()[0])
                self.assertEqual(os.listdir(self.path("results")), [], "half-written results are left")

    def test_lost_master_rosout_or_roslaunch_ends_the_run(self):
        for name, pattern in (("master", "rosmaster"), ("rosout", "rosout/rosout"), ("roslaunch", "experiment.launch")):
            with self.subTest(name):
                self.setUp()
                process = self.start(experiment="partial")
                self.wait_for("writing", "gazebo", "time_manager", "attitude_altitude_controller")
                pid = next(pid for pid, line in processes_with(self.path("pids")).items()
                           if pattern in line and "scripts/experiment" not in line)
                begin = time.monotonic()
                os.kill(pid, signal.SIGKILL)
                code, _, stderr = self.finish(process)
                self.assertLess(time.monotonic() - begin, 5.0)
                self.assertEqual(code, 5, stderr)
                self.assertIn("%s was lost" % name, stderr.splitlines()[0])
                self.assertEqual(os.listdir(self.path("results")), [], "half-written results are left")

    def test_experiment_ended_from_outside(self):
        code, _, stderr = self.run_it(experiment="answer:143:interrupted")
        self.assertEqual(code, 5)
        self.assertIn("the experiment node was ended from outside (killed by SIGTERM)", stderr)

    def test_missing_program(self):
        os.remove(self.path("build/devel/lib/quad_sim/quad_sim_node"))
        code, _, stderr = self.run_it()
        self.assertEqual(code, 5)
        self.assertIn("quad_sim/quad_sim_node", stderr)
        self.assertIn("make build", stderr)

    def test_workspace_not_built(self):
        shutil.rmtree(self.path("build"))
        code, _, stderr = self.run_it()
        self.assertEqual(code, 5)
        self.assertIn("make build", stderr)

    def test_taken_port_is_changed(self):
        """The first master finds its port taken, the second one is the real one."""
        self.wrap("rosmaster", 'if mkdir "$FAKE_PIDS/first" 2>/dev/null; then\n'
                  '  echo "OSError: [Errno 98] Address already in use" >&2; exec sleep 60\nfi\nexec /usr/bin/rosmaster "$@"')
        code, stdout, stderr = self.run_it(experiment="answer:0")
        self.assertEqual((code, stderr), (0, ""))
        self.assertTrue(os.path.isdir(self.path("pids/first")))

    def test_roslaunch_refuses(self):
        with open(self.path("launch/experiment.launch"), "w") as launch:
            launch.write("<launch><node/></launch>")
        code, _, stderr = self.run_it()
        self.assertEqual(code, 5)
        self.assertIn("roslaunch refused to start", stderr)

    def test_a_launch_file_that_is_none(self):
        code, _, stderr = self.run_it("--launch", "config.yaml")
        self.assertEqual(code, 2, stderr)
        self.assertRegex(stderr.splitlines()[0], r"^scripts/experiment: --launch config\.yaml: roslaunch refused to start: .*XML")

    def test_logs_that_cannot_be_written(self):
        """As on a full disk: files may not grow far."""
        code, _, stderr = self.run_it(experiment="answer:0",
                                      before=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512)))
        self.assertEqual(code, 5, stderr)
        self.assertRegex(stderr.splitlines()[0], r"; nothing can be written into \S.* \(File too large\): free some space, or .* TMPDIR$")

    def test_killed_runner_takes_its_nodes_along(self):
        process = self.start(gazebo="deaf")
        self.wait_for("gazebo", "time_manager", "experiment")
        process.kill()
        process.communicate()
        end = time.monotonic() + 8   # roslaunch asks twice, a second each
        while processes_with(self.path("pids")) and time.monotonic() < end:
            time.sleep(0.1)
        self.assertEqual(processes_with(self.path("pids")), {})

    def test_parallel_runs_do_not_meet(self):
        runs = [self.start("--out", "results/%d" % i, experiment="answer:0") for i in range(3)]
        outputs = [run.communicate(timeout=60) for run in runs]
        self.assertEqual([run.returncode for run in runs], [0, 0, 0], outputs)

    # --- on a terminal

    def test_the_monitor_gets_the_terminal(self):
        ours, theirs = os.openpty()
        self.addCleanup(os.close, ours)
        process = self.start(stderr=theirs)
        name = os.ttyname(theirs)
        os.close(theirs)
        self.wait_for("monitor", "experiment")
        arguments = [line for line in processes_with(self.path("pids")).values() if "/monitor " in line]
        process.send_signal(signal.SIGINT)
        self.assertEqual(self.finish(process)[0], 130)
        self.assertIn(" %s " % name, arguments[0])

    # --- interrupted

    def test_interrupts(self):
        for number, expected in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number.name):
                self.setUp()
                process = self.start(experiment="partial", gazebo="deaf")
                self.wait_for("writing", "gazebo")
                process.send_signal(number)
                code, stdout, stderr = self.finish(process)
                self.assertEqual((code, stdout), (expected, ""), stderr)
                self.assertEqual(os.listdir(self.path("results")), [], "half-written results are left")
                self.assert_nothing_left()

    def test_interrupt_during_start(self):
        for delay in (0.05, 0.2, 0.5, 0.8):
            with self.subTest(delay):
                process = self.start()
                time.sleep(delay)
                process.send_signal(signal.SIGINT)
                code, _, stderr = self.finish(process)
                # Before the program's first line it is Python that answers, in its own ways; from there on it would name the line.
                starting = code == 1 and ("Failed to import the site module" in stderr or stderr == "KeyboardInterrupt\n")
                self.assertTrue(starting or code in (130, -signal.SIGINT), (code, stderr))
                self.assert_nothing_left()


def processes_with(folder):
    """All that the runner of this test has started."""
    return marked_processes.processes_with("FAKE_PIDS", folder)


if __name__ == "__main__":
    unittest.main()
