// Another participant, on a thread of its own, for tests of the host.
#pragma once

#include <functional>
#include <thread>
#include <utility>

#include "runtime/dds/participant.hpp"

namespace bw {

/// Calls from another participant while a run is going on.
class FromOutside {
 public:
  explicit FromOutside(std::function<void(dds::Participant&)> calls)
      : thread_([calls = std::move(calls)] {
          dds::Participant participant(
              {.network = dds::Network::from_environment(dds::Transport::localhost)});
          calls(participant);
        }) {}
  ~FromOutside() { thread_.join(); }

 private:
  std::thread thread_;
};

}  // namespace bw
