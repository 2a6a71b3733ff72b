"""What is known of the model: the nested sets the thesis does not draw, the comparison of signals, and single runs among seeds."""
import numpy as np

from . import labels, style, supplement, thesis
from .run import Gap, read_json

ENTRIES = ("$A_{12}$ (s)", "$B_1$ (m/N)", "$B_2$ (m/(s N))")
PAIRS = ((0, 1), (0, 2), (1, 2))
ANGLE = np.linspace(0, 2 * np.pi, 121)


class Sets:
    """Ellipsoids {theta: (theta - centre)^T D (theta - centre) <= 1} in (A12, B1, B2), as their inverse shapes D^-1 (3 x 3).

    D_bd^-1 = G P_theta with P_theta = (Phi Phi^T kron I)^-1 (thesis sections 1.3.1, 3.2.2); the projection on three of the six entries
    is the sub-matrix. With the Kronecker product the first row of [A B] (A12, B1) and the second (B2) do not mix.
    """

    def __init__(self, run, name):
        verdict, model = run.verdict(name), run.truth()
        if verdict["A"] is None:
            raise Gap("the data of the %s flight do not determine the model" % name)
        _, _, _, phi = run.flight(name).data(model)
        self.estimate = np.array([verdict["A"][0][1], verdict["B"][0][0], verdict["B"][1][0]])
        self.truth, self.initial = model.entries, run.estimate().entries
        self.G = float(verdict["G"])
        P = np.linalg.inv(phi @ phi.T)
        bound = np.zeros((3, 3))
        bound[:2, :2], bound[2, 2] = P[1:, 1:], P[2, 2]
        self.D_init = np.eye(3) / run.summary["initial"]["lambda_D0"]
        self.D_des = np.eye(3) / run.config["design"]["desired_closeness"]
        self.D_bd = self.G * bound if self.G > 0 else None   # G < 0: gamma_w is falsified, the set is empty

    def shapes(self):
        shapes = [(self.D_init, style.GREY, "-", r"$D_\mathrm{init}$"), (self.D_des, style.ORANGE, "-", r"$D_\mathrm{des}$")]
        return shapes + ([(self.D_bd, style.OURS, "-", r"$D_\mathrm{bd}$")] if self.D_bd is not None else [])


def outline(inverse_shape, pair):
    """Boundary of an ellipsoid's shadow on two axes: 2 x n."""
    part = inverse_shape[np.ix_(pair, pair)]
    values, vectors = np.linalg.eigh(part)
    return vectors @ (np.sqrt(np.maximum(values, 0))[:, None] * np.vstack([np.cos(ANGLE), np.sin(ANGLE)]))


def shadows(run, name):
    sets = Sets(run, name)
    fig, axes = style.figure(width=style.PAGE, height=2.85, columns=3)
    for axis, pair in zip(axes, PAIRS):
        at = sets.estimate[list(pair)]
        start = sets.initial[list(pair)][:, None] + outline(sets.D_init, pair)
        axis.plot(*start, color=style.GREY, linewidth=0.7, linestyle=":")
        for shape, colour, dash, label in sets.shapes():
            x, y = at[:, None] + outline(shape, pair)
            axis.fill(x, y, color=colour, alpha=0.16, linewidth=0)
            axis.plot(x, y, color=colour, linestyle=dash, label=label)
        axis.plot(*sets.initial[list(pair)], "x", color=style.GREY, markersize=4, label=r"$\hat\theta_0$")
        axis.plot(*at, "+", color=style.OURS, markersize=5, label=r"$\hat\theta$, ours")
        if run.is_thesis_design():
            printed = np.array(thesis.ESTIMATE[name])[list(pair)]
            axis.plot(*printed, "^", color=style.THESIS, markersize=3.2, markerfacecolor="none", label=r"$\hat\theta$, thesis")
        axis.plot(*sets.truth[list(pair)], "o", color=style.TRUTH, markersize=2.6, label=r"$\theta_\mathrm{tr}$")
        axis.set(xlabel=ENTRIES[pair[0]], ylabel=ENTRIES[pair[1]])
        axis.set_aspect("equal", adjustable="datalim")
    style.legend_above(fig, 0.1)
    return fig, caption(run, name, sets)


