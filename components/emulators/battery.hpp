// A lead or lithium pack as a voltage: charge goes down with the current drawn and up on a charger, and the
// voltage sags under load.
#pragma once

#include <algorithm>

#include "runtime/base/field.hpp"

namespace bw::emulators {

struct BatteryOptions {
  /// [V] at rest, charged (set by code alone)
  double full = 16.5;
  /// [V] at rest, discharged (set by code alone)
  double empty = 13.2;
  /// share of the full charge at the start (set by code alone)
  double charge = 0.9;
  /// [Ah] of the full charge (set by code alone)
  double capacity = 2.2;
  /// [Ohm] what makes it sag under load (set by code alone)
  double resistance = 0.08;
};

class Battery {
 public:
  explicit Battery(const BatteryOptions& options) : options_(options), charge_(options.charge) {}

  /// `current` [A] is drawn for dt [s]; a charger gives what is negative.
  void step(double current, double dt) {
    current_ = current;
    charge_ = std::clamp(charge_ - current * dt / (options_.capacity * 3600.0), 0.0, 1.0);
  }
  double voltage() const {
    return options_.empty + (options_.full - options_.empty) * charge_ - options_.resistance * current_;
  }
  bool is_full() const { return charge_ >= 1.0; }

 private:
  BatteryOptions options_;
  double charge_;
  double current_ = 0.0;
};

}  // namespace bw::emulators
