#!/usr/bin/python3
"""A batch comes to the same table whatever happens on the way: workers, chunks, shards, signals, kills, a full disk.

QUAD_LONG_TESTS=1 sends 50 signals of each kind instead of a few."""
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest

from flights import DEVEL, ROOT, FlightCase, processes_with, program, shipped

LONG = bool(os.environ.get("QUAD_LONG_TESTS"))
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


class Faults(BatchCase):
    def signals(self, which, code):
        """Signals at random moments, each followed by --resume, until the batch is done."""
        moments = random.Random(which)
        hits = 0
        for attempt in range(2000):
            if attempt and os.path.exists(self.path("out", "results.csv")):
                self.assertEqual(self.table("out"), self.expected())
                shutil.rmtree(self.path("out"))
            resume = ["--resume"] if os.path.exists(self.path("out")) else []
            before = self.runs_written("out")
            process = self.start_batch("out", "--workers", "2", *resume)
            time.sleep(moments.uniform(0.0, 0.4))
            process.send_signal(which)
            answer = self.finish(process)
            # Before main() has installed its handlers the signal ends the process in the usual way.
            self.assertIn(answer.code, (0, code, -which), answer)
            if answer.code == code:
                self.assertIn("interrupted", answer.stderr)
            if os.path.isdir(self.path("out", "chunks")):
                self.assert_whole("out")
                self.assertGreaterEqual(self.runs_written("out"), before)   # nothing is lost
            hits += answer.code != 0
            if hits >= (50 if LONG else 4):
                break
        self.batch("out", "--resume")
        self.assertEqual(self.table("out"), self.expected())

    def test_interrupted(self):
        self.signals(signal.SIGINT, 130)

    def test_terminated(self):
        self.signals(signal.SIGTERM, 143)

    def test_an_interruption_keeps_finished_runs(self):
        self.write("spec.yaml", SPEC.replace("10.0", "200.0") % RUNS)   # seconds of work, all in one chunk
        for seconds in (0.3, 0.6, 1.2, 2.4, 4.8):   # a loaded machine may not have finished a run at first
            process = self.start_batch("out", "--workers", "1", "--chunk", "1000", "--force")
            time.sleep(seconds)
            process.send_signal(signal.SIGTERM)
            self.assertEqual(self.finish(process).code, 143)
            if os.path.isdir(self.path("out", "chunks")) and self.runs_written("out"):
                break
        self.assertGreater(self.runs_written("out"), 0)
        self.assert_whole("out")

    def test_killed_workers(self):
        process = self.start_batch("out", "--workers", "2", "--chunk", "5")
        for _ in range(3):
            workers = [pid for pid, line in processes_with(self.folder).items() if " worker " in line]
            if workers:
                os.kill(workers[0], signal.SIGKILL)
            time.sleep(0.15)
        self.assertEqual(self.finish(process).code, 0)
        self.assertEqual(self.table("out"), self.expected())

    def test_a_damaged_chunk(self):
        self.batch("out", "--chunk", "10")
        os.remove(self.path("out", "results.csv"))
        with open(self.path("out", "chunks", "0000000010-0000000020.csv"), "r+b") as file:
            file.seek(500)
            file.write(b"?")
        answer = self.batch("out", "--resume")
        self.assertRegex(answer.stderr, r"0000000010-0000000020.csv: does not agree with its checksum; its runs are flown again")
        self.assertEqual(self.table("out"), self.expected())

    def test_a_changed_spec(self):
        self.batch("out", "--runs", "4")
        before = self.table("out")
        said = "was begun with another spec, number of runs, settings file, vehicle or program"
        self.assertIn(said, self.batch("out", "--resume", "--runs", "5", code=2).stderr)
        self.write("smoke.yaml", shipped("smoke.yaml", ("gravity: 9.8 ", "gravity: 9.7 ")))
        self.assertIn(said, self.batch("out", "--resume", "--runs", "4", code=2).stderr)
        self.assertEqual(self.table("out"), before)
        self.assertIn("exists already; --resume continues it, --force begins again", self.batch("out", code=2).stderr)
        self.batch("out", "--runs", "4", "--force")
        self.assertNotEqual(self.table("out"), before)

    def test_a_limit_on_file_sizes(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (6000, 6000))   # a manifest fits, a chunk of 20 runs does not
        answer = self.batch("out", "--chunk", "20", code=5, before=limit)
        self.assertRegex(answer.stderr, r"^quad_experiment: cannot write .*/chunks/.*: File too large\n$")
        self.assert_whole("out")
        self.batch("out", "--resume")
        self.assertEqual(self.table("out"), self.expected())

    def test_a_full_disk(self):
        self.expected()
        if subprocess.run(["unshare", "-rm", "true"], stderr=subprocess.DEVNULL).returncode:
            self.skipTest("this machine lets nobody mount a small disk (unshare -rm)")
        os.mkdir(self.path("disk"))
        script = """mount -t tmpfs -o size=%s none disk || exit 99
"$0" batch --spec spec.yaml --out disk/out --chunk 10; echo "code $?"; ls -R disk >listing
mount -o remount,size=16m disk; "$0" batch --spec spec.yaml --out disk/out --resume || exit 98; cp disk/out/results.csv ."""
        answer = self.finish(self.start(["unshare", "-rm", "/bin/sh", "-c", script % "48k",
                                         program("quad_experiment", "quad_experiment")]))
        if answer.code == 99:
            self.skipTest("no tmpfs may be mounted here")
        self.assertEqual(answer.code, 0, answer)
        self.assertIn("code 5\n", answer.stdout)
        self.assertRegex(answer.stderr, r"No space left on device")
        with open(self.path("listing"), encoding="utf-8") as file:
            self.assertNotIn("partial", file.read())
        with open(self.path("results.csv"), "rb") as file:
            self.assertEqual(file.read(), self.expected())

    def test_a_directory_that_cannot_be_written(self):
        os.mkdir(self.path("locked"))
        os.chmod(self.path("locked"), 0o555)
        os.chmod(self.folder, 0o755)

        def ordinary_user():
            if os.geteuid() == 0:
                os.setgroups([])
                os.setgid(65534)
                os.setuid(65534)
        answer = self.batch("locked/out", code=5, before=ordinary_user)
        self.assertRegex(answer.stderr, r"^quad_experiment: cannot create locked/out: Permission denied\n$")
        self.assertEqual(os.listdir(self.path("locked")), [])

    def test_a_spec_that_changes_on_the_way(self):
        """A worker that starts later refuses to fly another study; no run is blamed for it."""
        self.expected()
        process = self.start_batch("out", "--workers", "1", "--chunk", "2")
        self.wait_for_runs(process, "out", 2)
        self.write("spec.yaml", SPEC % RUNS + "# edited\n")
        for pid, line in processes_with(self.folder).items():
            if " worker " in line:
                os.kill(pid, signal.SIGKILL)
        answer = self.finish(process)
        self.assertEqual(answer.code, 5, answer)
        self.assertIn("has changed since the batch was begun", answer.stderr)
        self.assertIn("workers end before they fly anything", answer.stderr)
        self.write("spec.yaml", SPEC % RUNS)
        self.batch("out", "--resume")
        self.assertEqual(self.table("out"), self.expected())

    def test_progress_on_a_terminal(self):
        ours, theirs = os.openpty()
        process = self.start([program("quad_experiment", "quad_experiment"), "batch", "--spec", "spec.yaml", "--out", "out", "--workers",
                              "2", "--chunk", "1"], stderr=theirs)
        os.close(theirs)
        shown = b""
        while True:
            try:
                shown += os.read(ours, 4096)
            except OSError:   # the other end is closed
                break
        os.close(ours)
        self.assertEqual(self.finish(process).code, 0)
        self.assertRegex(shown.decode(), r"\d+ of %d runs, 2 workers, [\d.]+ a second, \d+:\d\d left" % RUNS)

    def test_two_at_once(self):
        process = self.start_batch("out", "--workers", "1", "--chunk", "2")
        self.wait_for_runs(process, "out", 2)
        second = self.start_batch("out", "--resume")
        _, stderr = second.communicate(timeout=60)
        self.assertEqual(second.returncode, 5, stderr)
        self.assertIn("is locked: another process flies these runs", stderr)
        self.assertEqual(self.finish(process).code, 0)
        self.assertEqual(self.table("out"), self.expected())


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
