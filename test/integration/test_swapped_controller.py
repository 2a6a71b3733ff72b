#!/usr/bin/python3
"""Another node in the loop: what it computes is flown, how long it takes is not."""
import os
import unittest

from flights import FlightCase, shipped

LAUNCH = os.path.join(os.path.dirname(os.path.realpath(__file__)), "relayed.launch")


class SwappedController(FlightCase):
    def setUp(self):
        super().setUp()
        self.write("flight.yaml", shipped("smoke.yaml"))
        self.write("short.yaml", shipped("smoke.yaml", ("comparison: [gaussian]", "comparison: []")))

    def relayed(self, config, out, **relay):
        command = [os.path.join(os.path.dirname(LAUNCH), "..", "..", "scripts", "experiment"), "--config", config, "--out", out,
                   "--launch", LAUNCH]
        env = dict(self.environment, **{"RELAY_" + k: str(v) for k, v in relay.items()})
        return self.finish(self.start(command, env=env))

    def test_what_it_computes_is_flown(self):
        honest = self.results(self.in_process("short.yaml", "honest"), "honest")
        relayed = self.results(self.relayed("short.yaml", "relayed"), "relayed")
        faster = self.results(self.relayed("short.yaml", "faster", OFFSET=1.0), "faster")
        self.assertEqual(relayed.hashes(), honest.hashes())
        self.assertNotEqual(faster.hashes()["targeted"], honest.hashes()["targeted"])
        # It is the rotor speeds that differ, by what was added: in the first interval nothing else has changed yet.
        first, altered = (r.rows("targeted/trajectory.csv")[1] for r in (honest, faster))
        for rotor in ("w0", "w1", "w2", "w3"):
            difference = float(altered[rotor]) - float(first[rotor])
            self.assertTrue(0.3 < difference <= 1.5, difference)

    def test_computing_takes_no_simulated_time(self):
        honest = self.results(self.in_process("flight.yaml", "honest"), "honest")
        slow = self.results(self.relayed("flight.yaml", "slow", DELAY=0.05), "slow")
        self.assertEqual(slow.hashes(), honest.hashes())
        intervals = sum(len(slow.rows(flight + "/trajectory.csv")) - 1 for flight in ("targeted", "random"))
        self.assertGreater(slow.summary["wall_seconds"], 0.05 * intervals)   # it did compute

    def test_a_controller_that_does_not_copy_the_stamp(self):
        answer = self.relayed("short.yaml", "results/run", KEEP_STAMP="false")
        self.assertEqual(answer.code, 5, answer)
        self.assertRegex(answer.stderr.splitlines()[0], "no command stamped .* on /hummingbird/command/motor_speed within ")
        self.assert_no_results("results/run")


if __name__ == "__main__":
    unittest.main()
