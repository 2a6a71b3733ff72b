#include "json_matrix.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "explore_opt/design_json.hpp"
#include "quad_support/errors.hpp"

namespace explore_opt {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using quad_support::ConfigError;

constexpr int kDeepest = 64;  // matrices need three

/// Told of every event of the parser; remembers the keys of each open object and the last of all.
class KeyWatch {
 public:
  explicit KeyWatch(const std::string& source) : source_(source) {}

  bool operator()(int depth, json::parse_event_t event, json& parsed) {
    if (depth > kDeepest)  // printing a value goes down by recursion
      throw ConfigError(fmt::format("{}: brackets nest deeper than {}", source_, kDeepest));
    if (event == json::parse_event_t::object_start) open_.emplace_back();
    if (event == json::parse_event_t::object_end) open_.pop_back();
    if (event != json::parse_event_t::key) return true;
    last_ = parsed.get<std::string>();
    if (!open_.back().insert(last_).second)
      throw ConfigError(fmt::format("{}: key {} is given twice", source_, parsed.dump()));
    return true;
  }

  const std::string& last() const { return last_; }

 private:
  std::string source_, last_;
  std::vector<std::set<std::string>> open_;
};

/// Without its name: "[json.exception.parse_error.101] parse error at ..."
std::string reasonOf(const json::exception& e) {
  const std::string reason = e.what();
  const std::size_t name_end = reason.find("] ");
  return name_end == std::string::npos ? reason : reason.substr(name_end + 2);
}

bool isFlat(const ordered_json& value) {
  return value.is_array() &&
         std::none_of(value.begin(), value.end(), [](const auto& v) { return v.is_structured(); });
}

void print(const ordered_json& value, const std::string& indent, std::string& out) {
  if (!value.is_structured() || value.empty() || isFlat(value)) {
    out += value.dump();
    return;
  }
  const std::string inner = indent + "  ";
  out += value.is_object() ? "{" : "[";
  bool first = true;
  for (const auto& item : value.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    out += inner;
    if (value.is_object()) out += json(item.key()).dump() + ": ";
    print(item.value(), inner, out);
  }
  out += "\n" + indent + (value.is_object() ? "}" : "]");
}

}  // namespace

json parseJson(const std::string& text, const std::string& source) {
  KeyWatch keys(source);
  try {
    return json::parse(text, std::ref(keys));
  } catch (const json::parse_error& e) {
    throw ConfigError(fmt::format("{}: not valid JSON: {}", source, reasonOf(e)));
  } catch (const json::exception& e) {
    const std::string key = keys.last().empty() ? "" : keys.last() + ": ";
    throw ConfigError(
        fmt::format("{}: {}{}; must lie within -1.79e308 to 1.79e308", source, key, reasonOf(e)));
  }
}

Eigen::MatrixXd matrixFromJson(const json& rows, const std::string& name) {
  const bool shaped =
      rows.is_array() && !rows.empty() && rows.front().is_array() && !rows.front().empty();
  if (!shaped)
    throw ConfigError(
        fmt::format("{} = {}; must be a list of rows, [[...], ...]", name, rows.dump()));
  Eigen::MatrixXd m(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].is_array() || rows[i].size() != rows.front().size()) {
      throw ConfigError(fmt::format("{}: row {} is {}; must have {} numbers like the first", name,
                                    i + 1, rows[i].dump(), rows.front().size()));
    }
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      if (!rows[i][j].is_number()) {
        throw ConfigError(
            fmt::format("{}: row {} holds {}; must hold numbers", name, i + 1, rows[i][j].dump()));
      }
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j].get<double>();
    }
  }
  return m;
}

ordered_json matrixToJson(const Eigen::MatrixXd& m) {
  ordered_json rows = ordered_json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    rows.push_back(ordered_json::array());
    for (Eigen::Index j = 0; j < m.cols(); ++j) rows.back().push_back(m(i, j));
  }
  return rows;
}

std::string prettyJson(const ordered_json& value) {
  std::string out;
  print(value, "", out);
  return out + "\n";
}

}  // namespace explore_opt
