"""What the formats have in common: the run, its flights' columns, units, and files that appear whole."""
import csv
import json
import math
import os

import numpy as np
import yaml

UNITS = {"k": "", "t": "s", "dt": "s", "phase": "", "z": "m", "zdot": "m/s", "x": "m", "y": "m", "phi": "rad", "theta": "rad",
         "psi": "rad", "u1_cmd": "N", "u1_fb": "N", "t_eff_cmd": "N", "t_eff_fb": "N", "tau_phi": "N m", "tau_theta": "N m",
         "tau_psi": "N m"}   # rotor speeds w0, w1, ...: rad/s
REQUIRED = ("k", "t", "dt", "phase", "z", "zdot", "x", "y", "phi", "theta", "psi", "u1_cmd", "t_eff_cmd", "t_eff_fb")


class NotARun(Exception):
    """The directory is not a finished run: which file, and why."""


class Missing(Exception):
    """This machine or this run lacks something: what, and what to do."""


def unit(name):
    return UNITS.get(name, "rad/s" if name[:1] == "w" else "")


class Flight:
    """Columns of a trajectory.csv: numbers as floats (NaN where the last row has none), phase as text."""

    def __init__(self, name, path):
        self.name = name
        try:
            with open(path, encoding="utf-8", newline="") as file:
                rows = list(csv.DictReader(file))
            self.columns = {key: [row[key] if key == "phase" else float(row[key] or math.nan) for row in rows] for key in rows[0]}
            self.columns = {key: np.array(values) for key, values in self.columns.items()}
        except (OSError, ValueError, TypeError, IndexError) as error:
            raise NotARun("%s: cannot be read as a flight: %s" % (path, error))
        for key in REQUIRED:
            if key not in self.columns:
                raise NotARun("%s: has no column %s" % (path, key))
        self.explore = self.columns["phase"] == "explore"

    def __getitem__(self, key):
        return self.columns[key]

    @property
    def rotors(self):
        return [key for key in self.columns if key[:1] == "w" and key[1:].isdigit()]

    @property
    def nanoseconds(self):
        """Stamps t_k as integers."""
        return [int(round(t * 1e9)) for t in self["t"]]


class Run:
    def __init__(self, path):
        self.path = path
        try:
            with open(os.path.join(path, "summary.json"), encoding="utf-8") as file:
                self.summary = json.load(file)
            with open(os.path.join(path, "config.yaml"), encoding="utf-8") as file:
                self.config_text = file.read()
            self.config = yaml.safe_load(self.config_text)
            names = [name for name in ("targeted", "random") if self.summary.get(name)]
            self.namespace = str(self.config["vehicle"]["namespace"])
            self.period = float(self.config["timing"]["sampling_period"])
        except (OSError, ValueError, KeyError, TypeError, AttributeError, yaml.YAMLError) as error:
            raise NotARun("%s is not a finished run: %s" % (path, str(error).split("\n")[0]))
        self.flights = [Flight(name, os.path.join(path, name, "trajectory.csv")) for name in names]


class Batch:
    """A finished batch: its merged table and its manifest."""

    def __init__(self, path):
        self.table = os.path.join(path, "results.csv")
        with open(os.path.join(path, "manifest.json"), encoding="utf-8") as file:
            self.manifest = file.read()

    @staticmethod
    def is_at(path):
        return all(os.path.isfile(os.path.join(path, name)) for name in ("results.csv", "manifest.json"))


def write_whole(path, fill):
    """fill(name of a file aside), then renamed: whole or not at all."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    aside = "%s.partial-%d" % (path, os.getpid())
    try:
        fill(aside)
        os.replace(aside, path)
    finally:
        if os.path.exists(aside):
            os.remove(aside)
    return path
