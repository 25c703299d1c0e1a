// What a bag says of the log that it holds: its metadata record `log` (runtime/recording/bag/log_record.hpp).
#pragma once

#include <optional>
#include <string>

#include "runtime/base/time.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw {

struct LogRecord {
  std::string name;     ///< of the file, where the bag does not tell
  std::string source;   ///< empty: it does not tell
  std::string licence;  ///< empty: it does not tell
  std::optional<Time> start;
  std::optional<double> wheel_separation;  ///< [m]
  std::optional<double> wheel_radius;      ///< [m]
  std::optional<double> wheel_variance;    ///< of the speed of a wheel [m^2/s^2]
};

/// Throws std::runtime_error naming `path` for a value that is no number.
LogRecord log_record_of(const bag::Bag& bag, const std::string& path);

}  // namespace bw
