// Wakes one thread from DDS threads.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace bw {

class Notifier {
 public:
  void ring() {
    const std::lock_guard lock(mutex_);
    rung_ = true;
    wake_.notify_one();
  }
  /// False at `end`.
  bool wait(std::chrono::steady_clock::time_point end) {
    std::unique_lock lock(mutex_);
    const bool rung = wake_.wait_until(lock, end, [this] { return rung_; });
    rung_ = false;
    return rung;
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool rung_ = false;
};

}  // namespace bw
