#include "runtime/worker_pool.hpp"

namespace bw {

WorkerPool::WorkerPool(std::size_t threads) {
  for (std::size_t i = 1; i < threads; ++i) {
    workers_.emplace_back([this](const std::stop_token& stop) { wait_for_work(stop); });
  }
}

void WorkerPool::run(std::size_t count, const Body& body) {
  if (workers_.empty() || count < 2 || in_use_.exchange(true)) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    body_ = &body;
    count_ = count;
    next_ = 0;
    ++call_;
  }
  work_came_.notify_all();
  take_bodies(body, count);
  {
    // A worker that wakes only now finds the call closed: nobody waits for a thread that has nothing to do.
    std::unique_lock lock(mutex_);
    body_ = nullptr;
    worker_left_.wait(lock, [this] { return working_ == 0; });
  }
  in_use_ = false;
  failure_.rethrow();
}

void WorkerPool::wait_for_work(const std::stop_token& stop) {
  std::size_t joined = 0;
  std::unique_lock lock(mutex_);
  while (work_came_.wait(lock, stop, [&] { return body_ != nullptr && call_ != joined; })) {
    joined = call_;
    ++working_;
    const Body& body = *body_;
    const std::size_t count = count_;
    lock.unlock();
    take_bodies(body, count);
    lock.lock();
    if (--working_ == 0) worker_left_.notify_one();
  }
}

void WorkerPool::take_bodies(const Body& body, std::size_t count) {
  for (std::size_t i = next_++; i < count; i = next_++) {
    if (!failure_.run([&] { body(i); })) next_ = count;
  }
}

}  // namespace bw
