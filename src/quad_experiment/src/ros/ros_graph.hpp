/// The ROS graph as the master knows it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace quad_experiment {

/// graph.json (thesis Fig. 1.4, from the running system): "nodes": names; "topics": {name: {"type",
/// "publishers", "subscribers"}}; "services": {name: nodes that offer it}. Null if the master does
/// not answer: a picture is no reason to end a flight.
nlohmann::ordered_json rosGraph();

}  // namespace quad_experiment
