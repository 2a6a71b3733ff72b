"""Thesis Fig. 1.4: nodes and topics, drawn from graph.json, which the experiment takes from the ROS master in flight."""
from . import style
from .run import Gap, read_json

HIDDEN_TOPICS = ("/rosout", "/rosout_agg")
HIDDEN_NODES = ("/rosout", "/monitor")
LOGGERS = ("/get_loggers", "/set_logger_level")


def edges(graph):
    """[(publisher, topic, subscriber)] that messages flow on, a node's own clock left out."""
    return [(source, topic, target) for topic, users in sorted(graph["topics"].items()) if topic not in HIDDEN_TOPICS
            for source in users["publishers"] or [] for target in users["subscribers"] or []
            if source != target and source not in HIDDEN_NODES and target not in HIDDEN_NODES]


def services_of(graph, node):
    return [name for name, nodes in sorted(graph["services"].items()) if node in nodes and not name.endswith(LOGGERS)]


def draw(run):
    if run.mode == "in_process":
        raise Gap("this run flew in one process, without nodes; scripts/experiment flies it over ROS")
    graph = read_json(run.file("graph.json"))
    flow = edges(graph)
    nodes = [n for n in graph["nodes"] if n not in HIDDEN_NODES]
    if not nodes:
        raise Gap("graph.json names no node")
    topics = {}
    for source, topic, target in flow:
        sources, targets = topics.setdefault(topic, (set(), set()))
        sources.add(source)
        targets.add(target)
    fig, axis = style.figure(width=style.PAGE, height=1.2 + 0.55 * max(len(topics), 3))
    fig.set_layout_engine("none")
    axis.set_position((0, 0, 1, 1))
    axis.set_axis_off()
    axis.set(xlim=(0, 10), ylim=(0, 1))
    boxes = {node: box(axis, spot, node + "".join("\n" + short(name, node) for name in services_of(graph, node)),
                       boxstyle="round,pad=0.5", facecolor="#eaf3f9", edgecolor=style.OURS)
             for node, spot in place(nodes, flow).items()}
    for i, (topic, (sources, targets)) in enumerate(sorted(topics.items())):
        middle = box(axis, (5.0, 1 - (i + 0.5) / len(topics)), topic, boxstyle="square,pad=0.35", facecolor="white",
                     edgecolor=style.GREY)
        for name in sorted(sources):
            arrow(axis, boxes[name], middle, style.OURS)
        for name in sorted(targets):
            arrow(axis, middle, boxes[name], style.VERMILION)
    idle = [t for t, u in sorted(graph["topics"].items()) if t not in HIDDEN_TOPICS and t not in topics]
    return fig, ("Graph of nodes and topics as the ROS master gave it during the hold of the first flight. Rounded: nodes with the "
                 "services they offer; square: topics somebody listens to. Whoever calls a service is not known to the master: the "
                 "experiment calls the time manager and the controller's set_flight_plan, the time manager calls the simulator. "
                 "Topics without a listener: %s."
                 % (", ".join(idle) or "none"))


def short(service, node):
    """A service's name without the node's own, which stands above it."""
    return "\u2022 " + (service[len(node) + 1:] if service.startswith(node + "/") else service)


def place(nodes, flow):
    """The node that publishes most on the left, the others on the right, those with few topics on top."""
    def used(node, end):
        return len({edge[1] for edge in flow if edge[end] == node})
    hub = max(nodes, key=lambda n: (used(n, 0), n))
    right = sorted((n for n in nodes if n != hub), key=lambda n: (used(n, 0) + used(n, 2), n))
    places = {node: (8.45, 1 - (i + 0.5) / len(right)) for i, node in enumerate(right)}
    return dict(places, **{hub: (1.35, 0.5)})


def box(axis, spot, text, **frame):
    return axis.text(*spot, text, ha="center", va="center", fontsize=6, zorder=3, linespacing=1.25, parse_math=False,
                     bbox=dict(linewidth=0.9, **frame))


def arrow(axis, start, end, colour):
    """From box to box; drawn after them (zorder), for only then is their size known."""
    axis.annotate("", xy=end.get_position(), xytext=start.get_position(), zorder=4,
                  arrowprops=dict(arrowstyle="-|>", color=colour, linewidth=0.8, shrinkA=1, shrinkB=1, mutation_scale=7,
                                  patchA=start.get_bbox_patch(), patchB=end.get_bbox_patch()))
