// What is wrong with a configuration, and where. One form everywhere:
//   hallway.yaml:12: world.scan.rate = -1: must be between 0.1 and 100 Hz
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace bw {

/// Location::file of a value given on the command line.
inline constexpr std::string_view kOverrideFile = "--set";

struct Location {
  std::string file;
  int line = 0;  ///< 1-based; 0: the file as a whole

  std::string text() const;
  bool operator==(const Location&) const = default;
};

struct Violation {
  Location where;
  std::string key;    ///< dotted, list elements by index; empty: the document
  std::string value;  ///< as written; empty: there is none
  std::string rule;   ///< what must hold

  std::string text() const;
};

/// Thrown while configuring, never in flight. what() has one line per violation (the first 50).
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(std::vector<Violation> violations);
  explicit ConfigError(Violation violation);
  const std::vector<Violation>& violations() const { return violations_; }

 private:
  std::vector<Violation> violations_;
};

/// Throws ConfigError if there is any.
void throw_if_any(std::vector<Violation> violations);

}  // namespace bw
