#!/usr/bin/python3
"""What may happen to a batch on its way: signals, kills, a full disk, damaged and changed files. Nothing is lost or half written.

QUAD_LONG_TESTS=1 sends 50 signals of each kind instead of a few."""
import os
import random
import resource
import shutil
import signal
import subprocess
import time
import unittest

from batches import RUNS, SPEC, BatchCase
from flights import processes_with, program, shipped

LONG = bool(os.environ.get("QUAD_LONG_TESTS"))


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


if __name__ == "__main__":
    unittest.main()
