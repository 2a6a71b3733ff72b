/// The numbers a simulator carries from one step to the next, on their way out or back in.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quad_sim {

/// Each part names what it remembers once, in one function that serves both ways, so that saving
/// and loading cannot differ. Numbers pass bit for bit.
class StateArchive {
 public:
  StateArchive() = default;  ///< collects
  explicit StateArchive(std::vector<double> numbers)
      : loading_(true), numbers_(std::move(numbers)) {}  ///< hands back

  void operator()(double& x) {
    if (!loading_) return numbers_.push_back(x);
    if (next_ == numbers_.size()) throw std::out_of_range("StateArchive: read beyond its end");
    x = numbers_[next_++];
  }
  void operator()(std::int64_t& count) {  ///< exact below 2^53
    double x = static_cast<double>(count);
    (*this)(x);
    count = static_cast<std::int64_t>(x);
  }
  void operator()(Eigen::Vector3d& v) {
    for (int i = 0; i < 3; ++i) (*this)(v[i]);
  }
  void operator()(double* numbers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) (*this)(numbers[i]);
  }

  const std::vector<double>& numbers() const { return numbers_; }

 private:
  bool loading_ = false;
  std::size_t next_ = 0;
  std::vector<double> numbers_;
};

/// Everything of a simulator at one instant: Simulator::save() and restore().
struct SavedState {
  std::string simulator;        ///< what it fits: vehicle, mass, options, in words
  std::int64_t step_count = 0;  ///< since reset
  std::vector<double> numbers;
};

/// As a few lines of text that read back bit for bit; for files and messages.
std::string toText(const SavedState& state);

/// @throws quad_support::DataError naming what is wrong with the text
SavedState savedStateFromText(const std::string& text);

}  // namespace quad_sim
