"""Thesis Figs 2.5 to 2.8, and the frequencies beside the model's response: how the exploration signal is designed."""
import numpy as np

from . import style, supplement, thesis
from .run import Gap


def amplitudes(answer):
    """(iterations, lines): one input; with phases sine and cosine the root of both squares."""
    def lines(found):
        if isinstance(found, dict):
            return np.hypot(np.ravel(found["sin"]), np.ravel(found["cos"]))
        return np.ravel(found)
    return np.array([lines(step["amplitudes"]) for step in answer["iterations"]])


def both(run):
    answers = []
    for plain, label, colour, marker in ((True, "published algorithm", style.OURS, "o"),
                                         (False, "with lengthened steps", style.GREEN, "s")):
        answer = supplement.iterations(run, plain)
        if not answer.get("iterations"):
            raise Gap("the published algorithm found no design: %s" % answer.get("message", answer.get("status")))
        answers.append((answer, label, colour, marker))
    return answers


def cost(run):
    fig, axis = style.figure()
    for answer, label, colour, marker in both(run):
        values = [step["gamma_e"] for step in answer["iterations"]]
        axis.plot(range(len(values)), values, color=colour, marker=marker, markersize=2, linewidth=0.8,
                  label="%s: %.4f N" % (label, values[-1]))
    bound = run.summary["design"]["lower_bound"]
    if bound:
        axis.axhline(bound, color=style.TRUTH, linewidth=0.9, linestyle="--", label="certified lower bound: %.4f N" % bound)
    caption = "Cost of each re-linearisation. "
    if run.is_thesis_design():
        axis.axhline(thesis.GAMMA_E, color=style.THESIS, linewidth=0.9, linestyle=":", label="thesis: %.2f N" % thesis.GAMMA_E)
        caption += "The thesis stops at 3.29. "
    axis.set(xlabel="iteration", ylabel=r"$\gamma_e$ (N)")
    style.legend(axis, loc="upper right")
    return fig, caption + ("No signal on these lines below the dashed bound can make the promise; the published algorithm creeps "
                           "towards it.")


def change(run):
    fig, axis = style.figure()
    for answer, label, colour, marker in both(run):
        alpha = amplitudes(answer)
        steps = np.linalg.norm(np.diff(alpha, axis=0), axis=1)
        shown = steps > 0
        axis.semilogy(1 + np.flatnonzero(shown), steps[shown], color=colour, marker=marker, markersize=2, linewidth=0.8, label=label)
    axis.set(xlabel="iteration", ylabel=r"$\Vert\alpha^{(i)} - \alpha^{(i-1)}\Vert$ (N)")
    style.legend(axis, loc="upper right")
    return fig, "Change in amplitude; both end where cost and step change by less than %s and %s of their size." % (
        supplement.COST_TOLERANCE, supplement.STEP_TOLERANCE)


def normalized_amplitude(run):
    frequency = run.frequencies()
    designed = run.summary["design"]
    bars = [("published algorithm", np.abs(amplitudes(both(run)[0][0])[-1]), style.OURS)]
    if len(designed["alpha"]) == len(frequency):
        bars.append(("certified optimum", np.abs(designed["alpha"]), style.GREEN))
    if run.is_thesis_design():
        bars.insert(0, ("thesis", np.abs(thesis.ALPHA), style.THESIS))
    fig, axis = style.figure()
    width = 0.8 / len(bars)
    for i, (label, alpha, colour) in enumerate(bars):
        size = np.linalg.norm(alpha)
        axis.bar(np.arange(len(frequency)) + (i - (len(bars) - 1) / 2) * width, alpha / size, width, color=colour,
                 label=r"%s: $\gamma_e$ = %.4g N" % (label, size))
    axis.set_xticks(range(len(frequency)))
    axis.set_xticklabels(["%.3f" % f for f in frequency])
    axis.set(xlabel="f (Hz)", ylabel=r"$|\alpha_i|\,/\,\gamma_e$", ylim=(0, 1.42))
    axis.set_yticks(np.arange(0, 1.01, 0.25))
    axis.grid(axis="x", visible=False)
    style.legend(axis, loc="upper left")
    caption = "Normalized amplitudes at the lines. "
    if run.is_thesis_design():
        caption += ("Their costs hardly differ although their shapes do: the optimum is flat (47 % of all directions lie within 1 % "
                    "of it), so amplitudes are no value to compare; \u03b3_e is.")
    return fig, caption


