"""How figures look: one or two columns of a paper, colours of Okabe and Ito that colour-blind readers can tell apart, no date."""
import io
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

BLUE, ORANGE, GREEN, PURPLE, SKY, VERMILION, GREY = (
    "#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00", "#6b6b6b")
OURS, THESIS, TRUTH = BLUE, VERMILION, "#000000"
FLIGHT = {"targeted": BLUE, "random": PURPLE}
COLUMN, PAGE = 3.5, 7.2      # [in] widths
HEIGHT = 2.35                # [in]

RC = {
    "svg.hashsalt": "quad", "svg.fonttype": "path", "pdf.fonttype": 42, "pdf.compression": 9,
    "font.family": "DejaVu Sans", "mathtext.fontset": "dejavusans", "font.size": 7.5, "axes.titlesize": 8,
    "axes.labelsize": 7.5, "xtick.labelsize": 7, "ytick.labelsize": 7, "legend.fontsize": 6.8, "legend.frameon": True,
    "legend.framealpha": 0.85, "legend.edgecolor": "none", "legend.borderpad": 0.3, "legend.handlelength": 1.7,
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.7, "xtick.major.width": 0.7,
    "ytick.major.width": 0.7, "axes.grid": True, "grid.alpha": 0.25, "grid.linewidth": 0.5, "lines.linewidth": 1.0,
    "figure.constrained_layout.use": True, "axes.formatter.useoffset": False, "path.simplify": True,
    "path.simplify_threshold": 0.2,
}
NO_METADATA = {"Date": None, "Creator": None, "Format": None, "Type": None}


def use():
    matplotlib.rcdefaults()
    matplotlib.rcParams.update(RC)


def figure(width=COLUMN, height=HEIGHT, rows=1, columns=1, **options):
    return plt.subplots(rows, columns, figsize=(width, height), **options)


def legend(axis, **options):
    """A legend where it hides least; small enough for one column."""
    options.setdefault("loc", "best")
    return axis.legend(**options)


def legend_above(fig, share, **options):
    """One legend for all axes, in the top `share` of the figure, which the axes then leave free."""
    fig.get_layout_engine().set(rect=(0, 0, 1, 1 - share))
    seen = {}
    for axis in fig.axes:
        for handle, label in zip(*axis.get_legend_handles_labels()):
            seen.setdefault(label, handle)
    options.setdefault("ncol", len(seen))
    fig.legend(seen.values(), seen.keys(), loc="upper center", columnspacing=1.2, **options)


def to_svg(fig):
    """SVG text without date or creator, so that the same run gives the same bytes."""
    buffer = io.StringIO()
    fig.savefig(buffer, format="svg", metadata=NO_METADATA)
    return buffer.getvalue()


def to_pdf(fig):
    buffer = io.BytesIO()
    fig.savefig(buffer, format="pdf", metadata={"CreationDate": None, "Creator": None, "Producer": None})
    return buffer.getvalue()


def close(fig):
    plt.close(fig)


def for_page(svg, name, alt):
    """The <svg> element for a page that holds several: ids of its own, no XML prologue, no address of a namespace."""
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"<metadata>.*?</metadata>|<!--.*?-->\s*", "", svg, flags=re.DOTALL)
    svg = re.sub(r' xmlns(:\w+)?="[^"]*"', "", svg)
    svg = svg.replace("xlink:href", "href")
    svg = re.sub(r'\bid="([^"]+)"', r'id="%s-\1"' % name, svg)
    svg = re.sub(r'href="#([^"]+)"', r'href="#%s-\1"' % name, svg)
    svg = re.sub(r"url\(#([^)]+)\)", r"url(#%s-\1)" % name, svg)
    svg = re.sub(r'(<svg\b[^>]*?) width="([\d.]+)pt"', r"\1", svg, count=1)
    svg = re.sub(r'(<svg\b[^>]*?) height="[\d.]+pt"', r"\1", svg, count=1)
    return svg.replace("<svg", '<svg role="img" aria-label="%s"' % alt, 1)
