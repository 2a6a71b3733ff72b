"""What has to be right before anything is started: the results' place, the built workspace, the configuration."""
import os
import re
import subprocess

from .answers import BAD_INPUT, ENVIRONMENT, Failure, say

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
SETUP = os.path.join(ROOT, "build", "devel", "setup.sh")
LAUNCH = os.path.join(ROOT, "launch", "experiment.launch")
PROGRAM = os.path.join("lib", "quad_experiment", "quad_experiment")
RESULT_FILES = ("config.yaml", "provenance.json", "summary.json")   # one of them marks a results directory


def check_output(out, force):
    """The results directory as an absolute path. Nothing is made or removed here."""
    path = os.path.abspath(out)
    if not os.path.lexists(path):
        return path
    if not force:
        raise Failure(BAD_INPUT, "%s: exists already; name another --out or give --force" % out)
    if not os.path.isdir(path):
        raise Failure(BAD_INPUT, "%s: is not a directory; name another --out" % out)
    entries = os.listdir(path)
    if entries and not any(name in entries for name in RESULT_FILES):
        raise Failure(BAD_INPUT, "%s: holds other files than an experiment's results, so --force does not replace it; "
                                 "name another --out" % out)
    return path


def workspace_environment():
    """The environment of the built workspace, whether or not the caller's shell has it."""
    env = dict(os.environ, PATH="/usr/bin:" + os.environ.get("PATH", "/bin"))
    for name in ("PYTHONHOME", "ROS_HOSTNAME", "ROS_NAMESPACE", "_CATKIN_SETUP_DIR", "CATKIN_SETUP_UTIL_ARGS"):
        env.pop(name, None)
    env.update(ROS_IP="127.0.0.1", OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    env["PYTHONUNBUFFERED"] = "1"                # what roslaunch says of its nodes has to be there at once
    env["SETUPTOOLS_USE_DISTUTILS"] = "stdlib"   # roslaunch needs one function of it; all of setuptools takes 0.4 s
    devel = os.path.dirname(SETUP)
    prefixes = env.get("CMAKE_PREFIX_PATH", "").split(":")
    if os.path.exists(SETUP) and os.path.realpath(prefixes[0]) != os.path.realpath(devel):
        shell = subprocess.run(["/bin/sh", "-c", '. "$1" >&2 && exec env -0', "sh", SETUP], env=env,
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if shell.returncode != 0:
            raise Failure(ENVIRONMENT, "%s failed: %s%s"
                          % (SETUP, last_line(shell.stderr) or "exit code %d" % shell.returncode,
                             full_disk(env.get("TMPDIR", "/tmp")) or "; build again: make clean build"))
        env = dict(entry.split("=", 1) for entry in os.fsdecode(shell.stdout).split("\0") if "=" in entry)
    if not find_program(env):
        raise Failure(ENVIRONMENT, "the workspace is not built (no %s); run: make build" % PROGRAM)
    return env


def full_disk(folder):
    """Why nothing can be written into a temporary folder, for the end of a message; empty if it can."""
    path = os.path.join(folder, "probe.%d" % os.getpid())
    try:
        with open(path, "wb") as file:
            file.write(bytes(65536))
        reason = ""
    except OSError as error:
        reason = "; nothing can be written into %s (%s): free some space, or name another folder in TMPDIR" % (folder, error.strerror)
    try:
        os.remove(path)
    except OSError:
        pass   # it was not made
    return reason


def find_program(env):
    for prefix in env.get("CMAKE_PREFIX_PATH", "").split(":"):
        path = os.path.join(prefix, PROGRAM)
        if os.access(path, os.X_OK):
            return path
    return None


def check_config(args, env):
    """Asks the experiment's own reader, so that there is one set of checks."""
    command = [find_program(env), "check", "--config", args.config] + (["--mode", args.mode] if args.mode else [])
    try:
        check = subprocess.run(command, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, timeout=args.timeout or None)
    except subprocess.TimeoutExpired:
        raise Failure(ENVIRONMENT, "the check of %s did not end within %g s" % (args.config, args.timeout))
    text = re.sub(r"^quad_experiment( check)?: ", "", check.stderr.decode(errors="replace").strip(), flags=re.MULTILINE)
    if check.returncode != 0:
        known = check.returncode in (BAD_INPUT, ENVIRONMENT)
        raise Failure(check.returncode if known else ENVIRONMENT, text or "%s: not accepted" % args.config)
    for note in text.splitlines():
        say(note)


def read_settings(args):
    """What the launch file has to know of the (checked) configuration."""
    import yaml  # comes with roslaunch
    with open(args.config, encoding="utf-8") as file:
        config = yaml.safe_load(file)
    mode = args.mode or config["timing"]["mode"]
    if args.rate and mode != "lockstep":
        raise Failure(BAD_INPUT, "--rate paces a lock-step flight; in mode %s the clock does: leave --rate out" % mode)
    return {"namespace": str(config["vehicle"]["namespace"])}


def last_line(data):
    lines = data.decode(errors="replace").strip().splitlines()
    return lines[-1] if lines else ""
