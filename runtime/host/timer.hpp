// A tick of a component: each period, or once when it is asked for.
#pragma once

#include <limits>
#include <string>

#include "runtime/host/statistics.hpp"
#include "runtime/ports.hpp"

namespace bw {

struct Actor;

struct Timer {
  static constexpr Time kNever{std::numeric_limits<std::int64_t>::max()};

  Actor* actor = nullptr;
  std::string name;
  Duration period;  ///< zero: once, at `next`
  TickHandler handler;
  Time next = kNever;
  bool of_node = false;  ///< the runtime's: it ticks in every state of the component
  std::uint64_t calls = 0;
  CallbackStatistics statistics;

  bool is_periodic() const { return period > Duration{}; }
};

}  // namespace bw
