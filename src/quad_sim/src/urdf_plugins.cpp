#include <fmt/core.h>
#include <tinyxml2.h>

#include <cmath>
#include <sstream>

#include "quad_support/errors.hpp"
#include "quad_support/number_format.hpp"
#include "urdf_reader.hpp"

namespace quad_sim {
namespace {

using tinyxml2::XMLElement;

std::string trimmed(const char* text) {
  const std::string all = text ? text : "";
  const auto first = all.find_first_not_of(" \t\r\n");
  return first == std::string::npos
             ? ""
             : all.substr(first, all.find_last_not_of(" \t\r\n") - first + 1);
}

const XMLElement& parse(tinyxml2::XMLDocument& document, const std::string& text,
                        const std::string& file) {
  document.Parse(text.data(), text.size());
  if (document.Error()) {
    throw quad_support::ConfigError(
        fmt::format("{}:{}: not valid XML: {}", file, document.ErrorLineNum(),
                    tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID())));
  }
  const XMLElement* robot = document.FirstChildElement("robot");
  if (!robot) throw quad_support::ConfigError(fmt::format("{}: no <robot> element", file));
  return *robot;
}

PluginDeclaration toDeclaration(const XMLElement& element, const std::string& file) {
  PluginDeclaration plugin;
  plugin.where = fmt::format("{}:{}", file, element.GetLineNum());
  const char* name = element.Attribute("name");
  plugin.name = name ? name : "";
  const char* filename = element.Attribute("filename");
  if (!filename) {
    throw quad_support::ConfigError(
        fmt::format("{}: plugin '{}' has no filename", plugin.where, plugin.name));
  }
  plugin.filename = filename;
  for (const XMLElement* tag = element.FirstChildElement(); tag; tag = tag->NextSiblingElement()) {
    if (!plugin.tags.emplace(tag->Name(), trimmed(tag->GetText())).second) {
      throw quad_support::ConfigError(fmt::format("{}:{}: plugin '{}' has <{}> twice; remove one",
                                                  file, tag->GetLineNum(), plugin.name,
                                                  tag->Name()));
    }
  }
  return plugin;
}

/// The number in an attribute of an inertial; `label` is what messages call it. Attributes left out
/// are urdfdom's to find.
void checkNumber(const XMLElement* element, const char* attribute, const char* label, bool positive,
                 const std::string& file, const std::string& link) {
  const char* const raw = element ? element->Attribute(attribute) : nullptr;
  if (!raw) return;
  const std::string text = trimmed(raw);
  const auto fail = [&](const char* unit, const char* limit) {
    throw quad_support::ConfigError(fmt::format("{}:{}: link '{}': {} = {}{}; must be {}", file,
                                                element->GetLineNum(), link, label, text, unit,
                                                limit));
  };
  double value = 0;
  try {
    value = quad_support::parseDouble(text);
  } catch (const std::invalid_argument&) {
    fail("", "a number");
  }
  if (!std::isfinite(value)) fail("", "a finite number");
  if (positive && !(value > 0)) fail(" kg", "> 0");
}

}  // namespace

void checkInertials(const std::string& urdf_text, const std::string& file) {
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parse(document, urdf_text, file);
  for (const XMLElement* link = robot.FirstChildElement("link"); link;
       link = link->NextSiblingElement("link")) {
    const XMLElement* const inertial = link->FirstChildElement("inertial");
    if (!inertial) continue;
    const char* const attribute = link->Attribute("name");
    const std::string name = attribute ? attribute : "";
    checkNumber(inertial->FirstChildElement("mass"), "value", "mass", true, file, name);
    for (const char* entry : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
      checkNumber(inertial->FirstChildElement("inertia"), entry, entry, false, file, name);
    }
  }
}

namespace {

void appendPlugins(const XMLElement& parent, const std::string& file,
                   std::vector<PluginDeclaration>& plugins) {
  for (const XMLElement* p = parent.FirstChildElement("plugin"); p;
       p = p->NextSiblingElement("plugin")) {
    plugins.push_back(toDeclaration(*p, file));
  }
}

}  // namespace

std::vector<PluginDeclaration> readPlugins(const std::string& urdf_text, const std::string& file) {
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parse(document, urdf_text, file);
  std::vector<PluginDeclaration> plugins;
  for (const XMLElement* g = robot.FirstChildElement("gazebo"); g;
       g = g->NextSiblingElement("gazebo")) {
    appendPlugins(*g, file, plugins);
    for (const XMLElement* s = g->FirstChildElement("sensor"); s;
         s = s->NextSiblingElement("sensor"))
      appendPlugins(*s, file, plugins);
  }
  return plugins;
}

std::string locate(const std::string& urdf_text, const std::string& file, const std::string& tag,
                   const std::string& name) {
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parse(document, urdf_text, file);
  for (const XMLElement* e = robot.FirstChildElement(tag.c_str()); e;
       e = e->NextSiblingElement(tag.c_str())) {
    if (e->Attribute("name", name.c_str())) return fmt::format("{}:{}", file, e->GetLineNum());
  }
  return file;
}

void PluginDeclaration::fail(const std::string& tag, const std::string& problem) const {
  const auto it = tags.find(tag);
  const std::string value = it == tags.end() ? "" : " = " + it->second;
  throw quad_support::ConfigError(
      fmt::format("{}: plugin '{}' ({}): {}{} {}", where, name, filename, tag, value, problem));
}

const std::string& PluginDeclaration::text(const std::string& tag) const {
  const auto it = tags.find(tag);
  if (it == tags.end()) fail(tag, "is missing");
  return it->second;
}

std::string PluginDeclaration::text(const std::string& tag, const std::string& fallback) const {
  const auto it = tags.find(tag);
  return it == tags.end() ? fallback : it->second;
}

double PluginDeclaration::number(const std::string& tag) const {
  double value = 0;
  try {
    value = quad_support::parseDouble(text(tag));
  } catch (const quad_support::ConfigError&) {
    throw;
  } catch (const std::invalid_argument&) {
    fail(tag, "must be a number");
  }
  if (!std::isfinite(value)) fail(tag, "must be finite");
  return value;
}

double PluginDeclaration::number(const std::string& tag, double fallback) const {
  return tags.count(tag) ? number(tag) : fallback;
}

Eigen::Vector3d PluginDeclaration::vector(const std::string& tag) const {
  std::istringstream words(text(tag));
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    try {
      numbers.push_back(quad_support::parseDouble(word));
    } catch (const std::invalid_argument&) {
      fail(tag, "must be three numbers");
    }
    if (!std::isfinite(numbers.back())) fail(tag, "must be finite");
  }
  if (numbers.size() != 3) fail(tag, "must be three numbers");
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

Eigen::Vector3d PluginDeclaration::vector(const std::string& tag,
                                          const Eigen::Vector3d& fallback) const {
  return tags.count(tag) ? vector(tag) : fallback;
}

}  // namespace quad_sim
