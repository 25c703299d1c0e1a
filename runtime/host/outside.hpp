// What other participants send into a run in lock-step: seen between events, let in at the beginning of an
// instant.
#pragma once

#include "runtime/base/time.hpp"

namespace bw {

class Outside {
 public:
  virtual ~Outside() = default;
  /// Something came. From any thread, with DDS's locks held.
  virtual void has_news() = 0;
  /// Answers what only asks, and refuses or keeps what changes something. Between two events.
  virtual void look(Time now) = 0;
  /// What was kept enters. Called when an instant begins, before everything else of it.
  virtual void enter(Time now) = 0;
};

}  // namespace bw
