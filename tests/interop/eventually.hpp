// Waits for what other processes do.
#pragma once

#include <chrono>
#include <thread>

namespace bw::test {

/// Polls `seen` every `pause` until it holds, at least once, and not beyond `end`.
template <class Condition>
bool poll_until(std::chrono::steady_clock::time_point end, std::chrono::microseconds pause, Condition seen) {
  for (;;) {
    if (seen()) return true;
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(pause);
  }
}

/// Polls `seen` until it holds, for at most 30 s.
template <class Condition>
bool eventually(Condition seen) {
  return poll_until(std::chrono::steady_clock::now() + std::chrono::seconds(30),
                    std::chrono::milliseconds(20), seen);
}

}  // namespace bw::test
