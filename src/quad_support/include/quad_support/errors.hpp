/// Exit codes and the exceptions that lead to them. A numerical "no" is a value, never an
/// exception.
#pragma once

#include <stdexcept>
#include <string>

namespace quad_support {

/// Exit codes of every program of the workspace.
enum ExitCode : int {
  kDone = 0,
  kBadInput = 2,          ///< the caller's mistake: arguments, files, values
  kNegativeAnswer = 3,    ///< valid question, negative answer: infeasible, condition not met
  kSimulationFailed = 4,  ///< diverged, ground contact, saturation policy
  kEnvironment = 5,       ///< disk, port, master or node lost, timeout
  kInterrupted = 130,     ///< SIGINT (SIGTERM: 143)
  kTerminated = 143,
};

/// A wrong value in a configuration or model file. The text says file:line, key, value, allowed
/// range with unit, and what to do.
class ConfigError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Data that cannot answer the question: wrong shape, too few samples, not a number.
class DataError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A valid question whose answer is no, where nothing further can be done without a yes: no design
/// to fly, say.
class NegativeAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The simulation cannot go on: diverged, ground reached.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The world outside failed: disk, port, master or node lost, timeout.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// SIGINT or SIGTERM arrived; `signal()` tells which.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int signal) : std::runtime_error("interrupted"), signal_(signal) {}
  int signal() const { return signal_; }

 private:
  int signal_;
};

}  // namespace quad_support
