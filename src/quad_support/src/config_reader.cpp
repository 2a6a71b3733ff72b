#include "quad_support/config_reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "near_name.hpp"
#include "quad_support/atomic_file.hpp"
#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "range_text.hpp"

namespace quad_support {

struct ConfigReader::Node {
  YAML::Node yaml;
  std::string file;
  std::string prefix;  ///< "control." inside section control, "" at the top
  int line = 0;
  std::map<std::string, YAML::Node> entries;
  std::vector<std::string> order;  ///< of the keys in the file
  std::map<std::string, int> lines;
  mutable std::set<std::string> asked;

  /// A key of the file nobody asked for that looks like the missing one, as a question.
  std::string meantInstead(const std::string& missing) const;
};

namespace {

int lineOf(const YAML::Node& node) { return node.Mark().line + 1; }

/// "file:12"; what comes from elsewhere than the file's text has no line.
std::string place(const std::string& file, int line) {
  return line > 0 ? fmt::format("{}:{}", file, line) : file;
}

// The YAML core schema's words for what parseDouble() leaves out, so that the message can say "nan"
// and not "text".
double scalarToDouble(const std::string& text) {
  if (text == ".nan" || text == ".NaN" || text == ".NAN") return std::nan("");
  if (text == ".inf" || text == "+.inf") return HUGE_VAL;
  if (text == "-.inf") return -HUGE_VAL;
  return parseDouble(text);
}

bool isNumber(const std::string& text) {
  try {
    scalarToDouble(text);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

bool isQuoted(const YAML::Node& node) { return node.IsScalar() && node.Tag() == "!"; }

void emit(YAML::Emitter& out, const YAML::Node& node) {
  if (node.IsSequence()) {
    out << YAML::Flow << YAML::BeginSeq;
    for (const auto& entry : node) emit(out, entry);
    out << YAML::EndSeq;
  } else if (node.IsMap()) {
    out << YAML::Flow << YAML::BeginMap;
    for (const auto& entry : node) {
      out << YAML::Key;
      emit(out, entry.first);
      out << YAML::Value;
      emit(out, entry.second);
    }
    out << YAML::EndMap;
  } else if (node.IsScalar()) {
    const std::string& text = node.Scalar();
    // Without its quotes this text would be something else.
    if (isQuoted(node) && (isNumber(text) || text == "true" || text == "false"))
      out << YAML::DoubleQuoted;
    out << text;
  } else {
    out << YAML::Null;
  }
}

/// On one line, however it stands in the file.
std::string flow(const YAML::Node& node) {
  YAML::Emitter out;
  emit(out, node);
  return out.c_str();
}

/// For a message: as flow(), with no more quotes than a reader needs.
std::string valueText(const YAML::Node& node) {
  const bool plain = node.IsScalar() && !isQuoted(node);
  const bool one_line = node.IsScalar() && node.Scalar().find('\n') == std::string::npos;
  const bool text = one_line && !node.Scalar().empty() && !isNumber(node.Scalar());
  return plain || text ? node.Scalar() : flow(node);
}

}  // namespace

std::string ConfigReader::Node::meantInstead(const std::string& missing) const {
  std::vector<std::string> strangers;
  for (const std::string& key : order) {
    if (asked.count(key) == 0) strangers.push_back(key);
  }
  const std::string near = nearName(missing, strangers);
  if (near.empty()) return "";
  return fmt::format(" (is {}{}, line {}, meant?)", prefix, near, lines.at(near));
}

ConfigReader::ConfigReader(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

namespace {

template <class NodeType>
std::shared_ptr<NodeType> makeNode(const YAML::Node& yaml, const std::string& file,
                                   const std::string& prefix, int line) {
  auto node = std::make_shared<NodeType>();
  node->yaml = yaml;
  node->file = file;
  node->prefix = prefix;
  node->line = line;
  const std::string name = prefix.empty() ? "the file" : prefix.substr(0, prefix.size() - 1);
  if (!yaml.IsMap())
    throw ConfigError(fmt::format("{}:{}: {} must be a map of keys and values", file, line, name));
  for (const auto& entry : yaml) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : valueText(entry.first);
    const int key_line = lineOf(entry.first);
    if (!node->entries.emplace(key, entry.second).second) {
      throw ConfigError(fmt::format("{}:{}: {}{} stands twice (first on line {}); remove one", file,
                                    key_line, prefix, key, node->lines[key]));
    }
    node->lines[key] = key_line;
    node->order.push_back(key);
  }
  return node;
}

}  // namespace

namespace {

YAML::Node parseYaml(const std::string& text, const std::string& name) {
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    for (std::size_t i = 1; i < documents.size(); ++i) {
      if (documents[i].IsNull()) continue;  // nothing is lost with it
      throw ConfigError(
          fmt::format("{}:{}: a second YAML document begins here; remove the line "
                      "'---' before it, or what follows",
                      name, lineOf(documents[i])));
    }
    return documents.empty() ? YAML::Node() : documents[0];
  } catch (const YAML::Exception& e) {
    throw ConfigError(fmt::format("{}:{}: not valid YAML: {}", name, e.mark.line + 1, e.msg));
  }
}

/// A copy that claims no line of the file, so that complaints name the line of its key.
YAML::Node unmarked(const YAML::Node& node) {
  if (node.IsSequence()) {
    YAML::Node list(YAML::NodeType::Sequence);
    for (const auto& entry : node) list.push_back(unmarked(entry));
    return list;
  }
  if (node.IsMap()) {
    YAML::Node map(YAML::NodeType::Map);
    for (const auto& entry : node) map[unmarked(entry.first)] = unmarked(entry.second);
    return map;
  }
  return node.IsNull() ? YAML::Node() : YAML::Node(node.Scalar());
}

/// "control.altitude[0]" as {"control", "altitude", "0"}.
std::vector<std::string> stepsTo(const std::string& key) {
  std::vector<std::string> steps(1);
  for (const char c : key) {
    if (c == '.' || c == '[')
      steps.emplace_back();
    else if (c != ']')
      steps.back() += c;
  }
  return steps;
}

/// The entry of a map or list; undefined if there is none.
YAML::Node entryOf(const YAML::Node& node, const std::string& step) {
  if (node.IsMap()) return node[step];
  const bool index =
      !step.empty() && step.size() < 7 && step.find_first_not_of("0123456789") == std::string::npos;
  return node.IsSequence() && index ? node[std::stoul(step)]
                                    : YAML::Node(YAML::NodeType::Undefined);
}

void applyOverride(const YAML::Node& root, const std::string& name, const Override& o) {
  const std::vector<std::string> steps = stepsTo(o.key);
  YAML::Node at = root;
  for (const std::string& step : steps) {
    const YAML::Node next = entryOf(at, step);
    if (next.IsDefined()) {
      at.reset(next);
    } else if (at.IsMap() && !step.empty() && &step == &steps.back()) {
      at[step] = unmarked(parseYaml(o.value, o.key));  // one the text could have had
      return;
    } else {
      throw ConfigError(fmt::format(
          "{} has no key {}; if its section may be left out, set that one first, to {{}}", name,
          o.key));
    }
  }
  at = unmarked(parseYaml(o.value, o.key));
}

}  // namespace

ConfigReader ConfigReader::fromText(const std::string& text, const std::string& name) {
  return fromText(text, name, {});
}

ConfigReader ConfigReader::fromText(const std::string& text, const std::string& name,
                                    const std::vector<Override>& overrides) {
  const YAML::Node yaml = parseYaml(text, name);
  for (const Override& o : overrides) applyOverride(yaml, name, o);
  return ConfigReader(makeNode<Node>(yaml, name, "", 1));
}

ConfigReader ConfigReader::fromFile(const std::string& path) {
  return fromText(readFile(path), path);
}

bool ConfigReader::has(const std::string& key) const {
  node_->asked.insert(key);
  return node_->entries.count(key) > 0;
}

bool ConfigReader::isSection(const std::string& key) const {
  return has(key) && node_->entries.at(key).IsMap();
}

std::vector<std::string> ConfigReader::keys() const { return node_->order; }

void ConfigReader::fail(const std::string& key, const std::string& problem, int index) const {
  const std::string name = node_->prefix + key + (index >= 0 ? fmt::format("[{}]", index) : "");
  const auto it = node_->entries.find(key);
  if (it == node_->entries.end()) {
    throw ConfigError(fmt::format("{}: {} {}{}", place(node_->file, node_->line), name, problem,
                                  node_->meantInstead(key)));
  }
  YAML::Node value = it->second;
  if (index >= 0) value.reset(value[static_cast<std::size_t>(index)]);
  const int line = value.IsNull() || lineOf(value) == 0 ? node_->lines.at(key) : lineOf(value);
  throw ConfigError(
      fmt::format("{}: {} = {}; {}", place(node_->file, line), name, valueText(value), problem));
}

ConfigReader ConfigReader::section(const std::string& key) const {
  if (!has(key)) fail(key, "is missing; add the section");
  const YAML::Node value = node_->entries.at(key);
  if (!value.IsMap()) fail(key, "must be a map of keys and values");
  return ConfigReader(
      makeNode<Node>(value, node_->file, node_->prefix + key + ".", node_->lines.at(key)));
}

namespace {

/// The scalar behind a key, or its list; complains if it is missing or of the other kind.
template <class Reader, class Entries>
YAML::Node require(const Reader& reader, const Entries& entries, const std::string& key, bool list,
                   const std::string& expected) {
  if (!reader.has(key)) reader.fail(key, "is missing; it " + expected);
  const YAML::Node value = entries.at(key);
  if (list ? !value.IsSequence() : !value.IsScalar()) reader.fail(key, expected);
  return value;
}

/// The scalar as written; empty for what is no plain scalar: a list, a map, a text in quotes.
std::string plainScalar(const YAML::Node& node) {
  return node.IsScalar() && !isQuoted(node) ? node.Scalar() : "";
}

double toNumber(const ConfigReader& reader, const YAML::Node& node, const std::string& key,
                const Range& range, int index) {
  double value = std::nan("");
  try {
    value = scalarToDouble(plainScalar(node));
  } catch (const std::invalid_argument&) {
    // a text, a list, a map: said below, like the numbers that are not finite
  }
  if (!std::isfinite(value)) reader.fail(key, describe(range, "a finite number "), index);
  if (!contains(range, value)) reader.fail(key, describe(range), index);
  return value;
}

std::int64_t toInteger(const ConfigReader& reader, const YAML::Node& node, const std::string& key,
                       std::int64_t min, std::int64_t max, int index) {
  const std::string expected = max == std::numeric_limits<std::int64_t>::max()
                                   ? fmt::format("must be a whole number >= {}", min)
                                   : fmt::format("must be a whole number in {}..{}", min, max);
  double value = 0;
  try {
    value = scalarToDouble(plainScalar(node));
  } catch (const std::invalid_argument&) {
    reader.fail(key, expected, index);
  }
  constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
  if (!std::isfinite(value) || value != std::floor(value) || std::abs(value) > kExactIntegers)
    reader.fail(key, expected, index);
  const auto integer = static_cast<std::int64_t>(value);
  if (integer < min || integer > max) reader.fail(key, expected, index);
  return integer;
}

void requireChoice(const ConfigReader& reader, const std::string& value, const std::string& key,
                   const std::vector<std::string>& choices, int index) {
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
  reader.fail(key, fmt::format("must be one of: {}", fmt::join(choices, ", ")), index);
}

}  // namespace

double ConfigReader::number(const std::string& key, const Range& range) const {
  const std::string missing = describe(range), wrong = describe(range, "a finite number ");
  return toNumber(*this, require(*this, node_->entries, key, false, has(key) ? wrong : missing),
                  key, range, -1);
}

std::int64_t ConfigReader::integer(const std::string& key, std::int64_t min,
                                   std::int64_t max) const {
  return toInteger(*this, require(*this, node_->entries, key, false, "must be a whole number"), key,
                   min, max, -1);
}

std::string ConfigReader::value(const std::string& key) const {
  if (!has(key)) fail(key, "is missing");
  return flow(node_->entries.at(key));
}

std::vector<std::string> ConfigReader::values(const std::string& key) const {
  const YAML::Node list =
      require(*this, node_->entries, key, true, "must be a list of at least one value");
  if (list.size() == 0) fail(key, "must be a list of at least one value");
  std::vector<std::string> texts;
  for (const auto& entry : list) texts.push_back(flow(entry));
  return texts;
}

bool ConfigReader::boolean(const std::string& key) const {
  const std::string value =
      plainScalar(require(*this, node_->entries, key, false, "must be true or false"));
  if (value != "true" && value != "false") fail(key, "must be true or false");
  return value == "true";
}

std::string ConfigReader::text(const std::string& key) const {
  const std::string value = require(*this, node_->entries, key, false, "must be a text").Scalar();
  if (value.empty()) fail(key, "must not be empty");
  return value;
}

std::string ConfigReader::choice(const std::string& key,
                                 const std::vector<std::string>& choices) const {
  const std::string expected = fmt::format("must be one of: {}", fmt::join(choices, ", "));
  const std::string value = require(*this, node_->entries, key, false, expected).Scalar();
  requireChoice(*this, value, key, choices, -1);
  return value;
}

std::vector<double> ConfigReader::numbers(const std::string& key, const Range& range,
                                          std::size_t size) const {
  const std::string expected =
      size > 0 ? fmt::format("must be a list of {} numbers", size) : "must be a list of numbers";
  const YAML::Node list = require(*this, node_->entries, key, true, expected);
  if (list.size() == 0 || (size > 0 && list.size() != size)) fail(key, expected);
  std::vector<double> values;
  for (std::size_t i = 0; i < list.size(); ++i)
    values.push_back(toNumber(*this, list[i], key, range, static_cast<int>(i)));
  return values;
}

std::vector<std::int64_t> ConfigReader::integers(const std::string& key, std::int64_t min,
                                                 std::int64_t max) const {
  const YAML::Node list =
      require(*this, node_->entries, key, true, "must be a list of whole numbers");
  if (list.size() == 0) fail(key, "must be a list of whole numbers, not empty");
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < list.size(); ++i)
    values.push_back(toInteger(*this, list[i], key, min, max, static_cast<int>(i)));
  return values;
}

std::vector<std::string> ConfigReader::choices(const std::string& key,
                                               const std::vector<std::string>& choices) const {
  const YAML::Node list = require(*this, node_->entries, key, true,
                                  fmt::format("must be a list of: {}", fmt::join(choices, ", ")));
  std::vector<std::string> values;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string value = list[i].IsScalar() ? list[i].Scalar() : "";
    requireChoice(*this, value, key, choices, static_cast<int>(i));
    values.push_back(value);
  }
  return values;
}

void ConfigReader::finish() const {
  std::vector<std::pair<int, std::string>> unknown;
  for (const auto& [key, line] : node_->lines) {
    if (node_->asked.count(key) == 0) unknown.emplace_back(line, key);
  }
  if (unknown.empty()) return;
  const auto [line, key] = *std::min_element(unknown.begin(), unknown.end());
  const std::string near = nearName(key, node_->asked);
  throw ConfigError(fmt::format("{}: {}{} is not a key of this program{}; known here: {}",
                                place(node_->file, line), node_->prefix, key,
                                near.empty() ? "" : fmt::format(", did you mean {}?", near),
                                fmt::join(node_->asked, ", ")));
}

std::string ConfigReader::resolvePath(const std::string& path) const {
  namespace fs = std::filesystem;
  const fs::path given(path);
  return given.is_absolute()
             ? path
             : (fs::path(node_->file).parent_path() / given).lexically_normal().string();
}

const std::string& ConfigReader::file() const { return node_->file; }

}  // namespace quad_support
