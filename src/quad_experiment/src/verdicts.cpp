#include "quad_experiment/verdicts.hpp"

#include <algorithm>
#include <cmath>

#include "explore_opt/altitude_model.hpp"
#include "explore_opt/disturbance_energy.hpp"
#include "explore_opt/exploration_signal.hpp"
#include "quad_control/time_manager.hpp"

namespace quad_experiment {
namespace {

using explore_opt::AltitudeParameters;
using explore_opt::LinearSystem;

Eigen::MatrixXd theta(const LinearSystem& system) {
  Eigen::MatrixXd Theta(system.A.rows(), system.A.cols() + system.B.cols());
  Theta << system.A, system.B;
  return Theta;
}

LinearSystem model(const AltitudeParameters& p, double gravity) {
  return explore_opt::altitudeModel(p.mass, p.sampling_period, gravity);
}

LinearSystem withoutGravity(LinearSystem system) {
  system.W.setZero();
  return system;
}

Eigen::MatrixXd scalar(double lambda) { return Eigen::MatrixXd::Constant(1, 1, lambda); }

void judgeDisturbance(const Knowledge& knowledge, const ExplorationData& data, FlightVerdict& v) {
  const LinearSystem truth = model(knowledge.truth, knowledge.gravity);
  const LinearSystem nominal = withoutGravity(model(knowledge.estimate, knowledge.gravity));
  v.gamma_w_exp = explore_opt::oneStepEnergy(withoutGravity(truth), data.X, data.t_eff_fb);
  v.gamma_w_sim = explore_opt::oneStepEnergy(truth, data.X, data.u1_fb);
  v.gamma_w_pilot_literal = explore_opt::simulationEnergy(nominal, data.X, data.t_eff_fb);
  v.gamma_w_pilot_one_step = explore_opt::oneStepEnergy(nominal, data.X, data.t_eff_fb);
  v.gamma_w_valid = v.gamma_w_exp <= knowledge.gamma_w;
}

void judgeAssumptions(const Trajectory& trajectory, FlightVerdict& v) {
  v.min_altitude = HUGE_VAL;
  for (const TrajectoryRow& row : trajectory.rows) {
    const quad_sim::Odometry& o = row.state.odometry;
    const Eigen::Vector3d up_B = o.q_WB * Eigen::Vector3d::UnitZ();
    v.max_tilt = std::max(v.max_tilt, std::atan2(up_B.head<2>().norm(), up_B.z()));
    v.max_lateral_speed = std::max(v.max_lateral_speed, (o.q_WB * o.v_WB_B).head<2>().norm());
    v.min_altitude = std::min(v.min_altitude, o.p_WB.z());
    v.clamped_commands += row.command.clamped;
  }
}

}  // namespace

InitialVerdict judgeStart(const Knowledge& knowledge) {
  const LinearSystem truth = model(knowledge.truth, knowledge.gravity);
  const LinearSystem nominal = model(knowledge.estimate, knowledge.gravity);
  const Eigen::VectorXd left = explore_opt::compensatedDisturbance(
      truth, Eigen::VectorXd::Constant(1, knowledge.feedforward()));
  InitialVerdict v;
  v.error_norm = explore_opt::errorNorm(theta(truth), theta(nominal));
  v.lambda_D0 = explore_opt::closenessOfEstimate(knowledge.truth, knowledge.estimate);
  v.gamma_w_true = explore_opt::constantDisturbanceEnergy(truth.W, knowledge.num_samples);
  v.gamma_w_compensated = explore_opt::constantDisturbanceEnergy(left, knowledge.num_samples);
  v.asks_for_more = knowledge.desired_closeness >= v.lambda_D0;
  return v;
}

FlightVerdict judgeFlight(const Knowledge& knowledge, const ExplorationData& data,
                          const Trajectory& trajectory) {
  FlightVerdict v;
  judgeDisturbance(knowledge, data, v);
  judgeAssumptions(trajectory, v);
  v.signal_energy = explore_opt::signalEnergy(data.t_eff_cmd);
  v.fit = explore_opt::fitLeastSquares(data.X, data.t_eff_fb);
  if (!v.fit.exciting) return v;

  const Eigen::MatrixXd theta_true = theta(model(knowledge.truth, knowledge.gravity));
  const Eigen::MatrixXd desired = scalar(knowledge.desired_closeness);
  v.dT_hat = v.fit.Theta(0, 1);
  v.m_hat = v.fit.Theta(0, 1) / v.fit.Theta(1, 2);
  v.error_norm = explore_opt::errorNorm(theta_true, v.fit.Theta);
  v.objective = explore_opt::explorationObjective(theta_true, v.fit.Theta, desired);
  v.lambda_D_exp = explore_opt::closenessOfFit(theta_true, v.fit.Theta);
  v.set = explore_opt::feasibleSet(v.fit, knowledge.gamma_w);
  v.gamma_w_falsified = v.set->falsified();
  v.truth_in_set = explore_opt::contains(*v.set, theta_true);
  v.exploration_condition = explore_opt::explorationCondition(*v.set, desired);
  v.objective_met = v.objective <= 1.0;
  // An estimate that is the truth is infinitely close to it; any closeness beyond what is asked
  // says the same.
  const double initial = explore_opt::closenessOfEstimate(knowledge.truth, knowledge.estimate);
  v.chain = explore_opt::judgeChain(
      *v.set, theta_true, desired,
      scalar(std::isfinite(initial) ? initial : 2.0 * knowledge.desired_closeness));
  return v;
}

TimeVerdict judgeTime(const Trajectory& trajectory, double sampling_period) {
  quad_control::IntervalStatistics statistics;
  for (const TrajectoryRow& row : trajectory.rows) {
    if (row.last) continue;
    // Whole nanoseconds are subtracted first, so that the length is exact.
    statistics.add(static_cast<double>(row.next_time_ns - row.state.odometry.time_ns) / 1e9,
                   sampling_period);
  }
  return {statistics.mean(), statistics.std(), statistics.maxAbsError()};
}

std::optional<DelayVerdict> judgeDelay(const std::vector<IntervalTiming>& timing) {
  if (timing.empty()) return std::nullopt;
  quad_control::IntervalStatistics statistics;
  DelayVerdict v;
  for (const IntervalTiming& interval : timing) {
    statistics.add(interval.service_delay, 0.0);
    if (interval.wait <= 0.0) ++v.without_wait;
  }
  v.mean = statistics.mean();
  v.std = statistics.std();
  v.estimated = timing.back().estimated_delay;
  return v;
}

}  // namespace quad_experiment
