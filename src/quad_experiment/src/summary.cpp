#include <cmath>
#include <nlohmann/json.hpp>

#include "explore_opt/altitude_model.hpp"
#include "explore_opt/exploration_signal.hpp"
#include "quad_experiment/experiment.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/sha256.hpp"

namespace quad_experiment {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json rows(const Eigen::MatrixXd& matrix) {
  Json result = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    result.push_back(row);
  }
  return result;
}

Json designPart(const ExperimentPlan& plan) {
  const explore_opt::DesignResult& d = plan.design;
  const std::vector<double> alpha(d.amplitudes.data(), d.amplitudes.data() + d.amplitudes.size());
  return {{"status", explore_opt::toString(d.status)},
          {"method", explore_opt::toString(d.method)},
          {"gamma_e", number(d.gamma_e)},
          {"lower_bound", number(d.lower_bound)},
          {"gap", number(d.gap)},
          {"alpha", alpha},
          {"phase", explore_opt::toString(plan.config.design.phase)},
          {"harmonics", plan.config.design.harmonics},
          {"T", plan.config.design.num_samples},
          {"gamma_w", plan.config.design.gamma_w},
          {"desired_closeness", plan.config.design.desired_closeness}};
}

/// The choice of thesis section 2.4.1, {3, 6, 8, 10}/8 of the crossover on the grid, for a model;
/// null if it has none.
Json linesPart(const explore_opt::AltitudeParameters& model) {
  try {
    const auto grid = explore_opt::crossoverGrid(model.mass, model.sampling_period);
    return {{"crossover_hz", grid.crossover},
            {"exploration_time_s", grid.exploration_time},
            {"T", grid.num_samples},
            {"harmonics", grid.harmonics}};
  } catch (const quad_support::DataError&) {  // too few samples for ten lines
    return nullptr;
  }
}

/// What only a simulation knows: the flown vehicle.
Json truthPart(const ExperimentPlan& plan) {
  Json max_speed = Json::array();
  for (const auto& rotor : plan.config.vehicle().rotors) max_speed.push_back(rotor.max_speed);
  return {{"dT", plan.knowledge.truth.sampling_period},
          {"m", plan.knowledge.truth.mass},
          {"max_rotor_speed", max_speed}};
}

Json initialPart(const ExperimentPlan& plan) {
  return {{"dT", plan.knowledge.estimate.sampling_period},
          {"m", plan.knowledge.estimate.mass},
          {"error_norm", plan.start.error_norm},
          {"lambda_D0", number(plan.start.lambda_D0)},
          {"gamma_w_true", plan.start.gamma_w_true},
          {"gamma_w_compensated", plan.start.gamma_w_compensated},
          {"desired_exceeds_initial", plan.start.asks_for_more},
          {"lines",
           {{"from_truth", linesPart(plan.knowledge.truth)},
            {"from_estimate", linesPart(plan.knowledge.estimate)}}}};
}

Json flightPart(const FlightVerdict& v) {
  Json j;
  const bool fitted = v.fit.exciting;
  j["A"] = fitted ? rows(v.fit.Theta.leftCols(2)) : Json(nullptr);
  j["B"] = fitted ? rows(v.fit.Theta.rightCols(1)) : Json(nullptr);
  j["dT_hat"] = fitted ? number(v.dT_hat) : Json(nullptr);
  j["m_hat"] = fitted ? number(v.m_hat) : Json(nullptr);
  j["error_norm"] = fitted ? number(v.error_norm) : Json(nullptr);
  j["residual_energy"] = number(v.fit.residual_energy);
  j["G"] = v.set ? number(v.set->G) : Json(nullptr);
  const auto bound = v.set ? v.set->lambdaBound() : std::nullopt;
  j["lambda_D_bd"] = bound ? number(*bound) : Json(nullptr);
  j["lambda_D_exp"] = fitted ? number(v.lambda_D_exp) : Json(nullptr);
  j["objective"] = fitted ? number(v.objective) : Json(nullptr);
  j["signal_energy"] = v.signal_energy;
  j["gamma_w_exp"] = v.gamma_w_exp;
  j["gamma_w_sim"] = v.gamma_w_sim;
  j["gamma_w_pilot"] = {{"simulated_from_x0", number(v.gamma_w_pilot_literal)},
                        {"one_step_ahead", number(v.gamma_w_pilot_one_step)}};
  j["lambda_min_S"] = v.set ? number(v.set->lambda_min_S) : Json(nullptr);
  j["truth_in_set"] = v.truth_in_set;
  j["gamma_w_valid"] = v.gamma_w_valid;
  j["gamma_w_falsified"] = v.gamma_w_falsified;
  j["exploration_condition"] = v.exploration_condition;
  j["objective_met"] = v.objective_met;
  j["chain"] = {{"exp_within_bd", v.chain.truth_within_bound},
                {"bd_within_des", v.chain.bound_within_desired},
                {"des_within_init", v.chain.desired_within_initial}};
  j["max_tilt"] = v.max_tilt;
  j["max_lateral_speed"] = v.max_lateral_speed;
  j["min_altitude"] = v.min_altitude;
  j["clamped_commands"] = v.clamped_commands;
  return j;
}

Json delayPart(const std::optional<DelayVerdict>& delay) {
  if (!delay) return nullptr;
  return {{"mean", delay->mean},
          {"std", delay->std},
          {"estimated", delay->estimated},
          {"without_wait", delay->without_wait}};
}

}  // namespace

Json summaryJson(const ExperimentPlan& plan, const ExperimentResult& result) {
  Json j;
  j["ok"] = result.ok();
  j["exit_code"] = result.exitCode();
  j["mode"] = result.mode;
  j["deterministic"] = result.mode != "wallclock";
  j["config_hash"] = configHash(plan.config);
  j["log_sha256"] = {{"targeted", nullptr}, {"random", nullptr}};
  for (const FlightResult& flight : result.flights)
    j["log_sha256"][flight.name] = quad_support::sha256(flight.csv);
  j["design"] = designPart(plan);
  j["flown"] = {{"signal", plan.config.design.fly_design ? "designed" : "given"},
                {"amplitudes", plan.amplitudes},
                {"margin", plan.config.design.amplitude_margin}};
  j["truth"] = truthPart(plan);
  j["initial"] = initialPart(plan);
  j["time"] = {{"dT_des", plan.config.timing.sampling_period},
               {"mean", result.time.mean},
               {"std", result.time.std},
               {"max_abs_error", result.time.max_abs_error},
               {"service_delay", delayPart(result.delay)}};
  j["targeted"] = nullptr;
  j["random"] = nullptr;
  if (!result.random_failure.empty()) j["random_failure"] = result.random_failure;
  for (const FlightResult& flight : result.flights) {
    j[flight.name] = flightPart(flight.verdict);
    j[flight.name]["wall_seconds"] = flight.wall_seconds;
  }
  j["wall_seconds"] = result.wall_seconds;
  return j;
}

}  // namespace quad_experiment
