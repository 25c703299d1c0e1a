// Whether the battery is low or empty. Motors that set off pull the voltage down for a moment: only what
// lasts counts.
#pragma once

#include <optional>

#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct BatteryOptions {
  double low = 0.0;
  double empty = 0.0;
  /// [s] so long the voltage has to be low (set by code alone)
  double lasting = 3.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("low", low,
      {.unit = "V", .min = 0, .max = 100, .doc = "warns below this; 0: as the driver knows its base"});
    v("empty", empty,
      {.unit = "V",
       .min = 0,
       .max = 100,
       .doc = "stops below this, until it is above `low`; 0: as the driver knows its base"});
  }
};

enum class BatteryLevel { good, low, empty };

class BatteryGuard {
 public:
  /// A limit of 0 is none.
  explicit BatteryGuard(const BatteryOptions& options) : options_(options) {}

  BatteryLevel read(Time now, double voltage);
  BatteryLevel level() const { return level_; }

 private:
  friend struct GuardState;  ///< of tests: what decides what it does next
  /// Whether it has been so for long.
  bool lasts(std::optional<Time>& since, Time now, bool is_so) const;

  BatteryOptions options_;
  BatteryLevel level_ = BatteryLevel::good;
  std::optional<Time> good_since_, low_since_, empty_since_;
};

}  // namespace bw
