"""PlotJuggler: plotjuggler/<flight>.csv and layout.xml, which loads them: plotjuggler -l layout.xml."""
import math
import os
import xml.etree.ElementTree as ElementTree

from .flights import write_whole

TABS = (("altitude", (("z",), ("zdot",))), ("thrust", (("u1_cmd", "u1_fb"), ("t_eff_cmd", "t_eff_fb"))),
        ("attitude", (("phi", "theta", "psi"), ("tau_phi", "tau_theta", "tau_psi"))), ("rotors", (("rotors",),)))
COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00")


def write(run, folder):
    folder = os.path.join(folder, "plotjuggler")
    paths = [write_whole(os.path.join(folder, flight.name + ".csv"), lambda path, flight=flight: write_csv(path, flight))
             for flight in run.flights]
    return paths + [write_whole(os.path.join(folder, "layout.xml"), lambda path: write_layout(path, run.flights))]


def write_csv(path, flight):
    """Numbers only (phase: 0 hold, 1 explore), without the last row, which has no inputs."""
    names = list(flight.columns)
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(names) + "\n")
        for i in range(len(flight["k"])):
            row = [float(flight.explore[i]) if name == "phase" else flight[name][i] for name in names]
            if not any(math.isnan(value) for value in row):
                file.write(",".join(repr(float(value)) for value in row) + "\n")


def write_layout(path, flights):
    root = ElementTree.Element("root")
    window = ElementTree.SubElement(root, "tabbed_widget", name="Main Window", parent="main_window")
    for title, plots in TABS:
        tab = ElementTree.SubElement(window, "Tab", tab_name=title, containers="1")
        splitter = ElementTree.SubElement(ElementTree.SubElement(tab, "Container"), "DockSplitter", orientation="-",
                                          count=str(len(plots)), sizes=";".join(["%g" % (1 / len(plots))] * len(plots)))
        for names in plots:
            add_plot(splitter, names, flights)
    ElementTree.SubElement(window, "currentTabIndex", index="0")
    ElementTree.SubElement(root, "use_relative_time_offset", enabled="0")
    loaded = ElementTree.SubElement(root, "previouslyLoaded_Datafiles")
    for flight in flights:
        file = ElementTree.SubElement(loaded, "fileInfo", filename=flight.name + ".csv", prefix=flight.name)
        plugin = ElementTree.SubElement(file, "plugin", ID="DataLoad CSV")
        ElementTree.SubElement(plugin, "parameters", time_axis="t", delimiter="0")
    ElementTree.indent(root, " ")
    ElementTree.ElementTree(root).write(path, encoding="UTF-8", xml_declaration=True)


def add_plot(splitter, names, flights):
    area = ElementTree.SubElement(splitter, "DockArea", name="...")
    plot = ElementTree.SubElement(area, "plot", style="Lines", mode="TimeSeries", flip_x="false", flip_y="false")
    curves = [(flight, name) for flight in flights for name in (flight.rotors if names == ("rotors",) else names)]
    values = [flight[name][i] for flight, name in curves for i in (flight[name].argmin(), flight[name].argmax())
              if not math.isnan(flight[name][i])] or [0.0, 1.0]
    times = [t for flight in flights for t in (flight["t"][0], flight["t"][-1])]
    ElementTree.SubElement(plot, "range", left="%.6f" % min(times), right="%.6f" % max(times), bottom="%.6f" % min(values),
                           top="%.6f" % max(values))
    ElementTree.SubElement(plot, "limitY")
    for i, (flight, name) in enumerate(curves):
        ElementTree.SubElement(plot, "curve", name="%s/%s" % (flight.name, name), color=COLOURS[i % len(COLOURS)])
