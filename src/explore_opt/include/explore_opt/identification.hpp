/// From data to verdicts: estimate, set of possible parameters, intervals, condition, membership.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "explore_opt/fusion.hpp"
#include "explore_opt/parameter_functions.hpp"
#include "explore_opt/structured_least_squares.hpp"
#include "quad_support/csv_table.hpp"

namespace explore_opt {

/// One experiment.
struct DataSet {
  std::string name;      ///< for messages
  Eigen::MatrixXd X;     ///< x_0 ... x_T, n_x x (T+1)
  Eigen::MatrixXd U;     ///< u_0 ... u_{T-1}, n_u x T
  double gamma_w = 0.0;  ///< bound on its disturbance's energy, above 0
};

/// Columns of a table, a row a sample; the last row's inputs are ignored.
/// @param where  "column=value": only those rows, which must follow one another; empty: all
/// @throws quad_support::DataError: no such column, too few rows, no number
DataSet selectData(const quad_support::CsvTable& table, const std::string& name,
                   const std::vector<std::string>& states, const std::vector<std::string>& inputs,
                   const std::string& where, double gamma_w);

struct IdentificationRequest {
  std::optional<Eigen::MatrixXd> closeness;  ///< D_des, as fullCloseness(); none: not judged
  Eigen::MatrixXd known;                     ///< [A B], NaN where unknown; empty: all is unknown
  std::vector<std::string> functions;        ///< as parseFunction()
  std::optional<Eigen::MatrixXd> candidate;  ///< [A B] whose membership is asked
};

/// What one data set says.
struct Estimate {
  std::string name;
  bool exciting = false;
  double condition = 0.0;
  Eigen::VectorXd singular_values;
  Eigen::MatrixXd Theta;        ///< [A B], known entries included; no fact if not exciting
  Eigen::MatrixXd information;  ///< ΦΦᵀ, or of the unknown entries
  double residual_energy = 0.0;
  /// Over Θ, or with known entries over their complement ϑ as one row
  FeasibleSet set;
};

struct Identification {
  std::vector<Estimate> data_sets;
  std::vector<Entry> free;  ///< where ϑ stands in Θ; empty without known entries
  bool exciting = false;    ///< all of them together
  /// From here on only if exciting. One data set: its own; several: fused
  Eigen::MatrixXd Theta, information;
  FeasibleSet set;
  std::vector<double> weights;   ///< of several data sets
  std::optional<double> margin;  ///< largest G the condition allows; none if not judged
  Eigen::MatrixXd lower, upper;  ///< intervals of the entries; empty if falsified
  std::vector<std::string> function_names;
  std::vector<std::optional<Interval>> functions;
  std::optional<double> candidate_distance;  ///< to be compared with set.G
  /// Of several data sets, to be compared with the G of each: all of them must leave it possible,
  /// the fused set is larger than what they have in common
  std::vector<double> candidate_distances;

  bool falsified() const { return exciting && set.falsified(); }
  /// To rounding: a design is held to its condition as closely, and data go through text.
  bool conditionMet() const {
    return exciting && !falsified() && margin && *margin * (1.0 + 1e-9) >= set.G;
  }
  bool candidateIsMember() const;
  bool candidateIsMember(std::size_t data_set) const;  ///< of one of several
};

/// @throws quad_support::DataError: shapes that do not fit, values that are not finite, γ_w not
/// positive, a function that cannot be read, known entries of the candidate that differ
Identification identify(const std::vector<DataSet>& data, const IdentificationRequest& request);

/// Keys as in the README.
nlohmann::ordered_json identificationToJson(const Identification& identification);

/// Why the answer is negative; empty if it is not.
std::string complaint(const Identification& identification);

}  // namespace explore_opt
