"""The living processes that carry a mark in their environment, however they were started and whoever is their parent."""
import os


def processes_with(variable, value):
    """{process id: command line} of those whose environment has variable=value."""
    found, entry_of = {}, ("%s=%s" % (variable, value)).encode()
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/environ" % entry, "rb") as file:
                if entry_of not in file.read().split(b"\0"):
                    continue
            with open("/proc/%s/cmdline" % entry, "rb") as file:
                found[int(entry)] = file.read().replace(b"\0", b" ").decode(errors="replace")
        except OSError:
            continue
    return found
