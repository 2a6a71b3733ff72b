#!/usr/bin/python3
"""A batch comes to the same table whatever its workers, chunks, shards and kills; runs no worker survives are rows; the studies."""
import os
import subprocess
import unittest

from batches import RUNS, BatchCase
from flights import DEVEL, ROOT, FlightCase, program


class SameTable(BatchCase):
    def test_any_number_of_workers_and_any_chunks(self):
        for workers, chunk in (("2", "0"), ("8", "1"), ("2", "7"), ("1", "1000")):
            with self.subTest(workers=workers, chunk=chunk):
                out = "out-%s-%s" % (workers, chunk)
                answer = self.batch(out, "--workers", workers, "--chunk", chunk)
                self.assertEqual(self.table(out), self.expected())
                self.assertEqual(answer.stderr, "")   # no progress where nobody watches
                self.assertIn("%d runs: " % RUNS, answer.stdout)

    def test_shards_in_one_directory(self):
        parts = [self.start_batch("out", "--shard", "%d/3" % i, "--workers", "1") for i in (3, 1, 2)]
        for part in parts:
            self.assertEqual(part.wait(60), 0, part.communicate())
        for part in parts:
            part.communicate()
        self.assertEqual(self.table("out"), self.expected())
        for wrong in ("0/3", "4/3", "1", "a/b", "1/2/3"):
            self.assertIn("must be i/n", self.batch("other", "--shard", wrong, code=2).stderr)

    def test_three_kills_and_resume(self):
        kills = 0
        for attempt in range(200):
            process = self.start_batch("out", "--workers", "2", "--chunk", "3", *(["--resume"] if attempt else []))
            before = self.runs_written("out")
            if kills == 3:
                self.finish(process)
                self.assertEqual(process.returncode, 0)
                break
            self.wait_until(lambda: self.runs_written("out") > before or process.poll() is not None, process)
            process.kill()
            process.communicate()
            kills += 1
            self.wait_until_all_ended()
        self.assertEqual(kills, 3)
        self.assertEqual(self.table("out"), self.expected())
        self.assert_whole("out")

    def test_a_run_again_bit_for_bit(self):
        self.batch("out")
        row = self.table("out").decode().splitlines()[18]
        answer = self.finish(self.start([program("quad_experiment", "quad_experiment"), "batch", "replay", "17",
                                         "--batch", "out", "--out", "again"]))
        self.assertIn(answer.code, (0, 3), answer)
        self.assertEqual(answer.stdout.splitlines()[0], row)
        self.assertTrue(os.path.exists(self.path("again", "targeted", "trajectory.csv")))
        alone = self.in_process("again/config.yaml", "alone")
        self.assertEqual(alone.code, answer.code, alone)
        with open(self.path("again/targeted/trajectory.csv"), "rb") as a, open(self.path("alone/targeted/trajectory.csv"), "rb") as b:
            self.assertEqual(a.read(), b.read())
        with open(self.path("out/results.csv"), "r+", encoding="utf-8") as file:   # a row that was not flown
            text = file.read().replace(row, row[:-1] + ("1" if row[-1] == "0" else "0"))
            file.seek(0)
            file.write(text)
        answer = self.finish(self.start([program("quad_experiment", "quad_experiment"), "batch", "replay", "17",
                                         "--batch", "out", "--out", "third"]))
        self.assertEqual(answer.code, 5, answer)
        self.assertIn("differs from its row", answer.stderr)


class Rows(BatchCase):
    """Runs that no worker lives to tell of."""

    def statuses(self, out):
        lines = [line.split(",") for line in self.table(out).decode().splitlines()]
        at = lines[0].index("status")
        return [line[at] + " " + line[at + 1] for line in lines[1:]]

    def test_a_run_that_kills_its_worker(self):
        with open(os.path.join(DEVEL, "..", "urdf", "hummingbird.urdf"), encoding="utf-8") as file:
            urdf = file.read()
        self.write("die.c", "#include <stdlib.h>\n__attribute__((constructor)) static void die(void) { abort(); }\n")
        subprocess.run(["cc", "-shared", "-fPIC", "-o", self.path("libdie.so"), self.path("die.c")], check=True)
        plugin = '<gazebo><plugin name="die" filename="%s"/></gazebo></robot>' % self.path("libdie.so")
        self.write("good.urdf", urdf)
        self.write("poison.urdf", urdf.replace("</robot>", plugin))
        self.write("spec.yaml", "base: smoke.yaml\nruns: 1\nseed: 1\nvary:\n  vehicle.urdf: {grid: [good.urdf, good.urdf, "
                                "good.urdf, poison.urdf, good.urdf, good.urdf, good.urdf, good.urdf]}\n")
        for chunk in ("8", "1"):
            self.batch("out" + chunk, "--chunk", chunk, "--workers", "2")
            statuses = self.statuses("out" + chunk)
            self.assertEqual(statuses[3], "crashed 5")
            self.assertNotIn("crashed 5", statuses[:3] + statuses[4:])
        self.assertEqual(self.table("out8"), self.table("out1"))

    def test_a_run_without_end(self):
        # With steps of 0.1 us an interval takes a million of them.
        self.write("spec.yaml", "base: smoke.yaml\nruns: 1\nseed: 1\nset: {timing.latency: 0, timing.jitter_std: 0}\n"
                                "vary:\n  simulation.step: {grid: [0.001, 1.0e-7, 0.002]}\n")
        self.batch("out", "--timeout", "1", "--workers", "2", "--chunk", "3")
        self.assertEqual([s.split()[0] == "timeout" for s in self.statuses("out")], [False, True, False])


class Studies(FlightCase):
    """The shipped studies, one repeat of each point: specs, tables and pictures work."""

    def test_tables_and_pictures(self):
        quad_experiment = program("quad_experiment", "quad_experiment")
        answer = self.finish(self.start([os.path.join(ROOT, "scripts", "studies"), "--runs", "1", "--results", "results", "--docs",
                                         "docs", "--program", quad_experiment]))
        self.assertEqual(answer.code, 0, answer)
        for name, rows in (("promise", 20), ("gamma_w", 13), ("energy", 48), ("thesis", 8)):
            with open(os.path.join(ROOT, "docs", "studies", name + ".csv"), encoding="utf-8") as file:
                shipped_table = file.read().splitlines()
            with open(self.path("docs", name + ".csv"), encoding="utf-8") as file:
                table = file.read().splitlines()
            self.assertEqual((len(table), table[0]), (rows + 1, shipped_table[0]), name)
            self.assertEqual(len(shipped_table), rows + 1, name)
            with open(self.path("docs", name + ".svg"), encoding="utf-8") as file:
                self.assertIn("</svg>", file.read())


if __name__ == "__main__":
    unittest.main()
