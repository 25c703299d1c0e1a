// Drives the actors of one process through time. Two implementations, one code path above them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/host/actor.hpp"
#include "runtime/host/sample_tap.hpp"

namespace bw {

/// How a run ended.
struct RunEnd {
  bool ok = true;
  std::string reason;
};

class Runner : public SampleSink {
 public:
  /// The component clock.
  virtual Time now() const = 0;
  /// Something waits at the inlet. Called by DDS with its locks held.
  virtual void arrived(Inlet& inlet) = 0;
  /// Sets when a timer fires next; Timer::kNever: it does not. On the actor's own lane.
  virtual void schedule(Timer& timer, Time at) = 0;
  /// Runs until finish() or, with a duration, until it has passed.
  virtual RunEnd run(std::optional<Duration> duration) = 0;
  /// Ends the run; with a grace every actor first sees Health::stop for that long. Callable from any thread.
  virtual void finish(RunEnd end, Duration grace) = 0;
  /// Null: nobody looks. Before run().
  void set_tap(SampleTap* tap) { tap_ = tap; }

 protected:
  SampleTap* tap_ = nullptr;
};

}  // namespace bw
