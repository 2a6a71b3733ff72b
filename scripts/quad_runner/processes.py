"""Every process a run starts, and its end: this program inherits orphans, so that nothing outlives it."""
import ctypes
import os
import signal
import time

from .answers import Interrupted, say

PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
LIBC = ctypes.CDLL(None, use_errno=True)
ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def become_reaper():
    """From here on the orphans of what this process starts are its children."""
    if LIBC.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0:
        say("cannot become the reaper of its nodes (prctl); after a crash some may be left")


def die_with_parent():
    """In the child: should this program be killed, roslaunch gets SIGTERM and takes its nodes along."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)


def descendants():
    """Process ids of everything below this process, whatever its group or session; finished ones are not counted."""
    parents = {}
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                with open("/proc/%s/stat" % entry, "rb") as file:
                    fields = file.read().rpartition(b")")[2].split()
            except OSError:
                continue
            parents[int(entry)] = (int(fields[1]), fields[0] in (b"Z", b"X"))
    found, frontier = [], {os.getpid()}
    while frontier:
        frontier = {pid for pid, (parent, _) in parents.items() if parent in frontier}
        found += [pid for pid in frontier if not parents[pid][1]]
    return found


def kill_descendants():
    """SIGKILL until nothing is left: as the subreaper, this process inherits every orphan."""
    end = time.monotonic() + 3.0
    while time.monotonic() < end:
        left = descendants()
        for pid in left:
            send(pid, signal.SIGKILL)
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            return
        time.sleep(0.005)
    say("processes %s could not be ended" % " ".join(map(str, descendants())))


def send(pid, number):
    try:
        os.kill(pid, number)
    except (ProcessLookupError, PermissionError):
        pass


def interrupt(number, _frame):
    raise Interrupted(number)


def heed_interrupts():
    for number in ENDING:
        signal.signal(number, interrupt)


def ignore_interrupts():
    for number in ENDING:
        signal.signal(number, signal.SIG_IGN)


def describe(exit_code):
    if exit_code is None:
        return "no exit code"
    if exit_code < 0:
        try:
            return "killed by %s" % signal.Signals(-exit_code).name
        except ValueError:
            return "killed by signal %d" % -exit_code
    return "exit code %d" % exit_code
