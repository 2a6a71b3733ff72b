/// One reader for YAML settings: every value is checked where it is read, every complaint names
/// file and line.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace quad_support {

/// Allowed values of a number, with its unit for the message. Bounds are inclusive unless `open_*`.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false, open_max = false;
  std::string unit;  ///< "s", "kg"; "" for none

  static Range any(std::string unit = "");
  static Range positive(std::string unit = "");     ///< > 0
  static Range nonNegative(std::string unit = "");  ///< >= 0
  static Range closed(double min, double max, std::string unit = "");
  static Range open(double min, double max, std::string unit = "");
};

/// Another value for a key of a file: `design.gamma_w`, `control.altitude[0]`.
struct Override {
  std::string key;    ///< keys from the top, joined by dots; [i] points into a list
  std::string value;  ///< as YAML: 20, [1, 2], sin
};

/// A map of a YAML file. Reading a key marks it as known; finish() complains about the rest.
///
/// All member functions throw ConfigError with `file:line: section.key = value; …` for a missing or
/// unknown key, a key that stands twice, a wrong type, a number that is not finite, or a value out
/// of range.
class ConfigReader {
 public:
  /// @throws std::invalid_argument if the file cannot be read, ConfigError if it is not a YAML map
  static ConfigReader fromFile(const std::string& path);
  static ConfigReader fromText(const std::string& text, const std::string& name);
  /// The text with other values for some keys, in order; a key may be new in a section that is
  /// there.
  /// @throws ConfigError for a section or list entry that is not in the text
  static ConfigReader fromText(const std::string& text, const std::string& name,
                               const std::vector<Override>& overrides);

  ConfigReader section(const std::string& key) const;
  bool has(const std::string& key) const;  ///< whether the key is there; marks it as known
  bool isSection(const std::string& key) const;
  std::vector<std::string> keys() const;  ///< in the file's order; marks none as known

  double number(const std::string& key, const Range& range) const;
  std::int64_t integer(const std::string& key, std::int64_t min, std::int64_t max) const;
  bool boolean(const std::string& key) const;
  std::string text(const std::string& key) const;
  /// Any value, as YAML on one line.
  std::string value(const std::string& key) const;
  /// The entries of a list of any values (not empty), each as YAML on one line.
  std::vector<std::string> values(const std::string& key) const;
  /// One of `choices`; the message lists them.
  std::string choice(const std::string& key, const std::vector<std::string>& choices) const;
  /// A list of numbers. @param size  required length, 0 for any (not empty)
  std::vector<double> numbers(const std::string& key, const Range& range,
                              std::size_t size = 0) const;
  std::vector<std::int64_t> integers(const std::string& key, std::int64_t min,
                                     std::int64_t max) const;
  std::vector<std::string> choices(const std::string& key,
                                   const std::vector<std::string>& choices) const;

  /// @throws ConfigError with file, line, key and value in front of `problem`; index >= 0 points
  /// into a list
  [[noreturn]] void fail(const std::string& key, const std::string& problem, int index = -1) const;
  /// Complains about the first key nobody asked for (lists those that are known here). Recurses
  /// into nothing: each section is finished by whoever reads it.
  void finish() const;

  /// A path as the file means it: relative to the file's own folder.
  std::string resolvePath(const std::string& path) const;
  const std::string& file() const;

 private:
  struct Node;
  explicit ConfigReader(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

}  // namespace quad_support
