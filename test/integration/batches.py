"""A small batch, and what the tests of batches look at."""
import os
import re
import time

from flights import FlightCase, processes_with, program, shipped

RUNS = 60   # with a hold of 10 s half a second of work: enough to be disturbed
SPEC = """base: smoke.yaml
runs: %d
seed: 5
set:
  control.hold_time: 10.0
vary:
  seed: {count: 1}
  vehicle.mass: {uniform: [0.7, 0.75]}
  timing.latency: {choice: [0.0, 0.02, 0.045]}
  design.gamma_w: {choice: [4, 5]}
"""


class BatchCase(FlightCase):
    reference = None

    def setUp(self):
        super().setUp()
        self.write("smoke.yaml", shipped("smoke.yaml"))
        self.write("spec.yaml", SPEC % RUNS)

    def start_batch(self, out, *arguments, spec="spec.yaml", before=None):
        return self.start([program("quad_experiment", "quad_experiment"), "batch", "--spec", spec, "--out", out, *arguments],
                          preexec_fn=before)

    def batch(self, out, *arguments, code=0, **options):
        answer = self.finish(self.start_batch(out, *arguments, **options))
        self.assertEqual(answer.code, code, answer)
        return answer

    def table(self, out):
        with open(self.path(out, "results.csv"), "rb") as file:
            return file.read()

    def expected(self):
        """The table of an undisturbed batch; the same in every test, for the vehicle's hash is by content."""
        if BatchCase.reference is None:
            self.batch("reference", "--workers", "1")
            BatchCase.reference = self.table("reference")
        return BatchCase.reference

    def assert_whole(self, out):
        """Nothing half-written: every chunk agrees with its name and length, no beginnings are left."""
        for name in os.listdir(self.path(out, "chunks")):
            self.assertRegex(name, r"^\d{10}-\d{10}\.csv$")
            first, last = map(int, re.findall(r"\d{10}", name))
            with open(self.path(out, "chunks", name), encoding="utf-8") as file:
                self.assertEqual(len(file.readlines()), last - first + 1, name)

    def runs_written(self, out):
        names = os.listdir(self.path(out, "chunks")) if os.path.isdir(self.path(out, "chunks")) else []
        return sum(int(n[11:21]) - int(n[:10]) for n in names if re.match(r"^\d{10}-\d{10}\.csv$", n))

    def wait_for_runs(self, process, out, count):
        self.wait_until(lambda: self.runs_written(out) >= count, process)

    def wait_until_all_ended(self):
        end = time.monotonic() + 20
        while processes_with(self.folder):
            self.assertLess(time.monotonic(), end, "workers outlived their pool: %s" % processes_with(self.folder))
            time.sleep(0.01)
