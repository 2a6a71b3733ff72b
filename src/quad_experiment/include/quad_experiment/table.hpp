/// The printed comparison with the thesis.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "quad_experiment/experiment.hpp"

namespace quad_experiment {

/// How far a number printed in the thesis can be reproduced.
enum class Kind {
  kCertain,        ///< follows from formulas: equal to the printed precision
  kStatistical,    ///< depends on timing noise: a band of single runs
  kContradictory,  ///< the thesis's own numbers cannot hold together
};

/// A number of the thesis beside ours.
struct Reference {
  std::string key;      ///< e.g. "targeted.lambda_D_bd", as in summary.json
  std::string label;    ///< with its unit
  std::string printed;  ///< as the thesis prints it; empty if it does not
  Kind kind = Kind::kCertain;
  double low = 0.0,
         high = 0.0;  ///< what counts as reproduced: printed precision, or the band of single runs
  std::string note;   ///< source or reason
};

/// All rows of the table, in order.
const std::vector<Reference>& thesisReferences();

/// The values the references speak of, by key; missing where a flight or a fit does not exist.
std::map<std::string, double> comparedValues(const ExperimentPlan& plan,
                                             const ExperimentResult& result);

/// thesis / ours / verdict, then what was promised and whether it was kept.
std::string comparisonTable(const ExperimentPlan& plan, const ExperimentResult& result);

/// table.json: the rows of the table with key, label, thesis, ours (null: no such number), kind
/// ("certain", "statistical", "contradictory"), verdict and note.
nlohmann::ordered_json comparisonJson(const ExperimentPlan& plan, const ExperimentResult& result);

}  // namespace quad_experiment
