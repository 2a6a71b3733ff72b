"""What the tests of the whole experiment share: the built programs, configurations with changes, what runs leave behind."""
import csv
import glob
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "test"))
import marked_processes  # noqa: E402

DEVEL = os.environ.get("QUAD_DEVEL") or os.path.join(ROOT, "build", "devel")
RUNNER = os.path.join(ROOT, "scripts", "experiment")
MARK = "QUAD_TEST_RUN"   # in the environment of everything a test starts
FROM_THE_CALLER = ("ROS_MASTER_URI", "ROS_HOSTNAME", "ROS_IP", "ROS_NAMESPACE", "ROS_HOME", "ROS_LOG_DIR")


def program(package, name):
    return os.path.join(DEVEL, "lib", package, name)


def sourced(setup, **variables):
    """The environment of a shell of the user's, after `. setup`."""
    env = {k: v for k, v in os.environ.items() if k not in FROM_THE_CALLER + (
        "CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH", "LD_LIBRARY_PATH", "PYTHONPATH", "PKG_CONFIG_PATH", "ROSLISP_PACKAGE_DIRECTORIES")}
    env.update(variables, PATH="/usr/bin:/bin")
    out = subprocess.run(["/bin/sh", "-c", '. "$1" >&2 && exec env -0', "sh", setup], env=env, check=True,
                         stdout=subprocess.PIPE).stdout
    return dict(entry.split("=", 1) for entry in os.fsdecode(out).split("\0") if "=" in entry)


def shipped(name, *changes):
    """The text of config/<name>, each (old, new) replaced; what does not stand there exactly once is an error of the test."""
    with open(os.path.join(ROOT, "config", name), encoding="utf-8") as file:
        text = file.read()
    for old, new in changes:
        if text.count(old) != 1:
            raise AssertionError("'%s' stands %d times in %s" % (old, text.count(old), name))
        text = text.replace(old, new)
    return text


def processes_with(mark):
    """Those that a test with this mark has started."""
    return marked_processes.processes_with(MARK, mark)


class Answer:
    """How a program ended."""

    def __init__(self, code, stdout, stderr):
        self.code, self.stdout, self.stderr = code, stdout, stderr

    def __str__(self):
        return "exit code %s\n%s%s" % (self.code, self.stdout, self.stderr)


class Results:
    """A results directory."""

    def __init__(self, path):
        self.path = path

    def json(self, name):
        with open(os.path.join(self.path, name), encoding="utf-8") as file:
            return json.load(file)

    def bytes(self, name):
        with open(os.path.join(self.path, name), "rb") as file:
            return file.read()

    def rows(self, name):
        return list(csv.DictReader(self.bytes(name).decode().splitlines()))

    @property
    def summary(self):
        return self.json("summary.json")

    def hashes(self):
        """SHA-256 of each flight's trajectory.csv, from the files themselves."""
        return {flight: hashlib.sha256(self.bytes(flight + "/trajectory.csv")).hexdigest()
                for flight in ("targeted", "random") if os.path.exists(os.path.join(self.path, flight))}


class FlightCase(unittest.TestCase):
    """A folder of its own for every test; what a test starts has ended when the test does."""
    environment = None

    @classmethod
    def setUpClass(cls):
        FlightCase.environment = FlightCase.environment or sourced(os.path.join(DEVEL, "setup.sh"))

    def setUp(self):
        self.folder = os.path.realpath(tempfile.mkdtemp(prefix="flight test "))   # with a space, as home folders have
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        os.mkdir(self.path("tmp"))
        self.addCleanup(self.end_what_is_left)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def end_what_is_left(self):
        for pid in processes_with(self.folder):
            os.kill(pid, signal.SIGKILL)

    def start(self, command, env=None, **options):
        env = dict(env or self.environment, TMPDIR=self.path("tmp"), **{MARK: self.folder})
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.Popen(command, cwd=self.folder, env=env, text=True, stdin=subprocess.DEVNULL, **options)

    def finish(self, process, limit=120):
        """Waits for the end. Nothing that was started may be left then."""
        try:
            stdout, stderr = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            process.kill()
            self.fail("not finished after %g s" % limit)
        left = processes_with(self.folder)
        self.assertEqual(left, {}, "processes outlived the run, which said: %s" % stderr)
        return Answer(process.returncode, stdout, stderr)

    def start_over_ros(self, config, out, *arguments):
        return self.start([RUNNER, "--config", config, "--out", out, *arguments])

    def over_ros(self, config, out, *arguments, limit=120):
        return self.finish(self.start_over_ros(config, out, *arguments), limit)

    def in_process(self, config, out, *arguments):
        return self.finish(self.start([program("quad_experiment", "quad_experiment"), "run", "--config", config, "--out", out,
                                       *arguments]))

    def results(self, answer, out, codes=(0, 3)):
        self.assertIn(answer.code, codes, answer)
        return Results(self.path(out))

    def assert_no_results(self, out):
        """Neither a results directory nor the beginnings of one."""
        folder, name = os.path.split(self.path(out))
        left = [e for e in (os.listdir(folder) if os.path.isdir(folder) else []) if e == name or ".partial-" in e]
        self.assertEqual(left, [])

    def wait_for_flight(self, process, out, seconds=30):
        """Waits until the experiment has decided everything and flies; returns {node: process id}."""
        folder, name = os.path.split(self.path(out))
        begun = os.path.join(glob.escape(folder), "." + name + ".partial-*", "provenance.json")
        self.wait_until(lambda: glob.glob(begun), process, seconds)
        time.sleep(0.4)   # into the flight
        self.assertIsNone(process.poll(), "the flight was over before it could be disturbed")
        return self.nodes()

    def wait_until(self, condition, process, seconds=30):
        end = time.monotonic() + seconds
        while not condition():
            if process.poll() is not None or time.monotonic() > end:
                process.kill()
                self.fail("did not come about: %s" % (process.communicate(),))
            time.sleep(0.02)

    def nodes(self):
        found = {}
        for pid, line in processes_with(self.folder).items():
            words = line.split()
            for word in words:
                if word.startswith("__name:="):
                    found[word[len("__name:="):]] = pid
            if any(word.endswith("/rosmaster") for word in words):
                found["master"] = pid
        return found
