// Points in time and durations, as integer nanoseconds so that sums are exact and equal runs are equal bytes.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace bw {

/// A span of time [ns].
struct Duration {
  std::int64_t nanoseconds = 0;

  static constexpr Duration milliseconds(std::int64_t ms) { return {ms * 1'000'000}; }
  /// Rounds to the nearest nanosecond; |s| must stay below 9.2e9.
  static Duration seconds(double s) { return {static_cast<std::int64_t>(std::llround(s * 1e9))}; }
  constexpr double to_seconds() const { return static_cast<double>(nanoseconds) * 1e-9; }
  constexpr auto operator<=>(const Duration&) const = default;
};

/// A point on the component clock [ns]: monotonic time since the epoch of the clock in use.
struct Time {
  std::int64_t nanoseconds = 0;

  static Time seconds(double s) { return {Duration::seconds(s).nanoseconds}; }
  constexpr double to_seconds() const { return static_cast<double>(nanoseconds) * 1e-9; }
  constexpr auto operator<=>(const Time&) const = default;
};

constexpr Duration operator+(Duration a, Duration b) { return {a.nanoseconds + b.nanoseconds}; }
constexpr Duration operator-(Duration a, Duration b) { return {a.nanoseconds - b.nanoseconds}; }
constexpr Duration operator*(Duration a, std::int64_t n) { return {a.nanoseconds * n}; }
constexpr Time operator+(Time t, Duration d) { return {t.nanoseconds + d.nanoseconds}; }
constexpr Time operator-(Time t, Duration d) { return {t.nanoseconds - d.nanoseconds}; }
constexpr Duration operator-(Time a, Time b) { return {a.nanoseconds - b.nanoseconds}; }

}  // namespace bw
