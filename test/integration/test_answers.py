#!/usr/bin/python3
"""How an experiment says no: exit code, one line that helps, and results only where there is an answer."""
import glob
import os
import re
import unittest

from flights import DEVEL, RUNNER, FlightCase, program, shipped


def built_urdf():
    for folder in (os.path.join(DEVEL, "..", "urdf"), os.path.join(DEVEL, "share", "quad_sim", "urdf")):
        path = os.path.join(folder, "hummingbird.urdf")
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                return file.read()
    raise AssertionError("no built hummingbird.urdf near " + DEVEL)


class Answers(FlightCase):
    def test_reaching_the_ground(self):
        # From 100 m it lands slowly; from 800 m so fast that it is off the ground again at the next sample.
        for altitude, fly, name in ((100, self.in_process, "alone"), (800, self.in_process, "alone"), (800, self.over_ros, "ros")):
            with self.subTest(name, altitude=altitude):
                self.write("low.yaml", shipped("thesis.yaml", ("initial_altitude: 5000.0", f"initial_altitude: {altitude}.0")))
                answer = fly("low.yaml", "results/" + name)
                self.assertEqual(answer.code, 4, answer)
                self.assertRegex(answer.stderr.splitlines()[0],
                                 r"reached the ground at [\d.]+ s; raise simulation.initial_altitude$")
                self.assert_no_results("results/" + name)

    def test_a_broken_promise_has_results(self):
        self.write("weak.yaml", shipped("thesis.yaml", ("[0.04, 0.94, 1.76, -2.62]", "[0.004, 0.01, 0.02, -0.03]")))
        for fly, name in ((self.in_process, "alone"), (self.over_ros, "ros")):
            with self.subTest(name):
                answer = fly("weak.yaml", "results/" + name)
                results = self.results(answer, "results/" + name, codes=(3,))
                self.assertIn("the promise was BROKEN", answer.stdout)
                summary = results.summary
                self.assertEqual((summary["ok"], summary["exit_code"]), (False, 3))
                self.assertFalse(summary["targeted"]["exploration_condition"])
                self.assertEqual(summary["log_sha256"], results.hashes())

    def test_a_stdout_that_cannot_be_written(self):
        self.write("smoke.yaml", shipped("smoke.yaml", ("comparison: [gaussian]", "comparison: []")))
        own = program("quad_experiment", "quad_experiment")
        for name, command in (("run", [own, "run"]), ("step", [own, "step", "--duration", "1"]), ("ros", [RUNNER])):
            with self.subTest(name), open("/dev/full", "w") as full:
                answer = self.finish(self.start([*command, "--config", "smoke.yaml", "--out", name], stdout=full))
                self.assertEqual(answer.code, 5, answer)
                self.assertRegex(answer.stderr.splitlines()[0], r"^\S+: standard output cannot be written "
                                 r"\(No space left on device\); the results stand in %s$" % name)
                self.assertTrue(os.path.exists(self.path(name, "config.yaml")))
        with open("/dev/full", "w") as full:
            answer = self.finish(self.start([own, "export", "run", "--plotjuggler"], stdout=full))
        self.assertEqual((answer.code, answer.stderr), (5, "quad_experiment export: standard output cannot be written (No space left "
                                                           "on device); the files stand in run/export\n"))
        with open("/dev/full", "w") as full:   # results or not
            answer = self.finish(self.start([own, "--help"], stdout=full))
        self.assertEqual(answer.code, 5, answer)
        self.assertIn("standard output cannot be written", answer.stderr)

    def test_a_design_that_does_not_exist(self):
        # More information than any signal of finite numbers carries.
        self.write("huge.yaml", shipped("smoke.yaml", ("desired_closeness: 10.0", "desired_closeness: 1e300"), ("gamma_w: 4.0", "gamma_w: 1e300")))
        for fly, name in ((self.in_process, "alone"), (self.over_ros, "ros")):
            with self.subTest(name):
                answer = fly("huge.yaml", "results/" + name)
                self.assertEqual(answer.code, 3, answer)
                self.assertRegex(answer.stderr.splitlines()[0], "no exploration signal: .+")
                self.assertEqual(len(answer.stderr.splitlines()), 1, answer)
                self.assert_no_results("results/" + name)


