"""One roslaunch of the experiment, from its start until nothing of it is left, and what it answered."""
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time

from .answers import BAD_INPUT, DONE, ENVIRONMENT, Failure, PortTaken, say, tell
from .processes import descendants, describe, die_with_parent, heed_interrupts, ignore_interrupts, kill_descendants, send
from .workspace import LAUNCH, ROOT, full_disk

GRACE = 1.0      # [s] that nodes get to end by themselves before they are killed
POLL = 0.02      # [s]


def fly(args, settings, out, env, run_folder):
    deadline = time.monotonic() + args.timeout if args.timeout else float("inf")
    for attempt in (1, 2, 3):
        run = Run(args, settings, out, env, os.path.join(run_folder, str(attempt)))
        try:
            code, message, written = run.answer(deadline)
        except PortTaken:
            continue
        finally:
            run.stop()
        if written:
            print_results(args.out, out)
        if message and code != DONE:
            say(message)
        return code
    raise Failure(ENVIRONMENT, "three ports for the ROS master were taken by others; try again")


class Run:
    """One roslaunch, from its start until nothing of it is left."""

    def __init__(self, args, settings, out, env, folder):
        os.mkdir(folder)
        self.args, self.out = args, out
        self.status_path = os.path.join(folder, "status.json")
        self.pids = {}          # node name -> process id, as roslaunch tells
        self.log_text = ""
        self.terminal = os.ttyname(2) if os.isatty(2) else ""
        # Bound but not listening: with SO_REUSEADDR the master can take the port, and nobody is given it by chance.
        self.port_holder = socket.socket()
        self.port_holder.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.port_holder.bind(("127.0.0.1", 0))
        port = self.port_holder.getsockname()[1]
        env = dict(env, ROS_MASTER_URI="http://127.0.0.1:%d" % port, ROS_HOME=folder,
                   ROS_LOG_DIR=os.path.join(folder, "log"), ROS_ETC_DIR=os.path.join(ROOT, "launch", "headless"))
        arguments = {"config": os.path.abspath(args.config), "out": out, "force": str(args.force).lower(),
                     "mode": args.mode, "rate": repr(args.rate), "status": self.status_path,
                     "namespace": settings["namespace"], "monitor": str(bool(self.terminal)).lower(),
                     "terminal": self.terminal}
        roslaunch = shutil.which("roslaunch", path=env["PATH"])
        if not roslaunch:
            raise Failure(ENVIRONMENT, "roslaunch is not installed; run: scripts/setup")
        command = [roslaunch, "-p", str(port), "--skip-log-check", "--disable-title", "--no-summary",
                   "--sigint-timeout", "1", "--sigterm-timeout", "1", os.path.abspath(args.launch)]
        command += ["%s:=%s" % item for item in arguments.items()]
        self.log_path = os.path.join(folder, "roslaunch.log")
        with open(self.log_path, "wb") as log:
            # A session of its own: Ctrl-C reaches this program only, which then ends the nodes in order.
            self.process = subprocess.Popen(command, env=env, cwd=folder, stdin=subprocess.DEVNULL, stdout=log,
                                            stderr=subprocess.STDOUT, start_new_session=True,
                                            preexec_fn=die_with_parent)
        self.log = open(self.log_path, "r", errors="replace")

    def answer(self, deadline):
        """Waits for the verdict: exit code, message, and whether there are results."""
        while True:
            status = read_status(self.status_path)
            ended = self.process.poll() is not None
            self.read_log()
            problem = self.problem()
            if status is None and problem:
                self.ask_to_end()   # the experiment may just be saying how it ended
                status = read_status(self.status_path)
            if status is None and not problem and ended:
                status = read_status(self.status_path)   # it may have come between the two looks
                problem = "roslaunch was lost (%s)" % describe(self.process.returncode)
            if status is not None:
                return self.verdict(status, self.problem_behind() if status[0] >= ENVIRONMENT else None)
            if problem and self.refusal() and os.path.realpath(self.args.launch) != os.path.realpath(LAUNCH):
                raise Failure(BAD_INPUT, "--launch %s: %s" % (self.args.launch, problem))
            if problem:
                raise Failure(ENVIRONMENT, problem + full_disk(os.path.dirname(self.status_path)))
            if time.monotonic() > deadline:
                self.ask_to_end()
                raise Failure(ENVIRONMENT, "not finished after %g s; give a longer --timeout, or see the logs"
                              % self.args.timeout)
            time.sleep(POLL)

    @staticmethod
    def verdict(status, problem):
        """What the experiment said, unless it only noticed that another node is gone."""
        code, message, written = status
        if code > 128:   # not by this program, which would not be here then
            code, message = ENVIRONMENT, "the experiment node was ended from outside (%s)" % describe(128 - code)
        if problem and code == ENVIRONMENT:
            message = problem
        return code, message, written

    def problem_behind(self):
        """The lost node that made the experiment give up, if it was one. roslaunch may tell a moment later."""
        end = time.monotonic() + GRACE
        while True:
            over = self.process.poll() is not None or "[experiment" in "".join(self.dead_nodes()) or time.monotonic() > end
            self.read_log()
            problem = self.problem(answered=True)
            if problem or over:
                return problem
            time.sleep(POLL)

    def dead_nodes(self):
        """What roslaunch says of each required node that has ended."""
        return re.findall(r"REQUIRED process \[.+?\] has died!\n.*", self.log_text)

    def read_log(self):
        text = self.log.read()
        if text:
            self.log_text += re.sub(r"\x1b\[[0-9;]*m", "", text)
            for name, pid in re.findall(r"process\[(.+)-\d+\]: started with pid \[(\d+)\]", self.log_text):
                self.pids[name] = int(pid)
            for pid in re.findall(r"process\[master\]: started with pid \[(\d+)\]", self.log_text):
                self.pids["master"] = int(pid)

    def problem(self, answered=False):
        """One line that says what went wrong, or None. An experiment that has answered may end."""
        text = self.log_text
        if "Address already in use" in text and "experiment" not in self.pids:
            raise PortTaken()
        for dead in self.dead_nodes():
            name, how = re.match(r"REQUIRED process \[(.+?)(?:-\d+)?\] has died!\n(.*)", dead).groups()
            if answered and name == "experiment":
                continue
            exit_code = re.search(r"exit code (-?\d+)", how)
            how = describe(int(exit_code.group(1)) if exit_code else 0)
            if name == "experiment":
                return "the experiment node ended without an answer (%s)%s" % (how, self.last_words())
            return "node %s was lost (%s); the experiment cannot go on" % (name, how)
        missing = re.search(r"cannot launch node of type \[(.+?)\]", text)
        if missing:
            return "program %s is not there; run: make build" % missing.group(1)
        return self.refusal()

    def refusal(self):
        """What roslaunch says of a launch file it does not take, or None."""
        words = re.search(r"(?:RLException|Invalid roslaunch XML syntax|Resource not found|while processing).*", self.log_text)
        return "roslaunch refused to start: %s" % words.group(0) if words and self.process.poll() is not None else None

    def last_words(self):
        lines = re.findall(r"^(?:quad_experiment_node|experiment): .*|^terminate called .*|^\s+what\(\): .*",
                           self.log_text, re.MULTILINE)
        return ": " + lines[-1].strip() if lines else ""

    def ask_to_end(self):
        """SIGINT to every process, so that the experiment removes what it has half written."""
        for pid in descendants():
            send(pid, signal.SIGINT)
        self.wait_for_end("experiment")

    def wait_for_end(self, name):
        end = time.monotonic() + GRACE
        while time.monotonic() < end and self.pids.get(name) in descendants():
            time.sleep(POLL)

    def stop(self):
        ignore_interrupts()
        self.read_log()
        if read_status(self.status_path) is not None:
            self.wait_for_end("experiment")
        if self.process.poll() is None:
            self.ask_to_end()
        kill_descendants()
        if self.terminal:
            sys.stderr.write("\r\x1b[K")   # the monitor's line
            sys.stderr.flush()
        self.read_log()   # the experiment may have started in between
        self.log.close()
        self.port_holder.close()
        self.remove_half_written()
        heed_interrupts()

    def remove_half_written(self):
        """The experiment fills its results aside as .<name>.partial-<pid>; one that was killed leaves them."""
        pid = self.pids.get("experiment")
        if pid:
            partial = os.path.join(os.path.dirname(self.out), ".%s.partial-%d" % (os.path.basename(self.out), pid))
            shutil.rmtree(partial, ignore_errors=True)


def read_status(path):
    """(exit code, message, whether there are results) once the experiment has written them. The file appears whole."""
    try:
        with open(path, encoding="utf-8") as file:
            status = json.load(file)
        return int(status["exit_code"]), str(status["message"]), bool(status["results"])
    except FileNotFoundError:
        return None
    except (ValueError, KeyError, TypeError) as e:
        return ENVIRONMENT, "the experiment's status file cannot be read: %s" % e, False


def print_results(name, path):
    """The experiment's table and where the rest is: all that goes to stdout."""
    try:
        with open(os.path.join(path, "table.txt"), encoding="utf-8") as file:
            table = file.read()
    except FileNotFoundError:
        raise Failure(ENVIRONMENT, "the experiment says it is done but there is no %s" % os.path.join(name, "table.txt"))
    tell("%sresults: %s\n" % (table, name), "the results stand in %s" % name)