def caption(run, name, sets):
    verdict = run.verdict(name)
    if sets.D_bd is None:
        return ("The %s data falsify \u03b3_w: G = %.3g < 0, the set is empty and no D_bd exists. Dotted: D_init around the "
                "initial estimate." % (name, sets.G))
    inside = float((sets.truth - sets.estimate) @ np.linalg.solve(sets.D_bd, sets.truth - sets.estimate)) <= 1
    text = ("Uncertainty in the three entries that carry dT and m, %s flight: the set D_bd that the data guarantee, the accuracy "
            "asked for, D_des, and the initial ignorance, D_init, all around the estimate (dotted: D_init around the initial "
            "estimate, the truth on its boundary). D_bd %s inside D_des; the truth lies %s the shadow of D_bd in this space" % (
                name, "lies" if verdict["chain"]["bd_within_des"] else "is NOT", "inside" if inside else "OUTSIDE"))
    if not verdict["chain"]["des_within_init"]:
        text += ". This run asks for less than was known to begin with (D_des is wider than D_init)"
    if not verdict["gamma_w_valid"]:
        text += (". The flight's true disturbance energy, %.3g, exceeds \u03b3_w = %g, so this set promises nothing, small as it looks"
                 % (verdict["gamma_w_exp"], run.config["design"]["gamma_w"]))
    return text + "."


def nested_in_space(run):
    """The same three ellipsoids in space, as a few meridians each."""
    sets = Sets(run, "targeted")
    if sets.D_bd is None:
        raise Gap("the data falsify gamma_w (G < 0): there is no D_bd")
    import matplotlib.pyplot as plt
    fig = plt.figure(figsize=(style.COLUMN, 3.1))
    axis = fig.add_subplot(projection="3d", computed_zorder=False)
    turn, rise = np.linspace(0, 2 * np.pi, 49), np.linspace(-np.pi / 2, np.pi / 2, 25)
    for order, (shape, colour, _, label) in enumerate(sets.shapes()):
        root = np.linalg.cholesky(shape)
        rings = [np.array([np.cos(r) * np.cos(turn), np.cos(r) * np.sin(turn), np.full_like(turn, np.sin(r))])
                 for r in np.linspace(-np.pi / 3, np.pi / 3, 5)]
        arcs = [np.array([np.cos(rise) * np.cos(a), np.cos(rise) * np.sin(a), np.sin(rise)]) for a in turn[:-1:6]]
        for i, curve in enumerate(rings + arcs):
            axis.plot(*(sets.estimate[:, None] + root @ curve), color=colour, linewidth=0.5 if order < 2 else 0.7,
                      alpha=0.75, label=label if i == 0 else None, zorder=order)
    axis.plot(*[[v] for v in sets.truth], "o", color=style.TRUTH, markersize=3, label=r"$\theta_\mathrm{tr}$", zorder=9)
    axis.set(xlabel=ENTRIES[0], ylabel=ENTRIES[1], zlabel=ENTRIES[2])
    axis.locator_params(nbins=4)
    axis.tick_params(labelsize=5.5, pad=-2)
    for direction in (axis.xaxis, axis.yaxis, axis.zaxis):
        direction.labelpad = -6
        direction.label.set_size(6.5)
    axis.set_box_aspect((1, 1, 1), zoom=0.95)
    axis.view_init(elev=18, azim=-58)
    fig.legend(loc="upper center", ncol=4)
    return fig, ("The same sets in space: the guaranteed one lies flat in the asked one, for A\u2081\u2082 is known far better (the speed "
                 "excites it) than B\u2081 and B\u2082, which the small input has to excite.")


