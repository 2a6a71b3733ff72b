#include "quad_experiment/table.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace quad_experiment {
namespace {

constexpr double kNoBand = HUGE_VAL;  // nothing is known of its spread beforehand

// Bands of single runs: the spread of 200 seeds of a point mass with rotor lag, latency 45 ms and
// jitter 5.6 ms.
const std::vector<Reference> kReferences = {
    {"initial.error_norm", "initial ||e||", "0.1407", Kind::kCertain, 0.14065, 0.14075,
     "Table 2.1"},
    {"initial.lambda_D0", "lambda(D_0)", "50.4868", Kind::kCertain, 50.41, 50.58,
     "from rounded dT, m: 50.41 to 50.58"},
    {"initial.gamma_w_true", "gamma_w of gravity", "356.23", Kind::kCertain, 356.225, 356.24,
     "section 2.4.1"},
    {"initial.gamma_w_compensated", "gamma_w with feed-forward", "7.41", Kind::kCertain, 7.405,
     7.415, "Eq. (2.3)"},
    {"design.gamma_e", "gamma_e of the design [N]", "3.29", Kind::kCertain, 3.2938, 3.297,
     "certified optimum 3.29389"},
    {"targeted.signal_energy", "signal energy [N^2]", "2012", Kind::kContradictory, 0, 0,
     "2012 needs 371 samples; 370 of the printed amplitudes give 2006.7"},
    {"targeted.dT_hat", "targeted dT^ [s]", "0.09989", Kind::kStatistical, -kNoBand, kNoBand, ""},
    {"targeted.m_hat", "targeted m^ [kg]", "0.7331", Kind::kStatistical, 0.722, 0.744, ""},
    {"targeted.A21", "targeted A21", "-2.605e-05", Kind::kStatistical, -kNoBand, kNoBand, ""},
    {"targeted.B1", "targeted B1", "0.002517", Kind::kStatistical, -kNoBand, kNoBand,
     "jitter times speed decides it"},
    {"targeted.B2", "targeted B2", "0.1363", Kind::kStatistical, 0.1345, 0.138, ""},
    {"targeted.error_norm", "targeted ||e||", "0.0044", Kind::kContradictory, 0, 0,
     "with objective 0.0056 and lambda 89768 impossible"},
    {"targeted.objective", "targeted objective (<= 1)", "0.0056", Kind::kContradictory, 0, 0,
     "printed estimate gives 0.0020"},
    {"targeted.lambda_D_exp", "targeted lambda(D_Texp)", "89768", Kind::kContradictory, 0, 0,
     "printed estimate gives 49376"},
    {"targeted.lambda_D_bd", "targeted lambda(D_bd)", "212.8", Kind::kStatistical, 140, 260, ""},
    {"targeted.gamma_w_exp", "targeted gamma_w,exp", "17.87", Kind::kStatistical, 14, 20,
     "Eq. (3.1)"},
    {"targeted.gamma_w_sim", "targeted gamma_w,sim", "10.62", Kind::kStatistical, 7, 13,
     "section 3.2.1"},
    {"random.B2", "random B2", "0.0615", Kind::kStatistical, 0.048, 0.073, ""},
    {"random.m_hat", "random m^ [kg]", "1.6266", Kind::kStatistical, 1.35, 2.1, "0.1/B2"},
    {"random.error_norm", "random ||e||", "0.0757", Kind::kStatistical, 0.062, 0.092, ""},
    {"random.objective", "random objective (<= 1)", "0.5727", Kind::kStatistical, 0.38, 0.85,
     "100 ||e||^2"},
    {"random.lambda_D_exp", "random lambda(D_Texp)", "174.6", Kind::kStatistical, 118, 260,
     "1/||e||^2"},
};

void addFlight(std::map<std::string, double>& values, const FlightResult& flight) {
  const FlightVerdict& v = flight.verdict;
  const auto put = [&](const char* key, double value) { values[flight.name + "." + key] = value; };
  put("signal_energy", v.signal_energy);
  put("gamma_w_exp", v.gamma_w_exp);
  put("gamma_w_sim", v.gamma_w_sim);
  if (!v.fit.exciting) return;
  put("dT_hat", v.dT_hat);
  put("m_hat", v.m_hat);
  put("A21", v.fit.Theta(1, 0));
  put("B1", v.fit.Theta(0, 2));
  put("B2", v.fit.Theta(1, 2));
  put("error_norm", v.error_norm);
  put("objective", v.objective);
  put("lambda_D_exp", v.lambda_D_exp);
  put("G", v.set->G);
  put("margin", v.set->lambda_min_S);
  if (const auto bound = v.set->lambdaBound()) put("lambda_D_bd", *bound);
}

/// Which parts of a configuration are the thesis's. Its numbers mean something only beside the same
/// part of ours.
struct Likeness {
  bool start, design, flights;

