"""A report appears whole or not at all, and nothing it started outlives it.

The work is done in a process of its own, which writes aside. This one does nothing meanwhile but wait for its end or for a signal,
so an interrupt never falls into the middle of something: first everything that was started is ended, then what was written is
removed or, if all of it is there, put in place by renaming.
"""
import ctypes
import json
import os
import shutil
import signal
import tempfile
import traceback

from quad_runner.processes import ENDING, become_reaper, describe, kill_descendants

AWAITED = (*ENDING, signal.SIGCHLD)


class Interrupted(Exception):
    def __init__(self, number):
        super().__init__(signal.Signals(number).name)
        self.code = 128 + number


class Lost(Exception):
    """The work ended without an answer."""


def block_signals():
    """From here on signals wait until they are asked for."""
    signal.pthread_sigmask(signal.SIG_BLOCK, AWAITED)


def make(results, work):
    """Calls `work(aside)` in a process of its own and puts the files it leaves in the folder `aside` into `results`.

    The work answers {"problem": [exit code, text] or null, "stale": [files that no longer belong there], ...}, which is returned.
    Needs block_signals() before.
    """
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)   # ignored, by whoever started this, there would be no exit codes
    become_reaper()
    scratch = tempfile.mkdtemp(prefix="quad_report.")
    aside = os.path.join(results, ".report.partial-%d" % os.getpid())
    try:
        answer = wait_for(start(work, aside, scratch), os.path.join(scratch, "answer.json"))
        if not answer["problem"]:
            put_in_place(aside, results, answer["stale"])
        return answer
    finally:
        kill_descendants()
        shutil.rmtree(scratch, ignore_errors=True)
        shutil.rmtree(aside, ignore_errors=True)


def start(work, aside, scratch):
    """The process id of the one that works."""
    parent, pid = os.getpid(), os.fork()
    if pid:
        return pid
    code = 1
    try:
        os.setsid()   # Ctrl-C is the other process's business
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)   # PR_SET_PDEATHSIG
        if os.getppid() != parent:
            os._exit(code)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, AWAITED)
        os.environ["TMPDIR"] = scratch
        tempfile.tempdir = scratch
        answer = work(aside)
        with open(os.path.join(scratch, "answer.json"), "w", encoding="utf-8") as file:
            json.dump(answer, file)
        code = 0
    except BaseException:   # nothing may reach the caller, who is the other process
        traceback.print_exc()
    finally:
        os._exit(code)


def wait_for(pid, path):
    """The answer of the process once it has ended. @raises Interrupted when a signal comes first"""
    while True:
        number = signal.sigwait(AWAITED)
        if number != signal.SIGCHLD:
            raise Interrupted(number)
        ended, status = os.waitpid(pid, os.WNOHANG)   # other children are orphans of the work's programs
        if ended:
            break
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        raise Lost("the process that draws ended without an answer (%s)" % describe(os.waitstatus_to_exitcode(status)))


def put_in_place(aside, results, stale):
    """The page last: where it is, its figures are."""
    names = sorted((os.path.relpath(os.path.join(folder, name), aside) for folder, _, names in os.walk(aside) for name in names),
                   key=lambda name: (os.sep not in name, name))
    for name in names:
        os.makedirs(os.path.dirname(os.path.join(results, name)), exist_ok=True)
        os.replace(os.path.join(aside, name), os.path.join(results, name))
    for name in stale:
        if os.path.exists(os.path.join(results, name)):
            os.remove(os.path.join(results, name))
