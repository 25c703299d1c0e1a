// What /diagnostics says of a component: where it runs, how it is, how old and how frequent its inputs are on
// the component clock, and, where time is real, how long its callbacks wait and run.
#pragma once

#include <cstdint>
#include <map>

#include <diagnostic_msgs/msg/diagnostic_status.hpp>

#include "runtime/host/actor.hpp"

namespace bw {

class DiagnosticStatuses {
 public:
  /// `timings`: what was measured on a real clock is told too.
  explicit DiagnosticStatuses(bool timings) : timings_(timings) {}

  /// Rates are those since the last call for the same actor.
  diagnostic_msgs::msg::DiagnosticStatus of(const Actor& actor, Time run_now);

 private:
  struct Heard {
    std::uint64_t samples = 0;
    Time at;
  };

  void add_inputs(diagnostic_msgs::msg::DiagnosticStatus& status, const Actor& actor, Time now);

  bool timings_;
  std::map<const Input*, Heard> heard_;
};

}  // namespace bw
