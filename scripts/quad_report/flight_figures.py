"""Thesis Figs 2.9 to 2.11 and 3.1 to 3.5: input, altitude, velocity and noise of the flights; rotor speeds against their limits."""
import numpy as np

from . import style, thesis
from .labels import number
from .run import Gap


def mark_start(axis, flight):
    """A line where the exploration begins."""
    axis.axvline(flight.start, color=style.GREY, linewidth=0.7, linestyle=(0, (1, 2)))


def exploration_input(run, name):
    flight = run.flight(name)
    flown = ~np.isnan(flight["u1_cmd"])
    t = flight["t"][flown]
    fig, axis = style.figure()
    axis.step(t, flight["u1_cmd"][flown], where="post", color=style.FLIGHT[name], linewidth=1.5, label=r"$U_1$")
    axis.step(t, flight["u1_fb"][flown], where="post", color=style.ORANGE, linewidth=0.7, label=r"$U_1^\mathrm{FB}$")
    axis.axhline(run.feedforward, color=style.GREEN, linewidth=0.9, linestyle="--", label=r"$\hat m_0 g$ = %.4f N" % run.feedforward)
    if abs(run.feedforward - thesis.FEED_FORWARD) < 5e-4:
        axis.plot([t[-1]], [thesis.FEED_FORWARD], ">", color=style.THESIS, markersize=4, clip_on=False,
                  label="thesis: %.4f N" % thesis.FEED_FORWARD)
    mark_start(axis, flight)
    axis.set(xlabel="t (s)", ylabel="Thrust (N)", title="Control Input - Altitude Controller")
    low, high = flight["u1_cmd"][flown].min(), flight["u1_cmd"][flown].max()
    axis.set_ylim(low - 0.06 * (high - low), high + 0.35 * (high - low))
    style.legend(axis, ncol=2, loc="upper right")
    explored = flight.inputs
    error = flight["u1_fb"][explored] - flight["u1_cmd"][explored]
    return fig, ("Hold, then exploration (dotted line). Commanded thrust and thrust rebuilt from measured rotor speeds; their "
                 "difference is %.3f N rms%s." % (np.sqrt(np.mean(error ** 2)),
                                    "" if name == "targeted" else ": rotors follow a random signal less well than a designed one"))


def predicted(run, flight):
    """Eq. (2.2) with true mass and nominal period, driven by the commanded thrust from the exploration's first state: 2 x T+1."""
    x0 = (flight["z"][flight.explore][0], flight["zdot"][flight.explore][0])
    return run.truth().simulate(x0, flight["u1_cmd"][flight.inputs])


def evolution(run, name, row, column, label, word):
    flight = run.flight(name)
    model = predicted(run, flight)[row]
    fig, axis = style.figure()
    axis.plot(flight["t"], flight[column], color=style.FLIGHT[name], label="flown")
    t0 = flight.start
    axis.plot(t0 + run.period * np.arange(len(model)), model, color=style.THESIS, linewidth=0.9, linestyle="--",
              label="Eq. (2.2), true parameters")
    mark_start(axis, flight)
    axis.set(xlabel="t (s)", ylabel=label)
    style.legend(axis, loc="lower left")
    last = flight[column][flight.explore][-1]
    unit = "m" if column == "z" else "m/s"
    return fig, "%s of the %s flight; ends at %s %s, Eq. (2.2) without any noise at %s %s. " % (
        word, name, number(round(last, 2)), unit, number(round(model[-1], 2)), unit)


def altitude(run, name):
    fig, caption = evolution(run, name, 0, "z", "z (m)", "Altitude")
    return fig, caption + "The drift is gravity, which the feed-forward of the estimated mass does not quite carry."


def velocity(run, name):
    fig, caption = evolution(run, name, 1, "zdot", r"$\dot z$ (m/s)", "Velocity")
    return fig, caption + ("The double integrator attenuates the input (low-pass)." if name == "random" else "")


