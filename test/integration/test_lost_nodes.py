#!/usr/bin/python3
"""Whatever is lost in the middle of a flight, the runner says what and leaves nothing behind."""
import os
import signal
import time
import unittest

from flights import FlightCase, shipped

LIMIT = 5.0   # [s] from the loss to the runner's end


class LostNodes(FlightCase):
    def setUp(self):
        super().setUp()
        self.write("flight.yaml", shipped("smoke.yaml", ("hold_time: 1.0", "hold_time: 20.0")))

    def disturb(self, disturbance):
        """Calls disturbance(process, nodes) in the middle of a flight of more than 20 s; returns answer and time."""
        process = self.start_over_ros("flight.yaml", "results/run", "--rate", "1")
        nodes = self.wait_for_flight(process, "results/run")
        begin = time.monotonic()
        disturbance(process, nodes)
        answer = self.finish(process, 30)
        self.assert_no_results("results/run")
        return answer, time.monotonic() - begin

    def assert_lost(self, node, name_in_message=None):
        answer, seconds = self.disturb(lambda _, nodes: os.kill(nodes[node], signal.SIGKILL))
        self.assertEqual(answer.code, 5, answer)
        self.assertLess(seconds, LIMIT)
        said = answer.stderr.splitlines()
        self.assertIn(name_in_message or node, said[0])
        self.assertRegex(said[0], "lost|ended without an answer")
        self.assertEqual(len(said), 2, answer)   # what was lost; where the logs are
        self.assertTrue(said[1].startswith("scripts/experiment: logs of this run: "), answer)
        self.assertEqual(answer.stdout, "")

    def test_simulator(self):
        self.assert_lost("gazebo")

    def test_controller(self):
        self.assert_lost("attitude_altitude_controller")

    def test_time_manager(self):
        self.assert_lost("time_manager")

    def test_experiment(self):
        self.assert_lost("experiment", "experiment node")

    def test_master(self):
        self.assert_lost("master")

    def test_a_controller_that_hangs(self):
        answer, seconds = self.disturb(lambda _, nodes: os.kill(nodes["attitude_altitude_controller"], signal.SIGSTOP))
        self.assertEqual(answer.code, 5, answer)
        self.assertLess(seconds, LIMIT + 3.0)    # it had 3 s to answer
        self.assertRegex(answer.stderr.splitlines()[0], "no command stamped .* on /hummingbird/command/motor_speed")

    def test_others_that_hang(self):
        for node in ("gazebo", "time_manager"):
            with self.subTest(node):
                answer, seconds = self.disturb(lambda _, nodes: os.kill(nodes[node], signal.SIGSTOP))
                self.assertEqual(answer.code, 5, answer)
                self.assertLess(seconds, LIMIT + 4.5)    # it had 4.5 s to answer
                self.assertRegex(answer.stderr.splitlines()[0], "/time_manager/advance did not answer within .* hangs")

    def test_interrupts(self):
        for number, expected in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number.name):
                answer, seconds = self.disturb(lambda process, _: process.send_signal(number))
                self.assertEqual((answer.code, answer.stdout), (expected, ""), answer)
                self.assertLess(seconds, LIMIT)
                self.assertEqual(os.listdir(self.path("tmp")), [])


if __name__ == "__main__":
    unittest.main()
