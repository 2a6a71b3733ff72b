"""How a run ends: exit codes, the exceptions that end it, and the one line that says why."""
import os
import sys

DONE, BAD_INPUT, NEGATIVE_ANSWER, SIMULATION_FAILED, ENVIRONMENT = 0, 2, 3, 4, 5


class Failure(Exception):
    """Ends the run with an exit code and one line."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


class PortTaken(Exception):
    """Somebody else got the master's port first."""


class Interrupted(BaseException):
    def __init__(self, number):
        super().__init__(number)
        self.code = 128 + number


def say(message):
    try:
        print("scripts/%s: %s" % (os.path.basename(sys.argv[0]), message), file=sys.stderr, flush=True)
    except OSError:
        pass   # nobody listens


def tell(text, kept):
    """Writes to stdout, now; `kept` says where the same is to be found: "the results stand in D"."""
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())   # or Python would try, and complain, again at its end
        raise Failure(ENVIRONMENT, "standard output cannot be written (%s); %s" % (error.strerror, kept))
