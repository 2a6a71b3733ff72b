/// The subcommands of the program: what each is told, what it does (the exit code, see
/// quad_support/errors.hpp), what its --help adds. Only options.cpp knows the command line.
#pragma once

#include <string>
#include <vector>

#include "explore_opt/baselines.hpp"
#include "explore_opt/exploration_design.hpp"
#include "explore_opt/frequency_choice.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {

/// What is asked about a design.
struct AuditSettings {
  std::string problem, design, out;
};
extern const char* const kAuditHelp;
int runAudit(const AuditSettings& settings);

struct BaselinesSettings {
  std::string problem, out;
  std::vector<double> band;
  BaselineOptions options;
};
extern const char* const kBaselinesHelp;
int runBaselines(const BaselinesSettings& settings);

struct DesignSettings {
  std::string problem, method = "global", initial, out, dump;
  DesignOptions options;
  bool plain = false;
};
extern const char* const kDesignHelp;
int runDesign(const DesignSettings& settings);

struct FrequenciesSettings {
  std::string system, problem, out;
  std::vector<double> band;
  FrequencyOptions options;
};
extern const char* const kFrequenciesHelp;
int runFrequencies(const FrequenciesSettings& settings);

struct IdentifySettings {
  std::vector<std::string> data;
  std::string where, closeness, known, candidate, out;
  std::vector<std::string> states, inputs, functions;
  std::vector<double> gamma_w;
};
extern const char* const kIdentifyHelp;
int runIdentify(const IdentifySettings& settings);

struct PredictSettings : AuditSettings {
  int run = 0;  ///< of several experiments, from 1; 0: all
};
extern const char* const kPredictHelp;
int runPredict(const PredictSettings& settings);

struct ReplaySettings {
  std::string dump, out;
};
extern const char* const kReplayHelp;
int runReplay(const ReplaySettings& settings);

/// Reads the command line and runs the subcommand it names. @returns exit code
int runCommandLine(int argc, char** argv);

/// To a file in one piece, or to stdout if `path` is empty. @throws quad_support::EnvironmentError
void writeAnswer(const std::string& path, const std::string& text);

}  // namespace explore_opt
