/// Reads the functions of parameters that users write. By the usual precedence, of values that are
/// quotients of two affine functions: the largest class whose intervals are exact.
#include <cctype>

#include "checks.hpp"
#include "constants.hpp"
#include "explore_opt/parameter_functions.hpp"
#include "quad_support/number_format.hpp"

namespace explore_opt {
namespace {

using Eigen::MatrixXd;

bool isConstant(const AffineFunction& f) { return f.weights.isZero(0.0); }

AffineFunction scaled(double factor, AffineFunction f) {
  f.constant *= factor;
  f.weights *= factor;
  return f;
}

bool same(const AffineFunction& a, const AffineFunction& b) {
  return a.constant == b.constant && a.weights == b.weights;
}

/// What an expression is worth: over/under, and under is 1 unless it has entries.
struct Quotient {
  AffineFunction over, under;
};

/// Reads one text from left to right:
///   sum = [-] product {(+|-) product}      product = factor {(*|/) factor}
///   factor = number | entry | ( sum )
class Parser {
 public:
  Parser(const std::string& text, int num_states, int num_inputs)
      : text_(text), nx_(num_states), nu_(num_inputs) {}

  ParameterFunction read() {
    ParameterFunction function;
    const auto equals = text_.find('=');
    function.name = equals == std::string::npos ? text_ : trimmed(text_.substr(0, equals));
    at_ = equals == std::string::npos ? 0 : equals + 1;
    const Quotient value = sum();
    if (peek() != '\0') fail("ends with something unknown");
    function.numerator = value.over;
    if (!isConstant(value.under)) function.denominator = value.under;
    return function;
  }

 private:
  static std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
  }

  [[noreturn]] void fail(const std::string& what) const {
    constexpr std::size_t kShown = 60;
    const std::string shown = text_.size() > kShown ? text_.substr(0, kShown) + "..." : text_;
    throw quad_support::DataError(fmt::format(
        "function '{}' {} (at character {}); write sums of A12, B1, A(1,2) and numbers with + - *, "
        "or one such sum over another: '(A11 - 1)/B1'",
        shown, what, at_ + 1));
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

  AffineFunction constant(double value) const { return {value, MatrixXd::Zero(nx_, nx_ + nu_)}; }

  AffineFunction product(const AffineFunction& a, const AffineFunction& b) const {
    if (isConstant(a)) return scaled(a.constant, b);
    if (!isConstant(b)) fail("comes to a product of entries");
    return scaled(b.constant, a);
  }

  Quotient ratio(const AffineFunction& over, const AffineFunction& under) const {
    if (!isConstant(under)) return {over, under};
    if (under.constant == 0.0) fail("divides by zero");
    // Numbers are divided as such: 0.1/3 is the double nearest to it.
    AffineFunction quotient = over;
    quotient.constant /= under.constant;
    quotient.weights /= under.constant;
    return {quotient, constant(1.0)};
  }

  Quotient plus(const Quotient& a, double sign, const Quotient& b) const {
    const bool alike = same(a.under, b.under);
    AffineFunction over = alike ? a.over : product(a.over, b.under);
    const AffineFunction other = alike ? b.over : product(b.over, a.under);
    over.constant += sign * other.constant;
    over.weights += sign * other.weights;
    return ratio(over, alike ? a.under : product(a.under, b.under));
  }

  Quotient sum() {
    Quotient value{constant(0.0), constant(1.0)};
    double sign = take('-') ? -1.0 : 1.0;
    do {
      value = plus(value, sign, products());
      sign = peek() == '-' ? -1.0 : 1.0;
    } while (take('+') || take('-'));
    return value;
  }

  Quotient products() {
    Quotient value = factor();
    for (;;) {
      if (take('*')) {
        const Quotient next = factor();
        value = ratio(product(value.over, next.over), product(value.under, next.under));
      } else if (take('/')) {
        const Quotient next = factor();
        value = ratio(product(value.over, next.under), product(value.under, next.over));
      } else {
        return value;
      }
    }
  }

  Quotient factor() {
    if (take('(')) {
      if (++depth_ > kDeepest) fail("has too many parentheses in one another");
      const Quotient value = sum();
      if (!take(')')) fail("lacks a )");
      --depth_;
      return value;
    }
    const char matrix = peek();
    if (matrix != 'A' && matrix != 'B') return {constant(number()), constant(1.0)};
    ++at_;
    const auto [row, column] = indices(matrix);
    AffineFunction entry = constant(0.0);
    entry.weights(row, (matrix == 'A' ? 0 : nx_) + column) = 1.0;
    return {entry, constant(1.0)};
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

  static constexpr int kDeepest = 50;  // more is no formula, and a stack has an end

  const std::string& text_;
  int nx_, nu_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

ParameterFunction parseFunction(const std::string& text, int num_states, int num_inputs) {
  return Parser(text, num_states, num_inputs).read();
}

}  // namespace explore_opt