def noise(run, name="targeted"):
    """W_sim of thesis section 3.2.1: what Eq. (2.2) with the true parameters does not explain."""
    flight, model = run.flight(name), run.truth()
    X, _, u1, _ = flight.data(model)
    W = X[:, 1:] - (model.A @ X[:, :-1] + np.outer(model.B, u1) + model.W[:, None])
    energy = float(np.sum(W ** 2))
    fig, axes = style.figure(rows=2, sharex=True, height=2.7)
    t = flight["t"][flight.inputs]
    for axis, values, label in zip(axes, W, (r"$W_{\mathrm{sim},z}$ (m)", r"$W_{\mathrm{sim},\dot z}$ (m/s)")):
        axis.plot(t, values, color=style.FLIGHT[name], linewidth=0.7)
        axis.set_ylabel(label)
    axes[0].set_title(r"$\gamma_{w_\mathrm{sim}}$ = %.4g%s" % (
        energy, "; thesis: %.2f" % thesis.GAMMA_W_SIM if run.is_thesis_design() and name == "targeted" else ""))
    axes[1].set_xlabel("t (s)")
    share = float(np.sum(W[0] ** 2)) / energy if energy else 0.0
    if not run.config["timing"].get("jitter_std") and not run.wallclock:
        reason = "Intervals are exact here; what is left is rotor lag and drag."
    elif share > 0.5:
        reason = "It grows with the velocity: an interval that is off by dt moves z by dt times the speed."
    else:
        reason = "At these speeds it is the late command and the rotors' lag, not the intervals."
    return fig, "Noise of the simulation on position and velocity; energy %.4g, of which %.0f %% in the position. %s" % (
        energy, 100 * share, reason)


def random_signal(run):
    flight = run.flight("random")
    t, u = flight["t"][flight.inputs] - flight.start, flight["t_eff_cmd"][flight.inputs]
    fig, axis = style.figure()
    axis.step(t, u, where="post", color=style.FLIGHT["random"], linewidth=0.7, label=r"$T_\mathrm{eff}^\mathrm{rnd}$")
    axis.set(xlabel="t (s)", ylabel=r"$T_\mathrm{eff}^\mathrm{rnd}$ (N)")
    style.legend(axis, loc="upper right")
    axis.margins(y=0.15)
    energy = run.verdict("targeted")["signal_energy"]
    return fig, "Normally distributed signal of seed %s, scaled to the targeted one's energy: %.2f N\u00b2 of %.2f N\u00b2; peak %.2f N." % (
        run.config["seed"], np.sum(u * u), energy, np.abs(u).max())


def rotor_speeds(run):
    limits = run.summary.get("truth", {}).get("max_rotor_speed")
    if not limits:
        raise Gap("summary.json does not name the rotors' limits; fly again with this version")
    fig, axes = style.figure(rows=len(run.flights), height=0.95 + 1.3 * len(run.flights), sharex=True, squeeze=False)
    words = []
    for axis, name in zip(axes[:, 0], run.flights):
        flight = run.flight(name)
        flown = ~np.isnan(flight["u1_cmd"])
        speeds = np.array([flight[w][flown] for w in flight.rotors])
        t = flight["t"][flown]
        axis.fill_between(t, speeds.min(axis=0), speeds.max(axis=0), step="post", color=style.FLIGHT[name], alpha=0.35, linewidth=0)
        axis.step(t, speeds.mean(axis=0), where="post", color=style.FLIGHT[name], linewidth=0.7, label="%s, mean of rotors" % name)
        axis.axhline(min(limits), color=style.THESIS, linewidth=0.9, linestyle="--", label="limit %g rad/s" % min(limits))
        axis.axhline(0, color=style.THESIS, linewidth=0.9, linestyle="--")
        mark_start(axis, flight)
        axis.set(ylabel=r"$\omega$ (rad/s)", ylim=(-40, 1.32 * min(limits)))
        style.legend(axis, ncol=2, loc="upper right")
        words.append("%s: %.0f to %.0f rad/s, %d commands clamped" % (
            name, speeds.min(), speeds.max(), run.verdict(name).get("clamped_commands", 0)))
    axes[-1, 0].set_xlabel("t (s)")
    return fig, "Measured rotor speeds at the end of each interval; the band is between slowest and fastest rotor. %s." % "; ".join(words)