def ranking(run):
    """Signals by lambda_min(S)/gamma_w, with the disturbance energy and the error beside it; never by lambda(D_bd)."""
    gamma_w, asked = run.config["design"]["gamma_w"], run.config["design"]["desired_closeness"]
    bars = [(name, run.verdict(name), style.FLIGHT[name], None) for name in run.flights]
    words = ""
    timing = run.config["timing"]
    if timing.get("latency") or timing.get("jitter_std"):
        try:
            exact = supplement.without_timing_noise(run)
            bars += [(name + "\nno timing noise", exact[name], style.FLIGHT[name], "///") for name in run.flights if exact.get(name)]
        except Gap as gap:
            words = " (Without timing noise: not known, %s.)" % gap
    fig, axes = style.figure(width=style.PAGE, height=0.75 + 0.36 * max(len(bars), 2), columns=3)
    columns = ((r"$\lambda_\min(\Phi\Phi^\top)/\gamma_w$", lambda v: v["lambda_min_S"] / gamma_w, asked, r"asked: %g" % asked),
               (r"$\gamma_{w,\exp}$: true energy", lambda v: v["gamma_w_exp"], gamma_w, r"$\gamma_w$ = %g" % gamma_w),
               ("\u2016e\u2016: true error", lambda v: v["error_norm"], run.summary["initial"]["error_norm"], "initial"))
    for axis, (label, value, limit, name) in zip(axes, columns):
        for i, (_, verdict, colour, hatch) in enumerate(bars):
            height = value(verdict) if verdict["lambda_min_S"] is not None and verdict["error_norm"] is not None else np.nan
            axis.barh(i, height, height=0.62, color=colour, alpha=0.55 if hatch else 1.0, hatch=hatch, edgecolor="white", linewidth=0)
            axis.annotate("%.4g" % height, (height, i), (3, 0), textcoords="offset points", va="center", fontsize=6.5,
                          zorder=5, bbox=dict(facecolor="white", edgecolor="none", pad=0.6))
        axis.axvline(limit, color=style.TRUTH, linewidth=0.8, linestyle="--")
        axis.annotate(name, (limit, 1), (0, 2), xycoords=("data", "axes fraction"), textcoords="offset points", fontsize=6.5,
                      ha="center", va="bottom")
        axis.set(xlabel=label, ylim=(len(bars) - 0.42, -0.6))
        axis.set_xlim(0, 1.3 * max(limit, max((value(b[1]) or 0) for b in bars)))
        axis.set_yticks(range(len(bars)))
        axis.set_yticklabels([b[0] for b in bars] if axis is axes[0] else [])
        axis.grid(axis="y", visible=False)
    return fig, ("Signals of equal energy. Left: how well the data determine the model, per \u03b3_w; the design asks for %g. "
                 "Middle: whether \u03b3_w was a bound at all. Right: the error, which only a simulation knows. Energies and errors sum entries of "
                 "different units (m, m/s, s, m/N, …), as in the thesis.%s" % (asked, words))


def among_seeds(run):
    """This run and the thesis among seeds, each value on the scale of the seeds' middle 90 %."""
    if run.wallclock:
        raise Gap("a wall-clock run has no seeds to be compared with")
    found = read_json(run.file("percentiles.json"))
    try:
        references = {row["key"]: row for row in read_json(run.file("table.json"))}
    except Gap:
        references = {}
    keys = [key for key, value in found["values"].items() if value["p95"] > value["p05"] and value["this_run"] is not None]
    if not keys:
        raise Gap("percentiles.json has no value that differs between seeds")
    fig, axis = style.figure(width=style.PAGE, height=0.8 + 0.155 * len(keys))
    outside = 0
    for i, key in enumerate(keys):
        value = found["values"][key]

        def scaled(x):
            return np.clip((x - value["p05"]) / (value["p95"] - value["p05"]), -0.55, 1.55)
        axis.plot([0, 1], [i, i], color=style.GREY, linewidth=4, alpha=0.3, solid_capstyle="butt")
        axis.plot(scaled(value["median"]), i, "|", color=style.GREY, markersize=7)
        axis.plot(scaled(value["this_run"]), i, "o", color=style.OURS, markersize=3.8, label="this run" if i == 0 else None)
        row = references.get(key, {})
        try:
            printed = float(row.get("thesis", ""))
        except ValueError:
            continue
        contradictory = row.get("kind") == "contradictory"
        outside += not contradictory and not value["p05"] <= printed <= value["p95"]
        axis.plot(scaled(printed), i, "^", color=style.THESIS, markersize=4, markerfacecolor="none" if contradictory else style.THESIS)
    axis.plot([], [], "^", color=style.THESIS, markersize=4, label="thesis")
    axis.plot([], [], "^", color=style.THESIS, markersize=4, markerfacecolor="none", label="thesis, contradicts itself")
    axis.plot([], [], color=style.GREY, linewidth=4, alpha=0.3, label="5 % to 95 % of seeds, median")
    axis.set_yticks(range(len(keys)))
    axis.set_yticklabels([labels.to_math(references.get(key, {}).get("label", key)) for key in keys], fontsize=6.3)
    axis.set_xticks([0, 1])
    axis.set_xticklabels(["5 %", "95 %"])
    axis.set(xlim=(-0.62, 1.62), ylim=(len(keys) - 0.4, -0.6))
    axis.grid(axis="y", visible=False)
    style.legend_above(fig, 0.09)
    text = "%d seeds of the same experiment; markers beyond the frame are drawn at its edge." % found["seeds"]
    if "random_falsifies_gamma_w" in found:
        text += " The random signal falsifies \u03b3_w in %.0f %% of them." % (100 * found["random_falsifies_gamma_w"])
    return fig, text
