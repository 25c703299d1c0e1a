// What the monitor does to a wanted velocity.
#pragma once

#include "runtime/base/choice.hpp"

namespace bw::safety {

/// As nav2_msgs/CollisionMonitorState numbers them.
enum class Action { do_nothing = 0, stop = 1, slowdown = 2, approach = 3, limit = 4 };

/// Those that a zone may have.
constexpr auto choice_table(Action) {
  using enum Action;
  return choices<Action>({{stop, "stop"}, {slowdown, "slowdown"}, {limit, "limit"}, {approach, "approach"}});
}

}  // namespace bw::safety