def signal(run):
    flight = run.flight("targeted")
    t, u = flight["t"][flight.inputs], flight["t_eff_cmd"][flight.inputs]
    fig, axis = style.figure()
    axis.step(t - flight.start, u, where="post", color=style.OURS, label=r"$T_\mathrm{eff}^\mathrm{exp}$ of this run")
    if run.is_thesis_design() and run.summary["flown"]["signal"] != "given":
        k = np.arange(370)
        printed = sum(a * np.sin(2 * np.pi * h * k / 370) for a, h in zip(thesis.ALPHA, (3, 6, 8, 10)))
        axis.plot(0.1 * k, printed, color=style.THESIS, linewidth=0.7, linestyle="--", label="of the printed amplitudes")
    bound = np.linalg.norm(run.summary["flown"]["amplitudes"])
    for sign in (1, -1):
        axis.axhline(sign * bound, color=style.GREY, linewidth=0.7, linestyle=":",
                     label=r"$\pm\Vert\alpha\Vert$ = %.3f N" % bound if sign > 0 else None)
    axis.set(xlabel="t (s)", ylabel=r"$T_\mathrm{eff}^\mathrm{exp}$ (N)")
    axis.margins(y=0.22)
    style.legend(axis, ncol=2, loc="upper right")
    caption = "Exploration signal as commanded; energy %.1f N\u00b2, peak %.2f N. " % (np.sum(u * u), np.abs(u).max())
    if run.is_thesis_design() and run.summary["flown"]["signal"] == "given":
        caption += "These are the amplitudes the thesis prints. "
    if run.is_thesis_design():
        caption += "Printed energy: 2012 N\u00b2, which needs 371 samples. "
    return fig, caption + "The bound is on the amplitudes' norm, not on the signal at each instant."


def bode(run):
    """Magnitude of T_eff -> z and z-dot of the true and the initial model, continuous time, with the chosen lines."""
    truth, start, lines = run.truth(), run.estimate(), run.frequencies()
    nyquist = 0.5 / run.period
    f = np.geomspace(min(0.02, lines.min() / 2), nyquist, 200)
    fig, axis = style.figure()
    for model, colour, dash, name in ((truth, style.OURS, "-", "true"), (start, style.ORANGE, "--", "initial estimate")):
        speed = 1 / (model.mass * 2 * np.pi * f)
        axis.semilogx(f, 20 * np.log10(speed), color=colour, linestyle=dash, label=r"$\dot z/T_\mathrm{eff}$, %s" % name)
        axis.semilogx(f, 20 * np.log10(speed / (2 * np.pi * f)), color=colour, linestyle=dash, linewidth=0.7, alpha=0.6,
                      label=r"$z/T_\mathrm{eff}$, %s" % name)
    for i, line in enumerate(lines):
        axis.axvline(line, color=style.GREEN, linewidth=0.9, linestyle="-", alpha=0.9, label="chosen lines" if i == 0 else None)
    ours = 1 / (2 * np.pi * truth.mass)
    axis.axvline(thesis.CROSSOVER, color=style.THESIS, linewidth=0.9, linestyle=":",
                 label=r"$f_c$, thesis: %.3f Hz" % thesis.CROSSOVER)
    axis.plot([ours], [0], "o", color=style.TRUTH, markersize=3.5, label=r"$f_c = 1/(2\pi m)$ = %.4f Hz" % ours)
    axis.axhline(0, color=style.GREY, linewidth=0.6)
    axis.set(xlabel="f (Hz)", ylabel="magnitude (dB)", ylim=(-62, 42))
    style.legend(axis, loc="upper right", fontsize=5.8)
    return fig, ("Altitude model with the lines of the exploration, %s Hz. The crossover of the climb rate's response is where the "
                 "thesis puts its cut-off." % ", ".join("%.4f" % line for line in lines))
