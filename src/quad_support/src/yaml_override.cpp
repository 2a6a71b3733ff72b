#include "yaml_override.hpp"

#include <fmt/core.h>

#include <vector>

#include "quad_support/errors.hpp"

namespace quad_support {
namespace {

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

}  // namespace

YAML::Node parseYaml(const std::string& text, const std::string& name) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& e) {
    throw ConfigError(fmt::format("{}:{}: not valid YAML: {}", name, e.mark.line + 1, e.msg));
  }
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

}  // namespace quad_support
