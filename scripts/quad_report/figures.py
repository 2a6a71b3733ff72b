"""The report's figures in the order of the page: (file name, number in the thesis, title, section, whether wide, function)."""
from collections import namedtuple
from functools import partial

from . import comparison_figure, control_figures, design_figures, flight_figures, graph_figure, knowledge_figures, timing_figures

Entry = namedtuple("Entry", "name number title section wide draw")

SECTIONS = ("The promise", "Simulator and time", "Pre-stabilising control", "Design of the exploration", "Targeted exploration",
            "Random exploration of equal energy")

ENTRIES = (
    Entry("nested_sets", "", "Nested uncertainty sets, targeted", 0, True, partial(knowledge_figures.shadows, name="targeted")),
    Entry("ranking", "", "Rank, validity and error of the flights", 0, True, knowledge_figures.ranking),
    Entry("comparison", "", "The targeted signal among textbook signals", 0, True, comparison_figure.draw),
    Entry("nested_sets_random", "", "The same sets, random signal", 0, True, partial(knowledge_figures.shadows, name="random")),
    Entry("nested_in_space", "", "Nested sets in space", 0, False, knowledge_figures.nested_in_space),
    Entry("rotor_speeds", "", "Rotor speeds against limits", 0, False, flight_figures.rotor_speeds),
    Entry("among_seeds", "", "This run and the thesis among seeds", 0, True, knowledge_figures.among_seeds),
    Entry("fig_1_4_graph", "1.4", "Graph of ROS nodes and topics", 1, True, graph_figure.draw),
    Entry("fig_1_6_controlled_time", "1.6", "Evolution of the controlled discrete time", 1, False, timing_figures.controlled_time),
    Entry("fig_1_7_service_noise", "1.7", "Evolution of the stochastic noise of the middleware", 1, False,
          timing_figures.service_noise),
    Entry("fig_2_2_attitude_inputs", "2.2", "Inputs of attitude and heading controllers", 2, False, control_figures.attitude_inputs),
    Entry("fig_2_3_altitude_input", "2.3", "Input of the altitude controller", 2, False, control_figures.altitude_input),
    Entry("bode", "", "Bode magnitude with the chosen lines", 3, False, design_figures.bode),
    Entry("fig_2_5_cost", "2.5", "Cost function", 3, False, design_figures.cost),
    Entry("fig_2_6_change", "2.6", "Change in amplitude", 3, False, design_figures.change),
    Entry("fig_2_7_amplitude", "2.7", "Normalized optimized amplitude", 3, False, design_figures.normalized_amplitude),
    Entry("fig_2_8_signal", "2.8", "Optimized exploration signal", 3, False, design_figures.signal),
    Entry("fig_2_9_input", "2.9", "Exploration input", 4, False, partial(flight_figures.exploration_input, name="targeted")),
    Entry("fig_2_10_altitude", "2.10", "Evolution of the altitude", 4, False, partial(flight_figures.altitude, name="targeted")),
    Entry("fig_2_11_velocity", "2.11", "Evolution of the velocity", 4, False, partial(flight_figures.velocity, name="targeted")),
    Entry("fig_3_1_noise", "3.1", "Noise acting on the state evolution", 4, False, flight_figures.noise),
    Entry("fig_3_2_random_signal", "3.2", "Normally random distributed exploration signal", 5, False, flight_figures.random_signal),
    Entry("fig_3_3_random_input", "3.3", "Exploration input", 5, False, partial(flight_figures.exploration_input, name="random")),
    Entry("fig_3_4_random_altitude", "3.4", "Evolution of the altitude", 5, False, partial(flight_figures.altitude, name="random")),
    Entry("fig_3_5_random_velocity", "3.5", "Evolution of the velocity", 5, False, partial(flight_figures.velocity, name="random")),
)
