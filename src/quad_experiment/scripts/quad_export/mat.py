"""MATLAB: <flight>.mat with the exploration's data in the shape of an iddata object.

In MATLAB: d = load('targeted.mat'); data = iddata(d.y, d.u, d.Ts, 'OutputName', d.OutputName, 'OutputUnit', d.OutputUnit,
'InputName', d.InputName, 'InputUnit', d.InputUnit, 'TimeUnit', d.TimeUnit, 'Tstart', d.Tstart).
Row k holds x_k and the input of the interval that begins at t_k; the last state has no input (NaN, which iddata takes as a
missing value).
"""
import os

import numpy as np

from .flights import Missing, write_whole


def cell(names):
    """A column cell array of strings."""
    array = np.empty((len(names), 1), dtype=object)
    array[:, 0] = names
    return array


def write(run, folder):
    try:
        from scipy.io import savemat
    except ImportError as error:
        raise Missing("--mat needs %s; run: apt-get install python3-scipy" % error.name)

    def content(flight):
        rows = flight.explore

        def column(*names):
            return np.column_stack([flight[name][rows] for name in names])
        return {
            "y": column("z", "zdot"), "u": column("t_eff_fb"), "Ts": run.period, "Tstart": float(flight["t"][rows][0]),
            "OutputName": cell(["z", "zdot"]), "OutputUnit": cell(["m", "m/s"]),
            "InputName": cell(["T_eff_FB"]), "InputUnit": cell(["N"]), "TimeUnit": "seconds",
            "Name": "%s exploration, seed %s" % (flight.name, run.config["seed"]),
            "SamplingInstants": column("t"), "u_commanded": column("t_eff_cmd"),
            "gamma_w": float(run.config["design"]["gamma_w"]),
        }
    return [write_whole(os.path.join(folder, flight.name + ".mat"),
                        lambda path, flight=flight: savemat(path, content(flight), appendmat=False, oned_as="column"))
            for flight in run.flights if flight.explore.any()]
