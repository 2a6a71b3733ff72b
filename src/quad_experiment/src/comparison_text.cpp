#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "quad_experiment/comparison.hpp"
#include "quad_support/number_format.hpp"

namespace quad_experiment {
namespace {

using Json = nlohmann::ordered_json;
using Number = std::function<std::optional<double>(const FlightVerdict&)>;
using Truth = std::function<bool(const FlightVerdict&)>;

/// What is told of a flight, by its name in the files.
const std::vector<std::pair<std::string, Number>>& numbers() {
  static const std::vector<std::pair<std::string, Number>> all = {
      {"lambda_min_S",
       [](const FlightVerdict& v) {
         return v.set ? std::optional<double>(v.set->lambda_min_S) : std::nullopt;
       }},
      {"gamma_w_exp", [](const FlightVerdict& v) { return std::optional<double>(v.gamma_w_exp); }},
      {"gamma_w_sim", [](const FlightVerdict& v) { return std::optional<double>(v.gamma_w_sim); }},
      {"error_norm",
       [](const FlightVerdict& v) {
         return v.fit.exciting ? std::optional<double>(v.error_norm) : std::nullopt;
       }},
      {"lambda_D_exp",
       [](const FlightVerdict& v) {
         return v.fit.exciting ? std::optional<double>(v.lambda_D_exp) : std::nullopt;
       }},
      {"lambda_D_bd",
       [](const FlightVerdict& v) { return v.set ? v.set->lambdaBound() : std::nullopt; }}};
  return all;
}

const std::vector<std::pair<std::string, Truth>>& truths() {
  static const std::vector<std::pair<std::string, Truth>> all = {
      {"gamma_w_valid", [](const FlightVerdict& v) { return v.gamma_w_valid; }},
      {"gamma_w_falsified", [](const FlightVerdict& v) { return v.gamma_w_falsified; }},
      {"exploration_condition", [](const FlightVerdict& v) { return v.exploration_condition; }},
      {"objective_met", [](const FlightVerdict& v) { return v.objective_met; }}};
  return all;
}

const Number& number(const std::string& name) {
  for (const auto& entry : numbers()) {
    if (entry.first == name) return entry.second;
  }
  throw std::logic_error("no number " + name);
}

const Truth& truth(const std::string& name) {
  for (const auto& entry : truths()) {
    if (entry.first == name) return entry.second;
  }
  throw std::logic_error("no truth " + name);
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json quantiles(const ComparedSignal& signal, const Number& of) {
  return {{"p05", finite(quantileOf(signal, 0.05, of))},
          {"median", finite(quantileOf(signal, 0.5, of))},
          {"p95", finite(quantileOf(signal, 0.95, of))}};
}

double largestPeak(const ComparedSignal& signal) {
  double peak = 0.0;
  for (const ComparedFlight& flight : signal.flights) peak = std::max(peak, flight.peak);
  return peak;
}

double perGamma(const Comparison& comparison, const ComparedSignal& signal) {
  return quantileOf(signal, 0.5, number("lambda_min_S")) / comparison.gamma_w;
}

/// Which signals keep what the targeted one promises, said plainly.
std::string meaning(const Comparison& comparison) {
  std::string also;
  for (const ComparedSignal& signal : comparison.signals) {
    const double share = shareOf(
        signal, [](const FlightVerdict& v) { return v.exploration_condition && v.gamma_w_valid; });
    if (signal.name != "targeted" && share > 0.0)
      also += fmt::format("{}{} ({:.0f} %)", also.empty() ? "" : ", ", signal.name, 100.0 * share);
  }
  if (also.empty())
    return "No other signal met the condition with a gamma_w that held, in any flight.\n";
  return "Not the targeted signal alone meets the condition with a gamma_w that held: so do " +
         also + ".\nWhat targeting adds is the guarantee before the flight.\n";
}

}  // namespace

Json comparisonJson(const ExperimentConfig& config, const Comparison& comparison) {
  Json j;
  j["config_hash"] = configHash(config);
  j["gamma_w"] = comparison.gamma_w;
  j["desired_closeness"] = comparison.desired_closeness;
  j["seeds"] = {config.seed, comparison.signals.front().flights.size()};
  j["ranked_by"] = "median of lambda_min_S / gamma_w";
  j["signals"] = Json::array();
  for (const ComparedSignal& signal : comparison.signals) {
    Json s = {{"name", signal.name},
              {"description", signal.description},
              {"flights", signal.flights.size()},
              {"failed", std::count_if(signal.flights.begin(), signal.flights.end(),
                                       [](const auto& f) { return !f.verdict; })},
              {"signal_energy", signal.flights.front().energy},
              {"peak", largestPeak(signal)},
              {"lambda_min_S_over_gamma_w", finite(perGamma(comparison, signal))}};
    for (const auto& [name, of] : numbers()) s[name] = quantiles(signal, of);
    for (const auto& [name, is] : truths()) s[name] = shareOf(signal, is);
    j["signals"].push_back(s);
  }
  return j;
}

std::string comparisonCsv(const Comparison& comparison) {
  std::string text = "signal,seed,signal_energy,peak";
  for (const auto& entry : numbers()) text += "," + entry.first;
  for (const auto& entry : truths()) text += "," + entry.first;
  text += "\n";
  for (const ComparedSignal& signal : comparison.signals) {
    for (const ComparedFlight& flight : signal.flights) {
      text +=
          fmt::format("{},{},{},{}", signal.name, flight.seed,
                      quad_support::shortest(flight.energy), quad_support::shortest(flight.peak));
      for (const auto& entry : numbers()) {
        const auto value = flight.verdict ? entry.second(*flight.verdict) : std::nullopt;
        text += "," + (value ? quad_support::shortest(*value) : "");
      }
      for (const auto& entry : truths())
        text += flight.verdict ? (entry.second(*flight.verdict) ? ",1" : ",0") : ",";
      text += "\n";
    }
  }
  return text;
}

std::string comparisonText(const Comparison& comparison) {
  std::string text = fmt::format(
      "{} flights a signal, all of energy {:.1f} N^2; medians, ranked by lambda_min(S)/gamma_w "
      "(needed: {})\n"
      "{:<13} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8}\n",
      comparison.signals.front().flights.size(), comparison.signals.front().flights.front().energy,
      comparison.desired_closeness, "", "lmin(S)/g", "peak [N]", "||e||", "g_w,exp", "g_w,sim",
      "lam(Dbd)", "condition", "valid", "falsif.");
  for (const ComparedSignal& s : comparison.signals) {
    text += fmt::format(
        "{:<13} {:>9.2f} {:>9.2f} {:>9.5f} {:>9.2f} {:>9.2f} {:>9.1f} {:>7.0f} % {:>6.0f} % "
        "{:>6.0f} %\n",
        s.name, perGamma(comparison, s), largestPeak(s), quantileOf(s, 0.5, number("error_norm")),
        quantileOf(s, 0.5, number("gamma_w_exp")), quantileOf(s, 0.5, number("gamma_w_sim")),
        quantileOf(s, 0.5, number("lambda_D_bd")),
        100.0 * shareOf(s, truth("exploration_condition")),
        100.0 * shareOf(s, truth("gamma_w_valid")), 100.0 * shareOf(s, truth("gamma_w_falsified")));
  }
  return text +
         fmt::format(
             "valid: gamma_w,exp <= gamma_w = {}; lambda(D_bd) rises as data get worse, so it "
             "ranks nothing.\n",
             comparison.gamma_w) +
         meaning(comparison);
}

}  // namespace quad_experiment
