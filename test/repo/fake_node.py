#!/usr/bin/python3
"""Stands in for every program scripts/experiment starts, so that its tests need nothing built.

Does what the environment variable FAKE_<role> says (role: the node's name without namespace, or `check`):
  sleep (default)        stays until it is told to end
  exit:<code>            ends at once
  deaf                   ignores SIGINT and SIGTERM
  orphan                 leaves a child in a session of its own that ignores signals, then stays
  answer:<code>[:<text>] writes results and the status file, then ends
  partial                begins to write results and stays
FAKE_PIDS names a folder where every process leaves a file with its process id.
"""
import json
import os
import signal
import sys
import time
import xmlrpc.client


def parameter(name):
    return xmlrpc.client.ServerProxy(os.environ["ROS_MASTER_URI"]).getParam("/fake", "/experiment/" + name)[2]


def note(name):
    with open(os.path.join(os.environ["FAKE_PIDS"], "%s.%d" % (name, os.getpid())), "w"):
        pass


def results_folder():
    out = parameter("out")
    return out, os.path.join(os.path.dirname(out), ".%s.partial-%d" % (os.path.basename(out), os.getpid()))


def answer(code, text):
    out, aside = results_folder()
    if code in (0, 3):
        os.makedirs(aside)
        with open(os.path.join(aside, "table.txt"), "w") as table:
            table.write("thesis | ours\n")
        with open(os.path.join(aside, "summary.json"), "w") as summary:
            json.dump({"arguments": {k: parameter(k) for k in ("config", "mode", "rate", "force")}}, summary)
        if os.path.exists(out):
            os.rename(out, aside + ".old")
        os.rename(aside, out)
    path = parameter("status")
    with open(path + ".aside", "w") as status:
        json.dump({"exit_code": code, "message": text, "results": out if code in (0, 3) else ""}, status)
    os.rename(path + ".aside", path)
    sys.exit(code)


def main():
    if sys.argv[1:2] == ["check"]:
        code, _, text = os.environ.get("FAKE_check", "0").partition(":")
        if text:
            print("quad_experiment: " + text, file=sys.stderr)
        sys.exit(int(code))
    name = next(a.split(":=")[1] for a in sys.argv if a.startswith("__name:="))
    task, _, rest = os.environ.get("FAKE_" + name, "sleep").partition(":")
    note(name)
    if task in ("deaf", "orphan"):
        if task == "orphan" and os.fork() == 0:
            os.setsid()
            if os.fork():
                os._exit(0)
            note("orphan")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN)
    elif task == "exit":
        sys.exit(int(rest))
    elif task == "answer":
        code, _, text = rest.partition(":")
        answer(int(code), text)
    elif task == "partial":
        os.makedirs(os.path.join(results_folder()[1], "targeted"))
        note("writing")
    while True:
        time.sleep(0.05)


if __name__ == "__main__":
    main()
