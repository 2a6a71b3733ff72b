#include "quad_experiment/trajectory.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "quad_support/number_format.hpp"

namespace quad_experiment {
namespace {

void cell(std::string& csv, double value) {
  csv += ',';
  quad_support::appendShortest(csv, value);
}

}  // namespace

std::size_t Trajectory::firstExplored() const {
  std::size_t i = 0;
  while (i < rows.size() && !rows[i].exploring) ++i;
  return i;
}

double climbRate(const quad_sim::Odometry& odometry) {
  return (odometry.q_WB * odometry.v_WB_B).z();
}

ExplorationData explorationData(const Trajectory& trajectory, const quad_control::Mixer& mixer,
                                double feedforward) {
  const std::size_t first = trajectory.firstExplored();
  const auto states = static_cast<Eigen::Index>(trajectory.rows.size() - first);
  const Eigen::Index inputs = std::max<Eigen::Index>(states - 1, 0);
  ExplorationData data{Eigen::MatrixXd(2, states), Eigen::MatrixXd(1, inputs),
                       Eigen::MatrixXd(1, inputs), Eigen::MatrixXd(1, inputs)};
  for (Eigen::Index k = 0; k < states; ++k) {
    const TrajectoryRow& row = trajectory.rows[first + static_cast<std::size_t>(k)];
    data.X.col(k) << row.state.odometry.p_WB.z(), climbRate(row.state.odometry);
    if (k == inputs) break;
    data.u1_fb(0, k) = mixer.controlInput(row.rotor_speed_after)[0];
    data.t_eff_fb(0, k) = data.u1_fb(0, k) - feedforward;
    data.t_eff_cmd(0, k) = row.command.t_eff;
  }
  return data;
}

std::string toCsv(const Trajectory& trajectory, const quad_control::Mixer& mixer,
                  double feedforward) {
  std::string csv =
      "k,t,dt,phase,z,zdot,x,y,phi,theta,psi,u1_cmd,u1_fb,t_eff_cmd,t_eff_fb,tau_phi,tau_theta,tau_"
      "psi";
  const std::size_t rotors =
      trajectory.rows.empty() ? 0 : trajectory.rows.front().state.rotor_speed.size();
  for (std::size_t i = 0; i < rotors; ++i) csv += fmt::format(",w{}", i);
  csv += '\n';
  csv.reserve(csv.size() + trajectory.rows.size() * 400);
  const auto first = static_cast<std::int64_t>(trajectory.firstExplored());
  for (std::size_t i = 0; i < trajectory.rows.size(); ++i) {
    const TrajectoryRow& row = trajectory.rows[i];
    const quad_sim::Odometry& o = row.state.odometry;
    csv += std::to_string(static_cast<std::int64_t>(i) - first);
    cell(csv, seconds(o.time_ns));
    if (row.last) {
      csv += ',';
    } else {
      cell(csv, seconds(row.next_time_ns - o.time_ns));
    }
    csv += row.exploring ? ",explore" : ",hold";
    const Eigen::Vector3d attitude = quad_control::rollPitchYaw(o.q_WB);
    for (const double value : {o.p_WB.z(), climbRate(o), o.p_WB.x(), o.p_WB.y(), attitude[0],
                               attitude[1], attitude[2]}) {
      cell(csv, value);
    }
    if (row.last) {
      csv.append(7 + rotors, ',');
    } else {
      const double u1_fb = mixer.controlInput(row.rotor_speed_after)[0];
      const quad_control::ControlOutput& u = row.command;
      for (const double value :
           {u.thrust, u1_fb, u.t_eff, u1_fb - feedforward, u.tau_phi, u.tau_theta, u.tau_psi})
        cell(csv, value);
      for (const double w : row.rotor_speed_after) cell(csv, w);
    }
    csv += '\n';
  }
  return csv;
}

std::string timingCsv(const Trajectory& trajectory, const std::vector<IntervalTiming>& timing) {
  if (trajectory.rows.size() != timing.size() + 1) {
    throw std::invalid_argument(
        fmt::format("{} timings of {} intervals", timing.size(), trajectory.rows.size() - 1));
  }
  std::string csv = "k,t,dT,dT_ctrl,service_delay,estimated_delay\n";
  const auto first = static_cast<std::int64_t>(trajectory.firstExplored());
  for (std::size_t i = 0; i < timing.size(); ++i) {
    const std::int64_t time = trajectory.rows[i].state.odometry.time_ns;
    csv += std::to_string(static_cast<std::int64_t>(i) - first);
    for (const double value :
         {seconds(time), seconds(trajectory.rows[i].next_time_ns - time), timing[i].wait,
          timing[i].service_delay, timing[i].estimated_delay}) {
      cell(csv, value);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace quad_experiment
