// A thread for what may take long, in the order it was asked for: opening and closing of devices.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

#include "runtime/thrown.hpp"

namespace bw {

class BackgroundJobs {
 public:
  BackgroundJobs();
  /// Waits until all are done.
  ~BackgroundJobs() = default;
  BackgroundJobs(const BackgroundJobs&) = delete;
  BackgroundJobs& operator=(const BackgroundJobs&) = delete;
  void add(std::function<void()> job);
  /// Throws what the first job threw that did, once; those behind it are done all the same. On the lane that
  /// asks for the jobs.
  void rethrow() { failure_.rethrow(); }

 private:
  void work(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any came_;
  std::deque<std::function<void()>> jobs_;  ///< guarded by mutex_
  KeptException failure_;
  std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace bw