class BadInput(FlightCase):
    """Each case: what stands on the one line. The programs differ in their name only."""

    def refused(self, config_text, *expected):
        config = self.write("bad.yaml", config_text)
        said = {}
        for fly, prefix, out in ((self.in_process, "quad_experiment: ", "results/alone"),
                                 (self.over_ros, "scripts/experiment: ", "results/ros")):
            answer = fly("bad.yaml", out)
            self.assertEqual((answer.code, answer.stdout), (2, ""), answer)
            self.assertEqual(len(answer.stderr.splitlines()), 1, answer)
            self.assertTrue(answer.stderr.startswith(prefix), answer)
            said[prefix] = answer.stderr[len(prefix):].rstrip("\n")
            self.assert_no_results(out)
            for part in expected:
                self.assertRegex(said[prefix], part)
        self.assertEqual(len(set(said.values())), 1, said)
        self.assertEqual(glob.glob(self.path("tmp", "*")), [])   # no logs of a run that never began
        return config

    def test_settings(self):
        cases = {
            "broken YAML": (("gamma_w: 4.0", "gamma_w: [4.0"), r"bad\.yaml:\d+: not valid YAML: ."),
            "unknown key": (("\nseed: 1 ", "\nsead: 1\nseed: 1 "), r"bad\.yaml:\d+: sead is not a key .*; known here: .*\bseed\b"),
            "missing key": (("  gamma_w: 4.0", "  # gamma_w: 4.0"), r"bad\.yaml:\d+: design\.gamma_w is missing; it must be > 0"),
            "duplicate key": (("gamma_w: 4.0", "gamma_w: 4.0\n  gamma_w: 5.0"),
                              r"bad\.yaml:\d+: design\.gamma_w stands twice \(first on line \d+\); remove one"),
            "gamma_w = 0": (("gamma_w: 4.0", "gamma_w: 0"), r"bad\.yaml:\d+: design\.gamma_w = 0; must be > 0$"),
            "gamma_w < 0": (("gamma_w: 4.0", "gamma_w: -4"), r"bad\.yaml:\d+: design\.gamma_w = -4; must be > 0$"),
            "gamma_w = nan": (("gamma_w: 4.0", "gamma_w: .nan"), r"bad\.yaml:\d+: design\.gamma_w = \.nan; must be a finite number > 0$"),
            "harmonic twice": (("[1, 2, 3]", "[1, 2, 2]"), r"bad\.yaml:\d+: design\.harmonics\[2\] = 2; stands twice"),
            "harmonic off the grid": (("[1, 2, 3]", "[1, 2.5, 3]"),
                                      r"bad\.yaml:\d+: design\.harmonics\[1\] = 2\.5; must be a whole number in 1\.\.19$"),
            "harmonic at T/2": (("[1, 2, 3]", "[1, 2, 20]"),
                                r"bad\.yaml:\d+: design\.harmonics\[2\] = 20; must be a whole number in 1\.\.19$"),
            "mode": (("mode: lockstep", "mode: warp"), r"bad\.yaml:\d+: timing\.mode = warp; must be one of: lockstep, wallclock$"),
            "no such URDF": (("urdf: hummingbird.urdf", "urdf: bee.urdf"), r"bad\.yaml:\d+: vehicle\.urdf = bee\.urdf; .*give a path"),
        }
        for name, (change, expected) in cases.items():
            with self.subTest(name):
                text = shipped("smoke.yaml", change)
                self.refused(text, expected)
                if name in ("gamma_w = 0", "mode"):   # the line is the right one
                    line = 1 + next(i for i, l in enumerate(text.splitlines()) if change[1] in l)
                    self.refused(text, r"^bad\.yaml:%d: " % line)

    def test_vehicles(self):
        urdf = built_urdf()
        rotor_1 = re.search(r"<gazebo>\s*<plugin(?:(?!</gazebo>).)*<motorNumber>1</motorNumber>.*?</gazebo>", urdf, re.DOTALL)
        self.assertIsNotNone(rotor_1)
        mass, inertia = re.search(r'<mass value="[^"]*"', urdf).group(0), re.search(r'ixx="[^"]*"', urdf).group(0)
        cases = {
            "missing rotor": (urdf.replace(rotor_1.group(0), ""), r"bee\.urdf:\d+: joint '.*rotor_1_joint': no motor plugin .*motor number 1 is missing: there are 0, 2, 3"),
            "mass 0": (urdf.replace(mass, '<mass value="0"', 1), r"bee\.urdf:\d+: link '.*': mass = 0 kg; must be > 0"),
            "negative mass": (urdf.replace(mass, '<mass value="-1"', 1), r"bee\.urdf:\d+: link '.*': mass = -1 kg; must be > 0"),
            "inertia": (urdf.replace(inertia, 'ixx="-0.007"', 1), r"bee\.urdf:\d+: link '.*': .*inertia.*positive definite"),
            "allocation": (re.sub(r"<momentConstant>[^<]*<", "<momentConstant>0<", urdf),
                           r"bee\.urdf: control allocation: 4 rotors give a matrix of rank 3 of 4, so .* cannot be commanded"),
            "too heavy": (re.sub(r"<maxRotVelocity>[^<]*<", "<maxRotVelocity>100<", urdf),
                          r"bad\.yaml:\d+: vehicle\.mass = 0\.73; .*takes .* rad/s, but the rotors turn at most 100 rad/s, which carries 0\.03"),
            "broken XML": (urdf.replace("</robot>", ""), r"bee\.urdf:\d+: ."),
        }
        for name, (text, expected) in cases.items():
            with self.subTest(name):
                self.assertNotEqual(text, urdf)
                self.write("bee.urdf", text)
                self.refused(shipped("smoke.yaml", ("urdf: hummingbird.urdf", "urdf: bee.urdf")), expected)

    def test_the_wall_clock_needs_ros(self):
        answer = self.in_process(self.write("wall.yaml", shipped("wallclock.yaml")), "results/run")
        self.assertEqual(answer.code, 2, answer)
        self.assertIn("use scripts/experiment", answer.stderr)

    def test_results_that_exist(self):
        self.write("smoke.yaml", shipped("smoke.yaml", ("comparison: [gaussian]", "comparison: []")))
        self.assertIn(self.in_process("smoke.yaml", "results").code, (0, 3))
        for fly in (self.in_process, self.over_ros):
            before = os.stat(self.path("results")).st_ino
            answer = fly("smoke.yaml", "results")
            self.assertEqual(answer.code, 2, answer)
            self.assertIn("exists already", answer.stderr)
            self.assertIn("--force", answer.stderr)
            self.assertEqual(os.stat(self.path("results")).st_ino, before)
            self.assertIn(fly("smoke.yaml", "results", "--force").code, (0, 3))
            self.assertNotEqual(os.stat(self.path("results")).st_ino, before)

    def test_programs_are_there(self):
        self.assertTrue(os.access(program("quad_experiment", "quad_experiment"), os.X_OK), "build first: make build")


if __name__ == "__main__":
    unittest.main()
