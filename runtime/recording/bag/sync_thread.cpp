#include "runtime/recording/bag/sync_thread.hpp"

#include <algorithm>
#include <utility>

#include "runtime/thrown.hpp"

namespace bw::bag {

SyncThread::SyncThread(std::function<void(const std::string&)> on_error)
    : on_error_(std::move(on_error)), thread_([this] { run(); }) {}

SyncThread::~SyncThread() { finish(); }

void SyncThread::ask(std::shared_ptr<ByteSink> sink) {
  const std::lock_guard lock(mutex_);
  if (std::ranges::find(asked_, sink) == asked_.end()) asked_.push_back(std::move(sink));
  wake_.notify_one();
}

void SyncThread::finish() {
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
    wake_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
}

void SyncThread::run() {
  while (true) {
    std::shared_ptr<ByteSink> sink;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return finishing_ || !asked_.empty(); });
      if (asked_.empty()) return;
      sink = std::move(asked_.front());
      asked_.pop_front();
    }
    try {
      sink->sync();
    } catch (...) {
      on_error_(thrown_text());
    }
  }
}

}  // namespace bw::bag
