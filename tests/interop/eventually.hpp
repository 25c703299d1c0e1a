// Waits for what other processes do.
#pragma once

#include <chrono>
#include <thread>

namespace bw::test {

/// Polls `seen` until it holds, for at most 30 s.
template <class Condition>
bool eventually(Condition seen) {
  for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
       std::chrono::steady_clock::now() < end;) {
    if (seen()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

}  // namespace bw::test