  explicit Likeness(const ExperimentConfig& c)
      : start(c.timing.sampling_period == 0.1 && c.estimate.parameters.sampling_period == 0.1635 &&
              c.estimate.parameters.mass == 0.6247 && c.simulation.mass == 0.73 &&
              c.simulation.options.gravity == 9.8 && c.design.num_samples == 370),
        design(start && c.design.harmonics == std::vector<int>{3, 6, 8, 10} &&
               c.design.phase == explore_opt::Phase::kSin && c.design.gamma_w == 20.0 &&
               c.design.desired_closeness == 100.0),
        flights(design && c.timing.mode == quad_control::TimingMode::kLockstep &&
                c.timing.latency == 0.045 && c.timing.jitter_std == 0.0056 &&
                !c.design.fly_design && c.design.amplitude_margin == 0.0 &&
                c.design.amplitudes == std::vector<double>{0.04, 0.94, 1.76, -2.62} &&
                c.simulation.options.profile == quad_sim::Profile::kDefault &&
                c.control.hold_time == 6.0) {}

  bool of(const Reference& r) const {
    if (r.key.rfind("initial.", 0) == 0) return start;
    return r.key.rfind("design.", 0) == 0 ? design : flights;
  }
};

std::string judge(const Reference& r, double value, bool comparable) {
  if (!comparable) return "another experiment";
  if (r.kind == Kind::kContradictory) return "thesis contradicts itself";
  const bool inside = value >= r.low && value <= r.high;
  if (r.low == -kNoBand && r.high == kNoBand) return "timing noise; see percentiles";
  if (r.kind == Kind::kCertain) return inside ? "reproduced" : "DIFFERS";
  return fmt::format("{} [{:.4g}, {:.4g}]", inside ? "within single runs" : "OUTSIDE single runs",
                     r.low, r.high);
}

/// A row of the table: the reference, our value if there is one, and what to say of the two.
struct Row {
  const Reference& reference;
  std::optional<double> ours;
  std::string verdict;
};

std::vector<Row> comparedRows(const ExperimentPlan& plan, const ExperimentResult& result) {
  const Likeness like(plan.config);
  const auto values = comparedValues(plan, result);
  std::vector<Row> rows;
  for (const Reference& r : kReferences) {
    const auto it = values.find(r.key);
    if (it == values.end()) {
      rows.push_back({r, std::nullopt, "not flown, or no such number"});
    } else {
      rows.push_back({r, it->second, judge(r, it->second, like.of(r))});
    }
  }
  return rows;
}

const char* word(Kind kind) {
  switch (kind) {
    case Kind::kCertain:
      return "certain";
    case Kind::kStatistical:
      return "statistical";
    case Kind::kContradictory:
      return "contradictory";
  }
  return "";
}

const char* yesNo(bool value) { return value ? "yes" : "NO"; }

std::string promise(const ExperimentPlan& plan, const FlightResult& flight) {
  const FlightVerdict& v = flight.verdict;
  const double gamma_w = plan.knowledge.gamma_w;
  std::string text = fmt::format("{}\n", flight.name);
  if (!v.fit.exciting)
    return text + "  the data do not determine the model (regressor of deficient rank)\n";
  text += fmt::format("  G = gamma_w - residual energy   {:.6g} = {:.6g} - {:.6g}\n", v.set->G,
                      gamma_w, v.fit.residual_energy);
  text += fmt::format("  lambda_min(S)/gamma_w           {:.6g}   (design asks for {:.6g})\n",
                      v.set->lambda_min_S / gamma_w, plan.knowledge.desired_closeness);
  text += fmt::format("  gamma_w falsified by the data   {}\n", v.gamma_w_falsified ? "YES" : "no");
  text += fmt::format("  exploration condition (1.10)    {}\n", yesNo(v.exploration_condition));
  text += fmt::format("  objective (1.9) <= 1            {}   ({:.4g})\n", yesNo(v.objective_met),
                      v.objective);
  text += fmt::format("  gamma_w,exp <= gamma_w          {}   ({:.5g}; known in simulation only)\n",
                      yesNo(v.gamma_w_valid), v.gamma_w_exp);
  text += fmt::format("  truth in the set                {}\n", yesNo(v.truth_in_set));
  text += fmt::format(
      "  Assumptions 1, 2                tilt <= {:.2g} rad, lateral speed <= {:.2g} m/s\n",
      v.max_tilt, v.max_lateral_speed);
  if (v.clamped_commands > 0)
    text += fmt::format("  rotor commands clamped          {}\n", v.clamped_commands);
  return text;
}

}  // namespace

