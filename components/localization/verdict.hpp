// What becomes of a measurement. Every one gets a verdict; none is dropped silently.
#pragma once

#include <string_view>

namespace bw::localization {

enum class Verdict {
  accepted,    ///< used
  collected,   ///< kept for the initial pose; the filter has none yet
  reacquired,  ///< used to put the estimate back after a long run of rejections
  gated,       ///< too far from the estimate for chance (chi-square gate)
  unusable,    ///< sound, but says nothing at present (a course at walking-pace noise, no initial pose yet)
  not_finite,  ///< NaN or infinity in a value, covariance or variance
  bad_covariance,  ///< not symmetric, not positive definite, or beyond MeasurementLimits::variance
  bad_interval,    ///< wheel step over no time, negative time or too long a time
  implausible,     ///< faster or farther than MeasurementLimits allow
  bad_source,      ///< source that the filter has no room for, or one that has given another kind before
  duplicate,       ///< same kind, source and stamp as one in the window
  too_old,         ///< before the window of rewinding
  future,          ///< stamped after now
};

constexpr bool used(Verdict v) { return v == Verdict::accepted || v == Verdict::reacquired; }

constexpr std::string_view to_string(Verdict v) {
  switch (v) {
    case Verdict::accepted:
      return "accepted";
    case Verdict::collected:
      return "collected";
    case Verdict::reacquired:
      return "reacquired";
    case Verdict::gated:
      return "gated";
    case Verdict::unusable:
      return "unusable";
    case Verdict::not_finite:
      return "not_finite";
    case Verdict::bad_covariance:
      return "bad_covariance";
    case Verdict::bad_interval:
      return "bad_interval";
    case Verdict::implausible:
      return "implausible";
    case Verdict::bad_source:
      return "bad_source";
    case Verdict::duplicate:
      return "duplicate";
    case Verdict::too_old:
      return "too_old";
    case Verdict::future:
      return "future";
  }
  return "unknown";
}

}  // namespace bw::localization
