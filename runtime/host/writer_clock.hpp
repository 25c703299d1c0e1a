// Whose stamps are of the clock that this process's components see.
#pragma once

#include <atomic>
#include <optional>

#include "runtime/base/time.hpp"
#include "runtime/dds/participant.hpp"

namespace bw {

class WriterClock {
 public:
  enum class Reach {
    one_clock,  ///< lock-step, and /clock: there is no other
    this_host,  ///< only loopback is heard, so every writer is on this host
    network,    ///< a GID of Fast DDS names its host; others' do not
  };

  /// `offset`: what the system clock is ahead of the monotonic one.
  explicit WriterClock(Reach reach = Reach::one_clock, Duration offset = {})
      : reach_(reach), offset_(offset) {}

  /// After the system clock was set, processes that started before and after disagree.
  bool is_own(const dds::Guid& writer, const dds::Guid& reader) const {
    if (reach_ == Reach::one_clock || dds::same_participant(writer, reader)) return true;
    return !was_set_ && (reach_ == Reach::this_host || dds::same_host(writer, reader));
  }
  /// The offset as it is now. By how much the system clock was set, once.
  std::optional<Duration> look(Duration offset);

 private:
  Reach reach_;
  Duration offset_;
  std::atomic<bool> was_set_ = false;
};

/// Of this machine. Both are slewed alike: it changes when the system clock is set, and by what a suspended
/// machine slept.
Duration system_clock_offset();

}  // namespace bw
