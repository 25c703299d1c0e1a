// Something that comes to an actor from the wire, one at a time: samples of a topic, requests, replies. DDS
// only says that something waits; the runner takes it when it is the actor's turn.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "runtime/base/time.hpp"

namespace bw {

struct Actor;

class InputEndpoint {
 public:
  InputEndpoint() = default;
  virtual ~InputEndpoint() = default;
  InputEndpoint(const InputEndpoint&) = delete;
  InputEndpoint& operator=(const InputEndpoint&) = delete;

  /// For messages to people: the topic or service.
  virtual const std::string& label() const = 0;
  /// Taking runs code of the component, so that it waits for a busy one.
  virtual bool calls_component() const { return true; }
  /// Its actor's lane need not be free: taking touches nothing of the component.
  virtual bool is_off_lane() const { return false; }
  /// In lock-step, taking makes the component busy for its declared latency.
  virtual bool takes_latency() const { return true; }
  /// Takes the oldest and gives it to the component; false when nothing was waiting. `waited` is for the
  /// statistics.
  virtual bool take_one(Time now, std::optional<Duration> waited) = 0;

  Actor* actor = nullptr;
  std::atomic<bool> queued = false;  ///< wall clock: an event waits in the lane
  std::atomic<std::int64_t> queued_at_ns = 0;
};

}  // namespace bw
