// Waits for devices on a thread of its own: a sync may take seconds, and what comes meanwhile must get into
// the file.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "runtime/recording/bag/byte_sink.hpp"

namespace bw::bag {

class SyncThread {
 public:
  /// `on_error` is called with the reason, on the thread.
  explicit SyncThread(std::function<void(const std::string&)> on_error);
  /// finish()
  ~SyncThread();
  SyncThread(const SyncThread&) = delete;
  SyncThread& operator=(const SyncThread&) = delete;

  /// What is written so far will be synced; once for several that ask meanwhile.
  void ask(std::shared_ptr<ByteSink> sink);
  /// Waits for what was asked.
  void finish();

 private:
  void run();

  std::function<void(const std::string&)> on_error_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::shared_ptr<ByteSink>> asked_;
  bool finishing_ = false;
  std::thread thread_;
};

}  // namespace bw::bag
