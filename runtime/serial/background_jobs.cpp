#include "runtime/serial/background_jobs.hpp"

#include <utility>

#include <pthread.h>
#include <sched.h>

namespace bw {

BackgroundJobs::BackgroundJobs() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

void BackgroundJobs::add(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  came_.notify_one();
}

void BackgroundJobs::work(const std::stop_token& stop) {
  // Made by a lane with real-time rights it would have them too, and it is nothing that is urgent.
  const sched_param ordinary{};
  pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
  for (;;) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      came_.wait(lock, stop, [this] { return !jobs_.empty(); });
      if (jobs_.empty()) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    failure_.run(job);
  }
}

}  // namespace bw
