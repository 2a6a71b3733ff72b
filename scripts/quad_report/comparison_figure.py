"""The targeted signal against textbook signals of equal energy, flown with several seeds (quad_experiment compare)."""
import numpy as np

from . import style, supplement
from .run import Gap

COLUMNS = ((r"$\lambda_\min(\Phi\Phi^\top)/\gamma_w$", "lambda_min_S", False),
           (r"$\gamma_{w,\exp}$: true energy", "gamma_w_exp", False),
           ("\u2016e\u2016: true error", "error_norm", True))


def draw(run):
    found = supplement.comparison(run)
    signals, gamma_w, asked = found["signals"], found["gamma_w"], found["desired_closeness"]
    if not signals:
        raise Gap("the comparison has no signal")
    fig, axes = style.figure(width=style.PAGE, height=0.75 + 0.2 * len(signals), columns=4,
                             gridspec_kw={"width_ratios": (3, 3, 3, 1.7)})
    for axis, (label, key, logarithmic) in zip(axes, COLUMNS):
        scale = gamma_w if key == "lambda_min_S" else 1.0
        for i, signal in enumerate(signals):
            number = {name: np.nan if value is None else value / scale for name, value in (signal[key] or {}).items()}
            colour = style.FLIGHT["targeted"] if signal["name"] == "targeted" else style.GREY
            axis.plot([number.get("p05", np.nan), number.get("p95", np.nan)], [i, i], color=colour, linewidth=2.5, alpha=0.45,
                      solid_capstyle="butt")
            axis.plot(number.get("median", np.nan), i, "o", color=colour, markersize=3.6)
        axis.set(xlabel=label)
        if logarithmic:
            axis.set_xscale("log")
    for axis, limit, text in ((axes[0], asked, "asked: %g" % asked), (axes[1], gamma_w, r"$\gamma_w$ = %g" % gamma_w)):
        axis.axvline(limit, color=style.TRUTH, linewidth=0.8, linestyle="--")
        axis.annotate(text, (limit, 1), (0, 2), xycoords=("data", "axes fraction"), textcoords="offset points", fontsize=6.5,
                      ha="center")
    names = [signal["name"].replace("_", " ") for signal in signals]
    for i, signal in enumerate(signals):
        colour = style.FLIGHT["targeted"] if signal["name"] == "targeted" else style.GREY
        axes[3].barh(i, signal["peak"], height=0.6, color=colour, alpha=0.7)
    axes[3].set(xlabel="peak (N)")
    for axis in axes:
        axis.set(ylim=(len(signals) - 0.4, -0.6))
        axis.set_yticks(range(len(signals)))
        axis.set_yticklabels(names if axis is axes[0] else [], parse_math=False)
    met = ["%s %.0f %%" % (name, 100 * signal["exploration_condition"]) for name, signal in zip(names, signals)]
    invalid = [name for name, signal in zip(names, signals) if signal["gamma_w_valid"] < 0.5]
    text = ("Signals of equal energy on the same vehicle and middleware, %d seeds each (median, 5 %% to 95 %%), ranked by "
            "\u03bb_min/\u03b3_w. The condition is met in: %s of the flights." % (signals[0]["flights"], ", ".join(met)))
    if run.wallclock:
        text += " Flown in one process with exact intervals, since the wall clock cannot be had twice."
    if invalid:
        text += " \u03b3_w was no bound in most flights of: %s." % ", ".join(invalid)
    return fig, text
