#include "quad_sim/replay.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "quad_support/errors.hpp"
#include "quad_support/interrupt.hpp"
#include "quad_support/number_format.hpp"

namespace quad_sim {
namespace {

using quad_support::CsvTable;
using quad_support::DataError;

std::vector<std::string> stateColumns(std::size_t rotors) {
  std::vector<std::string> names = {"x",  "y",  "z",  "qw", "qx", "qy", "qz",
                                    "vx", "vy", "vz", "wx", "wy", "wz"};
  for (std::size_t i = 0; i < rotors; ++i) names.push_back(fmt::format("w{}", i));
  return names;
}

void checkColumns(const CsvTable& table, const std::vector<std::string>& wanted) {
  if (table.columns() == wanted) return;
  throw DataError(fmt::format("{}: columns are {}; must be {}", table.source(),
                              fmt::join(table.columns(), ","), fmt::join(wanted, ",")));
}

void appendRow(const Simulator& simulator, VehicleState& state, std::string& csv) {
  using quad_support::appendShortest;
  state = simulator.state();
  appendShortest(csv, static_cast<double>(simulator.timeNanoseconds()) / 1e9);
  const auto put = [&](double value) {
    csv += ',';
    appendShortest(csv, value);
  };
  for (int i = 0; i < 3; ++i) put(state.p_WB[i]);
  for (double c : {state.q_WB.w(), state.q_WB.x(), state.q_WB.y(), state.q_WB.z()}) put(c);
  for (int i = 0; i < 3; ++i) put(state.v_WB[i]);
  for (int i = 0; i < 3; ++i) put(state.w_WB_B[i]);
  for (double w : state.rotor_speed) put(w);
  csv += '\n';
}

}  // namespace

std::vector<TimedCommand> readCommands(const CsvTable& table, std::size_t rotors) {
  std::vector<std::string> wanted = {"t"};
  for (std::size_t i = 0; i < rotors; ++i) wanted.push_back(fmt::format("w{}", i));
  checkColumns(table, wanted);
  std::vector<TimedCommand> commands;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double t = table.number(row, "t");
    constexpr double kLatest = 1e9;  // [s]; what fits the integer time with room to spare
    if (!(t >= 0) || t > kLatest) {
      throw DataError(fmt::format("{}: t = {} s; must lie in [0, {}]", table.place(row),
                                  quad_support::shortest(t), quad_support::shortest(kLatest)));
    }
    TimedCommand command;
    command.time_ns = std::llround(t * 1e9);
    if (!commands.empty() && command.time_ns <= commands.back().time_ns) {
      throw DataError(fmt::format("{}: t = {} s; must be later than the row before",
                                  table.place(row), quad_support::shortest(t)));
    }
    for (std::size_t i = 0; i < rotors; ++i)
      command.rotor_speed.push_back(table.number(row, wanted[i + 1]));
    commands.push_back(command);
  }
  return commands;
}

VehicleState readState(const CsvTable& table, std::size_t rotors) {
  const std::vector<std::string> columns = stateColumns(rotors);
  checkColumns(table, columns);
  if (table.rows() != 1)
    throw DataError(fmt::format("{}: {} rows; must be one", table.source(), table.rows()));
  const auto get = [&](const char* name) { return table.number(0, name); };
  VehicleState state;
  state.p_WB = {get("x"), get("y"), get("z")};
  state.q_WB = Eigen::Quaterniond(get("qw"), get("qx"), get("qy"), get("qz"));
  state.v_WB = {get("vx"), get("vy"), get("vz")};
  state.w_WB_B = {get("wx"), get("wy"), get("wz")};
  for (std::size_t i = 0; i < rotors; ++i)
    state.rotor_speed.push_back(table.number(0, fmt::format("w{}", i)));
  return state;
}

std::string replay(Simulator& simulator, const std::vector<TimedCommand>& commands,
                   std::int64_t steps, std::int64_t every) {
  const std::size_t rotors = simulator.model().rotors.size();
  std::string csv = fmt::format("t,{}\n", fmt::join(stateColumns(rotors), ","));
  VehicleState state;
  simulator.setCommand(std::vector<double>(rotors, 0.0));
  auto next = commands.begin();
  appendRow(simulator, state, csv);
  for (std::int64_t done = 1; done <= steps; ++done) {
    for (; next != commands.end() && next->time_ns <= simulator.timeNanoseconds(); ++next) {
      simulator.setCommand(next->rotor_speed);
    }
    simulator.advance(1);
    if (done % every == 0 || done == steps) appendRow(simulator, state, csv);
    constexpr std::int64_t kAskEvery = 1024;
    if (done % kAskEvery == 0) quad_support::throwIfInterrupted();
  }
  return csv;
}

}  // namespace quad_sim
