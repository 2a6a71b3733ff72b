"""How a run ends: exit codes, the exceptions that end it, and the one line that says why."""
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
        print("scripts/experiment: %s" % message, file=sys.stderr, flush=True)
    except OSError:
        pass   # nobody listens
