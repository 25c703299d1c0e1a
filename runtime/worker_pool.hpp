// Threads that share the work of one call, for components whose time is real. In lock-step there are none: a
// run has one thread.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "runtime/thrown.hpp"

namespace bw {

class WorkerPool {
 public:
  using Body = std::function<void(std::size_t)>;

  /// `threads` that work on a call, the calling one included; with 0 or 1 everything runs on the caller.
  explicit WorkerPool(std::size_t threads);
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Runs body(0) ... body(count - 1), each once, and returns when all are done. The first exception ends the
  /// call: bodies not begun by then are left out, and it is thrown when none runs any more. A call from
  /// inside a body, or while another thread is in here, runs on its caller alone.
  void run(std::size_t count, const Body& body);

 private:
  void wait_for_work(const std::stop_token& stop);
  void take_bodies(const Body& body, std::size_t count);

  std::mutex mutex_;
  std::condition_variable_any work_came_;
  std::condition_variable worker_left_;
  // Guarded by mutex_.
  const Body* body_ = nullptr;  ///< of the call that is open; workers join only while it is
  std::size_t count_ = 0;
  std::size_t call_ = 0;     ///< number of the call, so that a worker joins each once
  std::size_t working_ = 0;  ///< workers inside the call

  KeptException failure_;  ///< of a body
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> in_use_ = false;
  std::vector<std::jthread> workers_;  ///< last: they end before what they use
};

}  // namespace bw
