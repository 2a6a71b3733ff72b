"""Thesis Figs 1.4, 1.6 and 1.7: the graph of nodes, and how exact the intervals of simulated time are."""
import numpy as np

from . import style, supplement, thesis
from .run import Gap

MILLI = 1e3


def simulated(run):
    """Words for the middleware a lock-step run simulates."""
    timing = run.config["timing"]
    if not timing.get("latency") and not timing.get("jitter_std"):
        return "exact intervals: neither latency nor jitter is simulated"
    return "simulated middleware: latency %g ms, jitter %g ms" % (MILLI * timing["latency"], MILLI * timing["jitter_std"])


def intervals(run):
    """t [s], dT [s], dT_des [s] and where they come from."""
    try:
        timing, own = supplement.wallclock_timing(run)
        # The wait is dT_des less the delay estimated after the interval before.
        desired = run.period if own else float(np.median(timing["dT_ctrl"][1:] + timing["estimated_delay"][:-1]))
        return timing["t"], timing["dT"], round(desired, 6), "wall clock%s" % ("" if own else ", another run")
    except Gap:
        if run.wallclock:
            raise
    flight = run.flight("targeted")
    inputs = ~np.isnan(flight["dt"])
    return flight["t"][inputs], flight["dt"][inputs], run.period, simulated(run)


def controlled_time(run):
    t, dT, desired, source = intervals(run)
    fig, axis = style.figure()
    axis.plot(t, dT, color=style.OURS, linewidth=0.7, label="dT, this run")
    axis.axhline(desired, color=style.TRUTH, linewidth=0.8, linestyle="--", label=r"$dT_\mathrm{des}$ = %g s" % desired)
    axis.axhline(dT.mean(), color=style.SKY, linewidth=1.2, label="mean, ours: %.5f s" % dT.mean())
    caption = "Length of each interval of simulated time; %s. Mean %.6f s, standard deviation %.3g ms. " % (
        source, dT.mean(), MILLI * dT.std(ddof=1))
    if desired == thesis.WALLCLOCK_PERIOD:
        axis.axhline(thesis.WALLCLOCK_MEAN, color=style.THESIS, linewidth=1.0, linestyle=":",
                     label="mean, thesis: %.5f s" % thesis.WALLCLOCK_MEAN)
        caption += "The thesis prints the mean %.5f s." % thesis.WALLCLOCK_MEAN
    else:
        caption += "The thesis prints the mean %.5f s for an interval of %g s on the wall clock; this one is %g s." % (
            thesis.WALLCLOCK_MEAN, thesis.WALLCLOCK_PERIOD, desired)
    axis.set(xlabel="t (s)", ylabel="dT (s)")
    low, high = min(dT.min(), desired), max(dT.max(), desired)
    room = max(high - low, 0.004)
    axis.set_ylim(low - 0.15 * room, high + 0.5 * room)
    style.legend(axis, loc="upper left", ncol=2)
    return fig, caption


def service_noise(run):
    fig, axis = style.figure()
    try:
        timing, own = supplement.wallclock_timing(run)
        t, noise, mean = timing["t"], timing["service_delay"], timing["estimated_delay"]
        name, source = r"$dT_\mathrm{ROS}$", "wall clock%s" % ("" if own else ", another run")
        caption = ("Delay that services add to each interval (%s), and its mean with forgetting factor, which the next wait is "
                   "shortened by (thesis section 1.2.4). Mean %.3g ms, standard deviation %.3g ms."
                   % (source, MILLI * noise.mean(), MILLI * noise.std(ddof=1)))
    except Gap:
        if run.wallclock:
            raise
        t, dT, desired, source = intervals(run)
        noise = dT - desired
        mean = forgetting_mean(noise, float(run.config["timing"]["forgetting_factor"]))
        name = r"$dT - dT_\mathrm{des}$"
        caption = ("In lock-step the services' delay does not enter simulated time. Shown is what this run simulates in its place (%s), "
                   "with the same weighted mean. The real delay: fly config/wallclock.yaml and give it as --wallclock." % source)
    axis.plot(t, MILLI * noise, color=style.OURS, linewidth=0.7, label=name)
    axis.plot(t, MILLI * mean, color=style.ORANGE, linewidth=1.3,
              label=r"weighted mean, $\lambda$ = %g" % run.config["timing"]["forgetting_factor"])
    axis.set(xlabel="t (s)", ylabel="delay (ms)")
    axis.margins(y=0.18)
    style.legend(axis, loc="upper right", ncol=2)
    return fig, caption


def forgetting_mean(values, factor):
    """Thesis section 1.2.4: sum of factor^(k-i) x_i over the sum of the weights, for every k."""
    means, total, weight = np.empty(len(values)), 0.0, 0.0
    for k, value in enumerate(values):
        total, weight = factor * total + value, factor * weight + 1.0
        means[k] = total / weight
    return means
