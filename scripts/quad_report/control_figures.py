"""Thesis Figs 2.2 and 2.3: an altitude step under the pre-stabilising controllers."""
from . import style, supplement, thesis
from .labels import number


def attitude_inputs(run):
    flight = supplement.altitude_step(run)
    used = ~(flight["u1_cmd"] != flight["u1_cmd"])
    fig, axis = style.figure()
    t = flight["t"][used]
    torques = {r"$U_2 = \tau_\phi$": ("tau_phi", style.OURS), r"$U_3 = \tau_\theta$": ("tau_theta", style.ORANGE),
               r"$U_4 = \tau_\psi$": ("tau_psi", style.GREEN)}
    largest = 0.0
    for label, (name, colour) in torques.items():
        axis.step(t, flight[name][used], where="post", color=colour, label=label)
        largest = max(largest, abs(flight[name][used]).max())
    axis.set(xlabel="t (s)", ylabel="torque (N m)")
    style.legend(axis, ncol=3, loc="upper right")
    axis.margins(y=0.25)
    return fig, ("Commands of the attitude and heading controllers while the altitude steps by 1 m. The vehicle starts level and "
                 "is symmetric, so what they have to mend is rounding (largest: %s N m); the thesis finds them almost null, "
                 "too." % number(largest, 2))


def altitude_input(run):
    flight = supplement.altitude_step(run)
    used = ~(flight["u1_cmd"] != flight["u1_cmd"])
    weight = run.truth().mass * run.gravity
    fig, axis = style.figure()
    t, final = flight["t"][used], flight["u1_cmd"][used][-1]
    axis.step(t, flight["u1_cmd"][used], where="post", color=style.OURS, linewidth=1.6, label=r"$U_1$")
    axis.step(t, flight["u1_fb"][used], where="post", color=style.ORANGE, linewidth=0.7, label=r"$U_1^\mathrm{FB}$")
    axis.axhline(weight, color=style.GREEN, linewidth=0.9, linestyle="--", label="m g = %.4f N" % weight)
    axis.axhline(thesis.WEIGHT, color=style.THESIS, linewidth=0.8, linestyle="-.", label="m g, thesis: %.4f N" % thesis.WEIGHT)
    axis.set(xlabel="t (s)", ylabel="Thrust (N)", title="Control Input - Altitude Controller")
    axis.set_ylim(0, 12)
    style.legend(axis, ncol=2, loc="lower right")
    return fig, "A step of 1 m: the effort ends at m g (%.6f N after %g s; m g is %.6f N), and no rotor saturates." % (
        final, flight["t"][used][-1], weight)
