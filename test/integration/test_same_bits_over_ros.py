#!/usr/bin/python3
"""The experiment over ROS in lock-step is the experiment in one process, bit for bit, whatever else the machine does.

QUAD_LONG_TESTS=1 repeats it twenty times on a quiet and twenty times on a busy machine."""
import os
import subprocess
import unittest

from flights import FlightCase, Results, ROOT, shipped

FLIGHT_KEYS = {"A", "B", "dT_hat", "m_hat", "error_norm", "residual_energy", "G", "lambda_D_bd", "lambda_D_exp", "objective",
               "signal_energy", "gamma_w_exp", "gamma_w_sim", "lambda_min_S", "truth_in_set", "gamma_w_valid", "max_tilt",
               "gamma_w_falsified", "exploration_condition", "objective_met", "min_altitude"}
SUMMARY_KEYS = {
    "": {"ok", "exit_code", "mode", "config_hash", "log_sha256", "design", "flown", "initial", "time", "targeted", "random",
         "wall_seconds"},
    "log_sha256": {"targeted", "random"},
    "design": {"gamma_e", "lower_bound", "gap", "alpha", "phase", "harmonics", "T"},
    "flown": {"signal", "amplitudes", "margin"},
    "initial": {"dT", "m", "error_norm", "lambda_D0", "gamma_w_true", "gamma_w_compensated"},
    "time": {"dT_des", "mean", "std", "max_abs_error"},
    "targeted": FLIGHT_KEYS,
    "random": FLIGHT_KEYS,
}


def without(record, *keys):
    """The record without these keys, at any depth."""
    if not isinstance(record, dict):
        return record
    return {k: without(v, *keys) for k, v in record.items() if k not in keys}


class SameBits(FlightCase):
    def both_ways(self, config):
        answer = self.in_process(config, "in_process")
        alone = self.results(answer, "in_process")
        ros_answer = self.over_ros(config, "ros")
        self.assertEqual(ros_answer.code, answer.code)
        return alone, self.results(ros_answer, "ros")

    def assert_same(self, alone, ros):
        for flight in ("targeted", "random"):
            name = flight + "/trajectory.csv"
            self.assertGreater(len(alone.rows(name)), 10)
            self.assertEqual(ros.bytes(name), alone.bytes(name), name)

    def test_thesis(self):
        config = os.path.join(ROOT, "config", "thesis.yaml")
        alone, ros = self.both_ways(config)
        self.assert_same(alone, ros)

        with self.subTest("summary.json"):
            self.assertEqual((alone.summary["mode"], ros.summary["mode"]), ("in_process", "lockstep"))
            for results in (alone, ros):
                for part, keys in SUMMARY_KEYS.items():
                    self.assertEqual(keys - set(results.summary[part] if part else results.summary), set(), part)
                self.assertEqual(results.summary["log_sha256"], results.hashes())
                self.assertGreater(results.summary["wall_seconds"], 0)
            self.assertEqual(without(ros.summary, "mode", "wall_seconds"), without(alone.summary, "mode", "wall_seconds"))
        with self.subTest("provenance.json, design.json, config.yaml"):
            provenance = ros.json("provenance.json")
            self.assertEqual((provenance["mode"], provenance["deterministic"]), ("lockstep", True))
            self.assertEqual(without(provenance, "mode"), without(alone.json("provenance.json"), "mode"))
            self.assertTrue(all(provenance["inputs_sha256"].values()))
            self.assertEqual(without(ros.json("design.json"), "seconds"), without(alone.json("design.json"), "seconds"))
            self.assertEqual(ros.bytes("config.yaml"), alone.bytes("config.yaml"))

        with self.subTest("repeated"):
            for number in range(20 if os.environ.get("QUAD_LONG_TESTS") else 2):
                repeat = "again-%d" % number
                self.assertEqual(self.results(self.over_ros(config, repeat), repeat).hashes(), alone.hashes(), repeat)
        with self.subTest("both cores busy"):
            busy = [subprocess.Popen(["/bin/sh", "-c", "while :; do :; done"]) for _ in range(2)]
            try:
                for number in range(20 if os.environ.get("QUAD_LONG_TESTS") else 1):
                    loaded = "loaded-%d" % number
                    self.assertEqual(self.results(self.over_ros(config, loaded), loaded).hashes(), alone.hashes(), loaded)
            finally:
                for process in busy:
                    process.kill()
                    process.wait()

    def test_smoke(self):
        self.assert_same(*self.both_ways(os.path.join(ROOT, "config", "smoke.yaml")))

    def test_wind(self):
        wind = "  wind: {speed: 4, gust_force: 0.5, gust_direction: [0, 0, 1], gust_start: 2, gust_duration: 1, " \
               "turbulence_intensity: [1, 1, 0.5], turbulence_length: [50, 50, 20]}\n"
        config = self.write("windy.yaml", shipped("smoke.yaml", ("timing:\n", wind + "timing:\n")))
        alone, ros = self.both_ways(config)
        self.assert_same(alone, ros)
        calm = self.results(self.in_process(os.path.join(ROOT, "config", "smoke.yaml"), "calm"), "calm")
        self.assertNotEqual(calm.hashes()["targeted"], alone.hashes()["targeted"])

    def test_rotors_compat(self):
        """With RotorS's quirks, whose stamps are a step ahead of the state they carry."""
        config = self.write("compat.yaml", shipped("smoke.yaml", ("profile: default ", "profile: rotors_compat ")))
        alone, ros = self.both_ways(config)
        self.assert_same(alone, ros)
        self.results(self.in_process(os.path.join(ROOT, "config", "smoke.yaml"), "default"), "default")
        self.assertNotEqual(Results(self.path("default")).hashes(), ros.hashes())

    def test_another_seed_is_another_flight(self):
        """The comparison above is not one of two constants."""
        config = self.write("seed 2.yaml", shipped("smoke.yaml", ("\nseed: 1", "\nseed: 2")))
        alone, ros = self.both_ways(config)
        self.assert_same(alone, ros)
        self.results(self.in_process(os.path.join(ROOT, "config", "smoke.yaml"), "seed 1"), "seed 1")
        for flight, digest in Results(self.path("seed 1")).hashes().items():
            self.assertNotEqual(digest, ros.hashes()[flight])

    def test_a_paced_flight_is_the_same_flight(self):
        config = self.write("paced.yaml", shipped("smoke.yaml", ("hold_time: 1.0", "hold_time: 0.5"), ("num_samples: 40", "num_samples: 20"),
                                                  ("comparison: [gaussian]", "comparison: []")))
        alone = self.results(self.in_process(config, "in_process"), "in_process")
        ros = self.results(self.over_ros(config, "ros", "--rate", "1"), "ros")
        self.assertEqual(ros.hashes(), alone.hashes())
        self.assertGreater(ros.summary["wall_seconds"], float(ros.rows("targeted/trajectory.csv")[-1]["t"]) - 0.2)


if __name__ == "__main__":
    unittest.main()
