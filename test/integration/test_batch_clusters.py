#!/usr/bin/python3
"""A batch on a Dask cluster, and on a Slurm of one machine, comes to the table that one process writes."""
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from flights import ROOT, FlightCase, processes_with, program, shipped

DASK = os.path.join(ROOT, "scripts", "batch_dask")
SLURM = os.path.join(ROOT, "scripts", "slurm_array")
SPEC = """base: smoke.yaml
runs: 40
seed: 2
set:
  control.hold_time: 20.0   # long enough for a worker to be killed on the way
vary:
  seed: {count: 1}
  vehicle.mass: {uniform: [0.7, 0.75]}
"""


def has_dask():
    return subprocess.run(["/usr/bin/python3", "-c", "import distributed"], stderr=subprocess.DEVNULL, check=False).returncode == 0


class ClusterCase(FlightCase):
    def setUp(self):
        super().setUp()
        self.write("smoke.yaml", shipped("smoke.yaml"))
        self.write("spec.yaml", SPEC)
        answer = self.finish(self.start([program("quad_experiment", "quad_experiment"), "batch", "--spec", "spec.yaml", "--out",
                                         "alone", "--workers", "1"]))
        self.assertEqual(answer.code, 0, answer)

    def table(self, out):
        with open(self.path(out, "results.csv"), "rb") as file:
            return file.read()

    def dask(self, *arguments):
        return self.start([DASK, "--spec", "spec.yaml", "--program", program("quad_experiment", "quad_experiment"), "--workers", "2",
                           *arguments])


@unittest.skipUnless(has_dask(), "python3-distributed is not installed")
class Dask(ClusterCase):
    def test_same_table_although_workers_are_killed(self):
        process = self.dask("--out", "out", "--chunk", "4")
        self.wait_until(lambda: os.path.isdir(self.path("out", "chunks")), process, 60)
        killed = 0
        while killed < 2 and process.poll() is None:
            # A Dask worker is the parent of a program that flies a shard.
            for pid, line in processes_with(self.folder).items():
                if "--shard" in line and killed < 2:
                    try:
                        with open("/proc/%d/stat" % pid, encoding="utf-8") as file:
                            os.kill(int(file.read().rsplit(")", 1)[1].split()[1]), signal.SIGKILL)
                        killed += 1
                    except (FileNotFoundError, ProcessLookupError):
                        continue
                    break
            time.sleep(0.1)
        answer = self.finish(process)
        self.assertEqual(answer.code, 0, answer)
        self.assertGreater(killed, 0, "the batch was over before a worker could be killed")
        self.assertEqual(self.table("out"), self.table("alone"))

    def test_bad_input(self):
        self.write("spec.yaml", SPEC.replace("mass", "mess"))
        answer = self.finish(self.dask("--out", "out"))
        self.assertEqual(answer.code, 2, answer)
        self.assertIn("vehicle.mess", answer.stderr)
        self.write("spec.yaml", SPEC)
        answer = self.finish(self.dask("--out", "alone"))
        self.assertEqual((answer.code, answer.stderr), (2, "batch_dask: alone: exists already; --resume continues it\n"))


class Slurm(ClusterCase):
    """scripts/slurm_array as Slurm calls it; by a real one where slurmctld, slurmd and munged are installed."""

    def test_tasks_of_an_array(self):
        environment = dict(self.environment, SLURM_ARRAY_TASK_COUNT="3", SLURM_ARRAY_TASK_MIN="1", SLURM_ARRAY_TASK_MAX="3",
                           SLURM_CPUS_PER_TASK="1", QUAD_EXPERIMENT=program("quad_experiment", "quad_experiment"))
        for task in (3, 1, 2):
            answer = self.finish(self.start([SLURM, "spec.yaml", "out"], env=dict(environment, SLURM_ARRAY_TASK_ID=str(task))))
            self.assertEqual(answer.code, 0, answer)
        self.assertEqual(self.table("out"), self.table("alone"))
        gaps = self.finish(self.start([SLURM, "spec.yaml", "out"], env=dict(environment, SLURM_ARRAY_TASK_ID="1",
                                                                            SLURM_ARRAY_TASK_MAX="5")))
        self.assertEqual(gaps.code, 2, gaps)
        self.assertIn("must be 1-N without gaps", gaps.stderr)

    def test_a_real_slurm(self):
        missing = [p for p in ("slurmctld", "slurmd", "munged", "sbatch") if not shutil.which(p, path=os.environ["PATH"] + ":/usr/sbin:/sbin")]
        if missing or os.geteuid() != 0:
            self.skipTest("needs root and: " + ", ".join(missing or ["nothing more"]))
        from one_machine_slurm import OneMachineSlurm
        folder = tempfile.mkdtemp(prefix="slurm-")
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        with OneMachineSlurm(folder) as slurm:
            job = slurm.submit(["--array=1-3", SLURM, "spec.yaml", "out"], self.folder,
                               dict(self.environment, QUAD_EXPERIMENT=program("quad_experiment", "quad_experiment")))
            slurm.wait_for(job, 90)
            self.assertEqual(self.table("out"), self.table("alone"), slurm.logs())


if __name__ == "__main__":
    unittest.main()
