// What the base can do. One set per robot (config/robots/*.yaml), shared by every component that commands or
// plans motion.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/field.hpp"

namespace bw {

/// Motion limits of the base. All values are magnitudes.
struct Limits {
  double v_max = 1.0;              ///< forward speed [m/s]
  double v_back_max = 0.2;         ///< backward speed [m/s]
  double omega_max = 1.0;          ///< turn rate [rad/s]
  double acc_max = 1.0;            ///< linear acceleration [m/s^2]
  double alpha_max = 1.5;          ///< angular acceleration [rad/s^2]
  double jerk_max = 5.0;           ///< linear jerk [m/s^3]
  double stop_deceleration = 2.0;  ///< deceleration of a safety stop [m/s^2]

  template <class Visitor>
  void fields(Visitor& v) {
    v("v_max", v_max, {.unit = "m/s", .min = 0.01, .max = 10, .first = true, .doc = "top forward speed"});
    v("v_back_max", v_back_max,
      {.unit = "m/s",
       .min = 0,
       .max = 10,
       .first = true,
       .doc = "top backward speed; 0 forbids driving back"});
    v("omega_max", omega_max,
      {.unit = "rad/s", .min = 0.01, .max = 20, .first = true, .doc = "top turn rate"});
    v("acc_max", acc_max,
      {.unit = "m/s^2",
       .min = 0.01,
       .max = 20,
       .first = true,
       .doc = "largest linear acceleration; lower is gentler"});
    v("alpha_max", alpha_max,
      {.unit = "rad/s^2", .min = 0.01, .max = 50, .doc = "largest angular acceleration; lower is gentler"});
    v("jerk_max", jerk_max,
      {.unit = "m/s^3", .min = 0.1, .max = 1000, .doc = "largest linear jerk; lower is smoother"});
    v("stop_deceleration", stop_deceleration,
      {.unit = "m/s^2", .min = 0.1, .max = 20, .doc = "deceleration of a safety stop; what the tyres hold"});
  }

  std::optional<std::string> violated_rule() const {
    if (stop_deceleration < acc_max) return "stop_deceleration must be at least acc_max";
    return std::nullopt;
  }
};

}  // namespace bw
