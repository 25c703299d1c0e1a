// What the readers of logs have in common.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "components/files/csv_file.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Stamp of a row: seconds from the start of the log, after the last one of the same list.
class RisingStamps {
 public:
  explicit RisingStamps(std::string file) : file_(std::move(file)) {}

  Time next(double seconds, std::size_t line) {
    constexpr double kLongest = 1e6;
    if (!(std::abs(seconds) <= kLongest)) fail_at(file_, line, "the stamp must lie within 1000000 s of 0");
    const Time time = Time::seconds(seconds);
    if (!is_first_ && time <= last_) fail_at(file_, line, "stamps must rise from line to line");
    is_first_ = false;
    last_ = time;
    return time;
  }

 private:
  std::string file_;
  Time last_;
  bool is_first_ = true;
};

/// Complains unless low <= value <= high; false for NaN too.
inline void require_within(double value, double low, double high, const std::string& what,
                           const std::string& file, std::size_t line) {
  if (!(value >= low && value <= high)) fail_at(file, line, what);
}

}  // namespace bw
