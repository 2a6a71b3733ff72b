"""Draws all figures and fills the page."""
import ctypes
import html
import multiprocessing
import os
import signal
from concurrent.futures import ProcessPoolExecutor
from functools import partial

import jinja2
import markupsafe
import numpy as np

from . import figures, labels, style, supplement
from .run import Gap, Run, read_json

HERE = os.path.dirname(os.path.realpath(__file__))
# What unexpected content of a results file leads to; the report states it and goes on.
UNUSABLE = (KeyError, TypeError, ValueError, IndexError, ArithmeticError, AttributeError, np.linalg.LinAlgError)


def write(results, aside, pdf=False, wallclock=""):
    """Writes report.html, figures/ and what report/ lacks into the folder `aside`.

    Returns {"gaps": one line for each figure that cannot be drawn, "stale": files of an earlier report that do not belong to this one}.
    """
    run = Run(results, aside)
    if wallclock:
        supplement.keep_wallclock(run, wallclock)
    supplement.prepare(run)
    # Figures do not know of each other, so each core draws some; which one does not show in the bytes.
    with ProcessPoolExecutor(min(os.cpu_count() or 1, 8), multiprocessing.get_context("fork"), die_with_parent) as pool:
        drawn = list(pool.map(partial(draw, run, pdf=pdf), range(len(figures.ENTRIES))))
    supplement.write(os.path.join(aside, "report.html"), render(run, drawn))
    gaps = [d for d in drawn if d["gap"]]
    return {"gaps": ["%s: not drawn, %s" % (d["name"], d["gap"]) for d in gaps],
            "stale": [os.path.join("figures", d["name"] + ending) for d in gaps for ending in (".svg", ".pdf")]}


def die_with_parent():
    """In a worker: should this program be killed, nobody would tell it that no more work comes."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)   # PR_SET_PDEATHSIG


def draw(run, index, pdf):
    """The files of a figure, and what the page says of it."""
    entry = figures.ENTRIES[index]
    found = {"name": entry.name, "number": entry.number, "title": entry.title, "section": entry.section, "wide": entry.wide,
             "gap": "", "svg": "", "caption": ""}
    path = os.path.join(run.aside, "figures", entry.name)
    style.use()
    fig = None
    try:
        fig, found["caption"] = entry.draw(run)
        svg = style.to_svg(fig)
        supplement.write(path + ".svg", svg)
        if pdf:
            supplement.write(path + ".pdf", style.to_pdf(fig))
        alt = html.escape("%s: %s" % (entry.title, found["caption"]), quote=True)
        found["svg"] = style.for_page(svg, entry.name, alt)
    except Gap as gap:
        found["gap"] = str(gap)
    except UNUSABLE as error:
        found["gap"] = "the results cannot be used for it (%s: %s)" % (type(error).__name__, error)
    finally:
        if fig is not None:
            style.close(fig)
        else:
            style.plt.close("all")   # begun, not finished
    return found


def render(run, drawn):
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True, undefined=jinja2.StrictUndefined,
                                     trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True)
    environment.filters["num"] = labels.number
    environment.filters["yes"] = lambda value: "yes" if value else "no"
    environment.filters["symbols"] = labels.to_html
    for figure in drawn:
        figure["svg"] = markupsafe.Markup(figure["svg"])   # ours, ids and texts escaped by matplotlib
    summary = run.summary
    return environment.get_template("report.html.j2").render(
        run=run, summary=summary, config=run.config, mode=run.mode, wallclock=run.wallclock,
        flights=[(name, summary[name]) for name in run.flights], ok=bool(summary.get("ok")),
        table=optional(run, "table.json", []), provenance=optional(run, "provenance.json", {}),
        exact=noise_free(run), config_text=supplement.text_of(run.file("config.yaml")),
        sections=[(title, [f for f in drawn if f["section"] == i]) for i, title in enumerate(figures.SECTIONS)],
        number_of_figures=sum(not f["gap"] for f in drawn), thesis_design=run.is_thesis_design())


def optional(run, name, otherwise):
    try:
        return read_json(run.file(name))
    except Gap:
        return otherwise


def noise_free(run):
    """The verdicts without simulated timing noise, or None where the run itself has none or they are not to be had."""
    timing = run.config["timing"]
    if not timing.get("latency") and not timing.get("jitter_std") and not run.wallclock:
        return None
    try:
        return supplement.without_timing_noise(run)
    except Gap:
        return None
