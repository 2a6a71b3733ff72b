#!/usr/bin/python3
"""Time management of thesis section 1.2.4 with the whole experiment behind it: real time, so labelled and only loosely bounded."""
import os
import unittest

from flights import FlightCase, ROOT, shipped

SHORT = (("hold_time: 6.0", "hold_time: 1.5"),)


class WallclockExperiment(FlightCase):
    def fly(self, text, *arguments):
        self.write("flight.yaml", text)
        answer = self.over_ros("flight.yaml", "run", *arguments)
        results = self.results(answer, "run")
        self.assertEqual((results.summary["mode"], results.summary["deterministic"]), ("wallclock", False))
        self.assertFalse(results.json("provenance.json")["deterministic"])
        self.assertIn("mode: wallclock (not deterministic)", answer.stdout)
        self.assertEqual(results.summary["log_sha256"]["targeted"], results.hashes()["targeted"])
        return answer, results

    def assert_timed(self, results, dT, hold, samples):
        """Intervals of about the length asked for, and the record they were steered by."""
        time = results.summary["time"]
        self.assertEqual(time["dT_des"], dT)
        self.assertLess(abs(time["mean"] - dT), 0.05 * dT, time)
        self.assertGreater(time["std"], 0.0)   # lock-step would be exact
        rows = results.rows("targeted/trajectory.csv")
        self.assertEqual(sum(row["phase"] == "explore" for row in rows), samples + 1)
        self.assertGreaterEqual(float(next(row["t"] for row in rows if row["phase"] == "explore")), hold)

        timing = results.rows("targeted/timing.csv")
        self.assertEqual([(r["k"], r["t"], r["dT"]) for r in timing], [(r["k"], r["t"], r["dt"]) for r in rows[:-1]])
        estimate, weight = 0.0, 0.0
        for row in timing:   # thesis section 1.2.4
            length, wait, delay = (float(row[key]) for key in ("dT", "dT_ctrl", "service_delay"))
            self.assertAlmostEqual(wait, max(0.0, dT - estimate), 9)
            self.assertAlmostEqual(delay, length - wait, 9)
            weight = 0.94 * weight + 1.0
            estimate += (delay - estimate) / weight
            self.assertAlmostEqual(float(row["estimated_delay"]), estimate, 9)
        delays = time["service_delay"]
        self.assertAlmostEqual(delays["estimated"], estimate, 9)
        self.assertAlmostEqual(delays["mean"], sum(float(r["service_delay"]) for r in timing) / len(timing), 9)

    def test_wallclock_configuration(self):
        answer, results = self.fly(shipped("wallclock.yaml", *SHORT, ("num_samples: 213", "num_samples: 30"),
                                           ("[3, 6, 8, 10]", "[1, 2, 3]"), ("desired_closeness: 100.0", "desired_closeness: 1.0")),
                                   "--mode", "wallclock")
        self.assert_timed(results, 0.15, hold=1.5, samples=30)
        self.assertIn("service delay: mean", answer.stdout)

    def test_lockstep_configuration_on_the_wall_clock(self):
        """--mode reaches the node that makes the time, and the simulated middleware steps aside for the real one."""
        _, results = self.fly(shipped("thesis.yaml", *SHORT, ("num_samples: 370", "num_samples: 30")), "--mode", "wallclock")
        self.assert_timed(results, 0.1, hold=1.5, samples=30)
        self.assertTrue(os.path.exists(os.path.join(results.path, "random", "timing.csv")))
        used = results.bytes("config.yaml").decode()
        for line in ("mode: wallclock", "latency: 0 ", "jitter_std: 0 "):
            self.assertIn(line, used)

    def test_wallclock_configuration_in_lockstep(self):
        self.write("flight.yaml", shipped("wallclock.yaml", *SHORT, ("num_samples: 213", "num_samples: 30"),
                                          ("[3, 6, 8, 10]", "[1, 2, 3]"), ("desired_closeness: 100.0", "desired_closeness: 1.0")))
        results = self.results(self.over_ros("flight.yaml", "run", "--mode", "lockstep"), "run")
        self.assertEqual((results.summary["mode"], results.summary["deterministic"]), ("lockstep", True))
        self.assertEqual({row["dt"] for row in results.rows("targeted/trajectory.csv")[:-1]}, {"0.15"})
        self.assertFalse(os.path.exists(os.path.join(results.path, "targeted", "timing.csv")))
        self.assertIsNone(results.summary["time"]["service_delay"])

    def test_shortest_interval(self):
        answer = self.finish(self.start([os.path.join(ROOT, "scripts", "shortest_interval"), "--duration", "2", "0.1", "0.05"]))
        self.assertIn(answer.code, (0, 3), answer)
        rows = [line.split() for line in answer.stdout.splitlines() if line.startswith("0.")]
        self.assertEqual([row[0] for row in rows], ["0.1000", "0.0500"], answer)
        for row in rows:
            dT, mean, std = map(float, row[:3])
            self.assertLess(abs(mean - dT), 0.1 * dT)
            self.assertGreater(std, 0.0)
            self.assertIn(row[-1], ("yes", "no"))
        self.assertRegex(answer.stdout, r"shortest usable interval: (0\.05|0\.1) s|no usable interval")
        self.assertEqual(answer.code, 3 if "no usable" in answer.stdout else 0)


if __name__ == "__main__":
    unittest.main()
