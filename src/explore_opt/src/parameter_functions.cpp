#include "explore_opt/parameter_functions.hpp"

#include <cctype>
#include <limits>

#include "checks.hpp"
#include "constants.hpp"
#include "quad_support/number_format.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

/// Reads one text from left to right.
class Parser {
 public:
  Parser(const std::string& text, int num_states, int num_inputs)
      : text_(text), nx_(num_states), nu_(num_inputs) {}

  ParameterFunction read() {
    ParameterFunction function;
    const auto equals = text_.find('=');
    function.name = equals == std::string::npos ? text_ : trimmed(text_.substr(0, equals));
    at_ = equals == std::string::npos ? 0 : equals + 1;
    function.numerator = sum();
    if (take('/')) function.denominator = sum();
    if (peek() == '*') fail("holds a product of entries; a sum, or one sum over another, is meant");
    if (peek() != '\0') fail("ends with something unknown");
    return function;
  }

 private:
  static std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw quad_support::DataError(fmt::format(
        "function '{}' {} (at character {}); write A12, B1, A(1,2), numbers, + - *, and "
        "one /",
        text_, what, at_ + 1));
  }

  char peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(char wanted) {
    if (peek() != wanted) return false;
    ++at_;
    return true;
  }

  /// One sum, in parentheses or not.
  AffineFunction sum() {
    const bool parenthesis = take('(');
    AffineFunction f{0.0, MatrixXd::Zero(nx_, nx_ + nu_)};
    double sign = take('-') ? -1.0 : 1.0;
    do {
      term(sign, f);
      sign = peek() == '-' ? -1.0 : 1.0;
    } while (take('+') || take('-'));
    if (parenthesis && !take(')')) fail("lacks a )");
    return f;
  }

  void term(double factor, AffineFunction& f) {
    if (peek() != 'A' && peek() != 'B') {
      factor *= number();
      if (!take('*')) {
        f.constant += factor;
        return;
      }
    }
    const char matrix = peek();
    if (matrix != 'A' && matrix != 'B') fail("needs A or B");
    ++at_;
    const auto [row, column] = indices(matrix);
    f.weights(row, (matrix == 'A' ? 0 : nx_) + column) += factor;
  }

  double number() {
    peek();
    std::size_t end = at_;
    while (end < text_.size() &&
           (std::isdigit(static_cast<unsigned char>(text_[end])) || text_[end] == '.' ||
            text_[end] == 'e' ||
            ((text_[end] == '-' || text_[end] == '+') && end > at_ && text_[end - 1] == 'e')))
      ++end;
    if (end == at_) fail("needs a number or an entry");
    double value = kInfinity;
    try {
      value = quad_support::parseDouble(std::string_view(text_).substr(at_, end - at_));
    } catch (const std::invalid_argument&) {
      fail("holds what is no number");
    }
    if (!std::isfinite(value)) fail("holds a number that is not finite");
    at_ = end;
    return value;
  }

  int digits(std::size_t most) {
    int value = 0;
    std::size_t count = 0;
    for (;
         at_ < text_.size() && count < most && std::isdigit(static_cast<unsigned char>(text_[at_]));
         ++at_, ++count)
      value = 10 * value + (text_[at_] - '0');
    if (count == 0) fail("lacks an index");
    return value;
  }

  std::pair<int, int> indices(char matrix) {
    const int columns = matrix == 'A' ? nx_ : nu_;
    int row = 0, column = 1;
    if (take('(')) {
      row = digits(6);
      if (!take(',')) fail("lacks a comma between the indices");
      peek();
      column = digits(6);
      if (!take(')')) fail("lacks a )");
    } else {
      row = digits(1);
      const bool more = at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_]));
      if (matrix == 'A' || nu_ > 1 || more) column = digits(1);
      if (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])))
        fail("has three digits in a row; write A(1,12)");
    }
    if (row < 1 || row > nx_ || column < 1 || column > columns) {
      fail(fmt::format("has an index out of range: {} is {} x {}", matrix, nx_, columns));
    }
    return {row - 1, column - 1};
  }

  const std::string& text_;
  int nx_, nu_;
  std::size_t at_ = 0;
};

/// R^{-T} Cᵀ: its squared norm is c^T P c.
MatrixXd spread(const FeasibleSet& set, const AffineFunction& f) {
  return set.root.triangularView<Eigen::Upper>().transpose().solve(f.weights.transpose());
}

Interval quotient(const FeasibleSet& set, const ParameterFunction& f) {
  const MatrixXd n_spread = spread(set, f.numerator), d_spread = spread(set, *f.denominator);
  const double n = f.numerator.at(set.center), d = f.denominator->at(set.center);
  const double qnn = set.G * n_spread.squaredNorm(), qdd = set.G * d_spread.squaredNorm(),
               qnd = set.G * n_spread.cwiseProduct(d_spread).sum();
  const double leading = d * d - qdd;  // ρ² leading - 2ρ middle + (n² - qnn) <= 0
  if (!(leading > 0.0)) return {n / d, -kInfinity, kInfinity};
  const double middle = n * d - qnd;
  const double root = std::sqrt(std::max(0.0, middle * middle - leading * (n * n - qnn)));
  return {n / d, (middle - root) / leading, (middle + root) / leading};
}

}  // namespace

double AffineFunction::at(const Eigen::MatrixXd& Theta) const {
  return constant + weights.cwiseProduct(Theta).sum();
}

ParameterFunction parseFunction(const std::string& text, int num_states, int num_inputs) {
  return Parser(text, num_states, num_inputs).read();
}

std::optional<Interval> intervalOf(const FeasibleSet& set, const ParameterFunction& function) {
  requireShape(function.numerator.weights, set.center.rows(), set.center.cols(), "weights");
  if (set.falsified()) return std::nullopt;
  if (function.denominator) return quotient(set, function);
  const double value = function.numerator.at(set.center);
  const double half = std::sqrt(set.G) * spread(set, function.numerator).norm();
  return Interval{value, value - half, value + half};
}

}  // namespace explore_opt
