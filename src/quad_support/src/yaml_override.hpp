/// A file's YAML, and other values put into it.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "quad_support/config_reader.hpp"

namespace quad_support {

/// @param name  of the file, for the message
/// @throws ConfigError with file:line if the text is no YAML
YAML::Node parseYaml(const std::string& text, const std::string& name);

/// Puts a value in the place its key names: over the one that is there, or as a new key of a
/// section that is there.
/// @param name  of the file, for the message
/// @throws ConfigError for a section or list entry that is not there, or a value that is no YAML
void applyOverride(const YAML::Node& root, const std::string& name, const Override& o);

}  // namespace quad_support
