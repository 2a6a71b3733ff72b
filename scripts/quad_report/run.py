"""Reads a results directory. What is missing or broken is a Gap, which the report states in place of the figure."""
import csv
import json
import math
import os

import numpy as np
import yaml


class NotARun(Exception):
    """There is nothing to report on."""


class Gap(Exception):
    """A figure or table cannot be made; says why and what would help."""


def read_json(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except FileNotFoundError:
        raise Gap("%s is not there" % os.path.basename(path))
    except (OSError, ValueError) as error:
        raise Gap("%s cannot be read: %s" % (os.path.basename(path), error))


def read_columns(path, text=()):
    """{header: column} of a CSV file; numbers as floats (an empty cell is NaN), columns of `text` as strings."""
    name = "/".join(path.split("/")[-2:])
    try:
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        if not rows:
            raise Gap("%s has no rows" % name)
        return {key: np.array([row[key] if key in text else float(row[key] or math.nan) for row in rows]) for key in rows[0]}
    except FileNotFoundError:
        raise Gap("%s is not there" % name)
    except (OSError, ValueError, TypeError, AttributeError) as error:
        raise Gap("%s cannot be read: %s" % (name, error))


class Flight:
    """One trajectory.csv. `explore` and `inputs` select the rows of the exploration, with and without the last."""

    def __init__(self, path):
        self.columns = read_columns(path, text=("phase",))
        for name in ("k", "t", "dt", "phase", "z", "zdot", "u1_cmd", "u1_fb", "t_eff_cmd", "t_eff_fb"):
            if name not in self.columns:
                raise Gap("trajectory.csv has no column %s" % name)
        self.explore = self.columns["phase"] == "explore"
        self.inputs = self.explore & ~np.isnan(self.columns["u1_cmd"])

    def __getitem__(self, name):
        return self.columns[name]

    @property
    def start(self):
        """[s] when the exploration begins; NaN if there is none."""
        return float(self["t"][self.explore][0]) if self.explore.any() else math.nan

    @property
    def rotors(self):
        return [name for name in self.columns if name[:1] == "w" and name[1:].isdigit()]

    def data(self, model):
        """x_0 ... x_T (2 x T+1), T_eff^FB and U^FB (T), phi = [z; zdot; T_eff^FB] (3 x T), as thesis section 3.2.2 defines them."""
        X = np.vstack([self["z"][self.explore], self["zdot"][self.explore]])
        u, u1 = self["t_eff_fb"][self.inputs], self["u1_fb"][self.inputs]
        if X.shape[1] != u.size + 1 or u.size < 3:
            raise Gap("the exploration has %d states and %d inputs" % (X.shape[1], u.size))
        return X, u, u1, np.vstack([X[:, :-1], u])


class Model:
    """The altitude model, Eq. (2.2), for a sampling period [s], a mass [kg] and gravity [m/s^2]."""

    def __init__(self, dT, mass, gravity):
        self.dT, self.mass, self.gravity = dT, mass, gravity
        self.A = np.array([[1.0, dT], [0.0, 1.0]])
        self.B = np.array([dT * dT / (2 * mass), dT / mass])
        self.W = -gravity * np.array([dT * dT / 2, dT])

    @property
    def entries(self):
        """(A12 [s], B1 [m/N], B2 [m/(s N)]): the three that carry the parameters, thesis section 2.4.1."""
        return np.array([self.A[0, 1], self.B[0], self.B[1]])

    def simulate(self, x0, thrust):
        """States x_0 ... x_T under the thrusts U_0 ... U_{T-1} [N]."""
        states = [np.asarray(x0, float)]
        for u in thrust:
            states.append(self.A @ states[-1] + self.B * u + self.W)
        return np.array(states).T


class Run:
    """A results directory; summary.json and config.yaml must be there, everything else may be missing. New files go `aside`."""

    def __init__(self, path, aside):
        self.path, self.aside = path, aside
        try:
            self.summary = read_json(self.file("summary.json"))
            with open(self.file("config.yaml"), encoding="utf-8") as file:
                self.config = yaml.safe_load(file)
            self.mode = str(self.summary["mode"])
            self.period = float(self.config["timing"]["sampling_period"])
            self.gravity = float(self.config["simulation"]["gravity"])
            self.feedforward = float(self.config["estimate"]["mass"]) * self.gravity
        except (Gap, OSError, KeyError, TypeError, ValueError, yaml.YAMLError) as error:
            raise NotARun("%s is not a finished run: %s" % (path, str(error).split("\n")[0]))
        self._flights = {}

    def file(self, *names):
        return os.path.join(self.path, *names)

    @property
    def wallclock(self):
        return self.mode == "wallclock"

    @property
    def flights(self):
        return [name for name in ("targeted", "random") if self.summary.get(name)]

    def flight(self, name):
        if not self.summary.get(name):
            raise Gap("this run flew no %s signal" % name)
        if name not in self._flights:
            self._flights[name] = Flight(self.file(name, "trajectory.csv"))
        return self._flights[name]

    def verdict(self, name):
        if not self.summary.get(name):
            raise Gap("this run flew no %s signal" % name)
        return self.summary[name]

    def truth(self):
        """The model the identification is judged against: nominal period, flown mass."""
        mass = self.summary.get("truth", {}).get("m", self.config["vehicle"]["mass"])
        if not isinstance(mass, (int, float)):
            raise Gap("summary.json does not say which mass was flown; fly again with this version")
        return Model(self.period, float(mass), self.gravity)

    def estimate(self):
        e = self.config["estimate"]
        return Model(float(e["sampling_period"]), float(e["mass"]), self.gravity)

    def frequencies(self):
        """[Hz] of the exploration's lines: harmonics of T samples."""
        design = self.config["design"]
        return np.array(design["harmonics"], float) / (design["num_samples"] * self.period)

    def is_thesis_design(self):
        """Whether the thesis's printed design belongs to this run's problem (its estimate, lines, gamma_w and D_des)."""
        d, e = self.config["design"], self.config["estimate"]
        return (d["num_samples"] == 370 and d["harmonics"] == [3, 6, 8, 10] and d["gamma_w"] == 20 and d["phase"] == "sin"
                and d["desired_closeness"] == 100 and self.period == 0.1 and e["sampling_period"] == 0.1635 and e["mass"] == 0.6247)
