#!/usr/bin/python3
"""The flight's monitor on a pseudo-terminal, beside a real master whose simulated time stands still."""
import fcntl
import json
import os
import select
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest

HERE = os.path.dirname(os.path.realpath(__file__))
MONITOR = os.path.join(os.path.dirname(os.path.dirname(HERE)), "src", "quad_experiment", "scripts", "monitor")
STATUS = {"flight": "targeted", "phase": "explore", "time": 12.34, "duration": 43.0, "z": 4987.125, "zdot": -1.5}
PUBLISHER = """
import sys, time, rospy
from std_msgs.msg import String
rospy.init_node("publisher", disable_rostime=True)
topic = rospy.Publisher("/experiment/status", String, queue_size=10)
while not rospy.is_shutdown():
    for text in sys.argv[1:]:
        topic.publish(text)
    time.sleep(0.002)
"""


class Monitor(unittest.TestCase):
    def setUp(self):
        self.home = tempfile.mkdtemp(prefix="monitor-test.")
        self.addCleanup(shutil.rmtree, self.home, ignore_errors=True)
        with socket.socket() as s:
            s.bind(("127.0.0.1", 0))
            port = s.getsockname()[1]
        self.env = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:%d" % port, ROS_IP="127.0.0.1",
                        ROS_HOME=self.home, ROS_LOG_DIR=self.home)
        self.env.pop("ROS_HOSTNAME", None)
        self.spawn("/usr/bin/rosmaster", "--core", "-p", str(port), stdout=subprocess.DEVNULL)
        end = time.monotonic() + 20
        while subprocess.run(["/usr/bin/rosparam", "set", "/use_sim_time", "true"], env=self.env,
                             stderr=subprocess.DEVNULL).returncode != 0:
            self.assertLess(time.monotonic(), end, "no master")

    def spawn(self, *command, **options):
        process = subprocess.Popen(command, env=self.env, stdin=subprocess.DEVNULL, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def watch(self, arguments, messages, seconds):
        """Runs the monitor on a terminal 60 wide; what it wrote there within `seconds` of its first word."""
        ours, theirs = os.openpty()
        self.addCleanup(os.close, ours)
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 60, 0, 0))
        to_stderr = not arguments
        monitor = self.spawn(MONITOR, "__name:=monitor", *(arguments and [os.ttyname(theirs)]),
                             stderr=theirs if to_stderr else subprocess.DEVNULL)
        os.close(theirs) if to_stderr else self.addCleanup(os.close, theirs)
        self.spawn(sys.executable, "-c", PUBLISHER, *messages)
        written, end = b"", time.monotonic() + 20
        while time.monotonic() < end:
            if select.select([ours], [], [], 0.05)[0]:
                if not written:
                    end = time.monotonic() + seconds
                written += os.read(ours, 4096)
        monitor.send_signal(signal.SIGINT)
        self.assertEqual(monitor.wait(timeout=5), 0)
        while select.select([ours], [], [], 0.05)[0]:
            try:
                more = os.read(ours, 4096)
            except OSError:     # the other side is closed
                break
            written += more
            if not more:
                break
        return written.decode()

    def test_one_line_at_most_ten_times_a_second(self):
        text = self.watch([], ["no JSON", "[1]", json.dumps(STATUS)], seconds=1.5)
        lines = text.strip("\r\n").split("\r\x1b[K")[1:]
        self.assertEqual(set(lines), {("targeted: explore   12.3 of 43.0 s   z   4987.12 m   zdot   -1.50 m/s")[:59]})
        self.assertGreaterEqual(len(lines), 3)
        self.assertLessEqual(len(lines), 18)    # 1.5 s at 10 Hz, the first at once, the last while it ends
        self.assertTrue(text.endswith("\n"))

    def test_clears_a_line_that_is_not_its_own(self):
        text = self.watch(["terminal"], [json.dumps(STATUS)], seconds=0.5)
        self.assertIn("targeted: explore", text)
        self.assertTrue(text.endswith("\r\x1b[K"), repr(text))

    def test_control_characters_are_not_passed_on(self):
        text = self.watch([], [json.dumps(dict(STATUS, flight="\x1b]0;evil\x07"))], seconds=0.3)
        self.assertIn("]0;evil:", text)
        self.assertNotIn("\x07", text)


class WithoutTerminal(unittest.TestCase):
    def test_is_quiet_and_ends(self):
        for arguments in ([], ["/dev/null"], ["/nowhere/pts"]):
            done = subprocess.run([MONITOR, "__name:=monitor", *arguments], stdin=subprocess.DEVNULL, timeout=10,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"", b""))


if __name__ == "__main__":
    unittest.main()
