// Drives the actors of one process through time. Two implementations, one code path above them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/host/actor.hpp"
#include "runtime/host/sample_tap.hpp"
#include "runtime/thrown.hpp"

namespace bw {

/// How a run ended.
struct RunEnd {
  bool ok = true;
  std::string reason;
  bool has_thrown = false;  ///< a callback threw: a mistake in the program, not a result of the run
};

/// A callback that threw.
struct CallbackFailure {
  Actor& actor;
  std::string callback;    ///< topic, timer, service or action
  std::string what;        ///< of the exception
  bool is_on_lane = true;  ///< told on the actor's own lane, so that it can be brought to rest at once
};

class Runner : public SampleSink {
 public:
  /// The component clock.
  virtual Time now() const = 0;
  /// Something waits at the inlet. Called by DDS with its locks held.
  virtual void arrived(InputEndpoint& inlet) = 0;
  /// Sets when a timer fires next; Timer::kNever: it does not. On the actor's own lane.
  virtual void schedule(Timer& timer, Time at) = 0;
  /// Runs until finish() or, with a duration, until it has passed.
  virtual RunEnd run(std::optional<Duration> duration) = 0;
  /// Ends the run; with a grace every actor first sees Health::stop for that long. Callable from any thread.
  virtual void finish(RunEnd end, Duration grace) = 0;
  /// Null: nobody looks. Before run().
  void set_tap(SampleTap* tap) { tap_ = tap; }
  /// Who hears of callbacks that throw. Before run().
  void set_on_failure(std::function<void(const CallbackFailure&)> hear) { on_failure_ = std::move(hear); }

 protected:
  /// Whatever `work` throws ends the run, not the process.
  template <class Work>
  void run_callback(Actor& actor, const std::string& callback, bool is_on_lane, const Work& work) {
    try {
      work();
    } catch (...) {
      const CallbackFailure failure{actor, callback, thrown_text(), is_on_lane};
      if (on_failure_) return on_failure_(failure);
      finish({.ok = false, .reason = failure.what, .has_thrown = true}, {});
    }
  }

  std::function<void(const CallbackFailure&)> on_failure_;
  SampleTap* tap_ = nullptr;
};

}  // namespace bw