const std::vector<Reference>& thesisReferences() { return kReferences; }

std::map<std::string, double> comparedValues(const ExperimentPlan& plan,
                                             const ExperimentResult& result) {
  std::map<std::string, double> values = {
      {"initial.error_norm", plan.start.error_norm},
      {"initial.lambda_D0", plan.start.lambda_D0},
      {"initial.gamma_w_true", plan.start.gamma_w_true},
      {"initial.gamma_w_compensated", plan.start.gamma_w_compensated},
      {"design.gamma_e", plan.design.gamma_e}};
  for (const FlightResult& flight : result.flights) addFlight(values, flight);
  return values;
}

std::string comparisonTable(const ExperimentPlan& plan, const ExperimentResult& result) {
  std::string text = fmt::format("mode: {}{}\n\n{:<28} {:>12} {:>14}  {}\n", result.mode,
                                 result.mode == "wallclock" ? " (not deterministic)" : "", "",
                                 "thesis", "ours", "verdict");
  for (const Row& row : comparedRows(plan, result)) {
    const Reference& r = row.reference;
    const std::string ours = row.ours ? fmt::format("{:.6g}", *row.ours) : "-";
    text += fmt::format("{:<28} {:>12} {:>14}  {}\n", r.label, r.printed, ours, row.verdict);
  }
  const double flown =
      Eigen::Map<const Eigen::VectorXd>(plan.amplitudes.data(),
                                        static_cast<Eigen::Index>(plan.amplitudes.size()))
          .norm();
  text += fmt::format(
      "\ncertified: no signal on these lines below gamma_e = {:.6g} can promise this; designed "
      "{:.6g} (gap "
      "{:.1e}), flown {:.6g}\n",
      plan.design.lower_bound, plan.design.gamma_e, plan.design.gap, flown);
  if (flown < plan.design.lower_bound)
    text += "the amplitudes flown promise nothing beforehand; the verdict is that of their data\n";
  text += fmt::format("intervals: mean {:.6f} s, std {:.3g} s, largest error {:.3g} s\n",
                      result.time.mean, result.time.std, result.time.max_abs_error);
  if (const auto& delay = result.delay) {
    text +=
        fmt::format("service delay: mean {:.3g} s, std {:.3g} s, estimated at the end {:.3g} s\n",
                    delay->mean, delay->std, delay->estimated);
  }
  text += '\n';
  for (const FlightResult& flight : result.flights) text += promise(plan, flight);
  if (!result.random_failure.empty())
    text +=
        fmt::format("random\n  ended early, which decides nothing: {}\n", result.random_failure);
  text += fmt::format("\nverdict: the promise was {}\n", result.ok() ? "KEPT" : "BROKEN");
  return text;
}

nlohmann::ordered_json comparisonJson(const ExperimentPlan& plan, const ExperimentResult& result) {
  auto rows = nlohmann::ordered_json::array();
  for (const Row& row : comparedRows(plan, result)) {
    const Reference& r = row.reference;
    nlohmann::ordered_json entry = {
        {"key", r.key},         {"label", r.label},       {"thesis", r.printed}, {"ours", nullptr},
        {"kind", word(r.kind)}, {"verdict", row.verdict}, {"note", r.note}};
    if (row.ours && std::isfinite(*row.ours)) entry["ours"] = *row.ours;
    rows.push_back(entry);
  }
  return rows;
}

}  // namespace quad_experiment
