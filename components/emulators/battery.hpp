// A lead or lithium pack as a voltage: charge goes down with the current drawn and up on a charger, and the voltage sags under load.
#pragma once

#include <algorithm>

#include "runtime/base/field.hpp"

namespace bw::emulators {

struct BatteryOptions {
  double full = 16.5;
  double empty = 13.2;
  double charge = 0.9;
  double capacity = 2.2;
  double resistance = 0.08;

  template <class Visitor>
  void fields(Visitor& v) {
    v("full", full, {.unit = "V", .min = 1, .max = 60, .doc = "at rest, charged"});
    v("empty", empty, {.unit = "V", .min = 0, .max = 60, .doc = "at rest, discharged"});
    v("charge", charge, {.min = 0, .max = 1, .doc = "share of the full charge at the start"});
    v("capacity", capacity, {.unit = "Ah", .min = 0.001, .max = 1000, .doc = "of the full charge"});
    v("resistance", resistance, {.unit = "Ohm", .min = 0, .max = 10, .doc = "what makes it sag under load"});
  }
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
