// Fixes kept from the filter, to measure it against them.
#pragma once

#include <vector>

#include "components/recordings/recorded_drive.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw {

enum class HoldOutRule {
  none,
  every_second,
  sparse,  ///< all but one in a period
  outage,  ///< those from one moment to another
};
constexpr auto choice_table(HoldOutRule) {
  using enum HoldOutRule;
  return choices<HoldOutRule>(
      {{none, "none"}, {every_second, "every_second"}, {sparse, "sparse"}, {outage, "outage"}});
}

struct HoldOutOptions {
  HoldOutRule rule = HoldOutRule::none;
  /// [s] rule sparse: time from a fix that is given to the next (set by code alone)
  double period = 10.0;
  double from = 150.0;
  double to = 250.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("rule", rule,
      {.doc = "which fixes are held out: none, every second one, all but one in 10 s, those of an outage"});
    v("from", from, {.unit = "s", .min = 0, .max = 1e6, .doc = "rule outage: its first second in the log"});
    v("to", to, {.unit = "s", .min = 0, .max = 1e6, .doc = "rule outage: its last second in the log"});
    v.retired({"period"}, "set by code alone, in hold_out.hpp");
  }
};

/// Takes the fixes held out from the drive and returns them, in their order.
std::vector<FixSample> hold_out(RecordedDrive& drive, const HoldOutOptions& options);

}  // namespace bw
