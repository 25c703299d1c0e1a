#include "runtime/host/wall_runner.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include <pthread.h>

#include "runtime/host/real_time.hpp"

namespace bw {

WallRunner::WallRunner(std::vector<Actor*> actors, ComponentClock& clock, const ServiceManager& manager,
                       Warn warn)
    : actors_(std::move(actors)), clock_(clock), watch_(manager), warn_(std::move(warn)) {
  for (Actor* actor : actors_) {
    auto& lane = lanes_[actor->lane];
    if (!lane) {
      lane = std::make_unique<Lane>();
      lane->name = actor->lane;
    }
    lane_of_[actor] = lane.get();
    lane->longest_callback = std::max(lane->longest_callback, actor->longest_callback);
    actor->motion = &motion_;
    if (actor->is_real_time && lane->real_time == nullptr) lane->real_time = actor;
    for (const auto& timer : actor->timers) lane->timers.push_back(timer.get());
    for (const auto& client : actor->clients) lane->timers.push_back(&client->deadline_timer);
    if (!actor->actions.empty() && acknowledgments_ == nullptr) {
      auto& off_lane = lanes_["acknowledge"];
      if (!off_lane) off_lane = std::make_unique<Lane>();
      off_lane->name = "acknowledge";
      acknowledgments_ = off_lane.get();
    }
  }
  clock_.on_step([this] {
    for (const auto& [name, lane] : lanes_) {
      const std::lock_guard lock(lane->mutex);
      lane->wake.notify_one();
    }
  });
}

WallRunner::~WallRunner() {
  clock_.on_step(nullptr);
  for (Actor* actor : actors_) actor->motion = nullptr;
}

namespace {

/// Inlets reached by the write this thread is in. They are woken when it returns: before, they would only
/// block on the locks it holds.
thread_local std::vector<InputEndpoint*>* t_reached = nullptr;
/// Whose write it is: another host of this program wakes its own inlets.
thread_local const WallRunner* t_writer = nullptr;

}  // namespace

void WallRunner::publish(OutputEnd& output, std::span<const std::uint8_t> cdr) {
  if (tap_ != nullptr) tap_->on_sample(output, clock_.now(), cdr);
  if (output.command) motion_.see(output.type, cdr, steady_time());
  run_and_wake([&] { output.writer->write(cdr); });
}

void WallRunner::run_and_wake(const std::function<void()>& write) {
  if (t_writer == this) return write();
  thread_local std::vector<InputEndpoint*> reached;
  t_reached = &reached;
  t_writer = this;
  const auto wake = [this] {
    t_reached = nullptr;
    t_writer = nullptr;
    for (InputEndpoint* inlet : reached) enqueue(*inlet);
    reached.clear();
  };
  try {
    write();
  } catch (...) {
    wake();
    throw;
  }
  wake();
}

void WallRunner::arrived(InputEndpoint& inlet) {
  if (inlet.queued.exchange(true)) return;  // the waiting event takes this one too
  inlet.queued_at_ns = steady_time().nanoseconds;
  if (t_writer == this) {
    t_reached->push_back(&inlet);
  } else {
    enqueue(inlet);
  }
}

void WallRunner::enqueue(InputEndpoint& inlet) {
  Lane& lane = inlet.is_off_lane() ? *acknowledgments_ : *lane_of_.at(inlet.actor);
  {
    const std::lock_guard lock(lane.mutex);
    lane.queue.push_back(&inlet);
  }
  lane.wake.notify_one();
}

RunEnd WallRunner::run(std::optional<Duration> duration) {
  const Time start = clock_.now();
  for (Actor* actor : actors_) {
    for (const auto& input : actor->inputs) input->last_received = start;
    for (const auto& timer : actor->timers) {
      if (timer->is_periodic() && actor->runs(*timer)) timer->next = start + timer->period;
    }
  }
  start_lanes();
  std::unique_lock lock(end_mutex_);
  const auto ended = [this] { return end_.has_value(); };
  if (duration) {
    if (!end_wake_.wait_for(lock, std::chrono::nanoseconds(duration->nanoseconds), ended)) {
      end_ = RunEnd{.ok = true, .reason = "the time is over"};
    }
  } else {
    end_wake_.wait(lock, ended);
  }
  const Duration grace = grace_;
  lock.unlock();
  if (grace > Duration{}) come_to_rest(grace);
  for (const auto& [name, lane] : lanes_) {
    const std::lock_guard lane_lock(lane->mutex);
    lane->stop = true;
    lane->wake.notify_one();
  }
  for (const auto& [name, lane] : lanes_) {
    if (lane->thread.joinable()) lane->thread.join();
  }
  lock.lock();
  return *end_;
}

void WallRunner::come_to_rest(Duration longest) {
  // As long as a command may be obeyed: what nobody has told to move for that long stands, or is on its way
  // there by itself.
  constexpr Duration kQuiet = Duration::milliseconds(200);
  constexpr std::chrono::milliseconds kPause{5};
  for (Actor* actor : actors_) actor->stop_requested = true;
  const Duration end = steady_time() + longest;
  for (Duration now = steady_time(); now < end && !motion_.is_over_since(kQuiet, now); now = steady_time())
    std::this_thread::sleep_for(kPause);
}

/// The system may have no more threads: everybody who is active has to come to rest then too.
void WallRunner::start_lanes() {
  for (const auto& [name, lane] : lanes_)
    lane->watched = &watch_.add(name, lane->longest_callback, steady_time());
  for (const auto& [name, lane] : lanes_) {
    try {
      lane->thread = std::thread([this, worker = lane.get()] { work(*worker); });
    } catch (const std::system_error& error) {
      const std::string reason = "lane " + name + " cannot be started: " + error.what();
      return finish({.ok = false, .reason = reason, .has_thrown = true}, {});
    }
    pthread_setname_np(lane->thread.native_handle(), name.substr(0, 15).c_str());
  }
}

void WallRunner::become_real_time(const Actor& actor) const {
  for (const std::string& missing : {take_real_time_priority(), lock_memory()}) {
    if (!missing.empty() && warn_) warn_(actor, missing);
  }
}

void WallRunner::work(Lane& lane) {
  if (lane.real_time != nullptr) become_real_time(*lane.real_time);
  std::unique_lock lock(lane.mutex);
  while (!lane.stop) {
    watch_.pass(*lane.watched, steady_time());
    // Timers first, but each once only: a late timer is moved past now, so it cannot starve the queue.
    for (Timer* timer : lane.timers) fire_if_due(lane, *timer, lock);
    if (lane.stop) return;  // asked while a timer ran: nobody would wake it again
    if (lane.queue.empty()) {
      wait(lane, lock);
      continue;
    }
    InputEndpoint* inlet = lane.queue.front();
    lane.queue.pop_front();
    lock.unlock();
    run_callback(*inlet->actor, inlet->label(), !inlet->is_off_lane(), [&] { drain(*inlet); });
    lock.lock();
  }
}

void WallRunner::fire_if_due(Lane& lane, Timer& timer, std::unique_lock<std::mutex>& lock) {
  const Time now = clock_.now();
  if (lane.stop) return;
  if (now < timer.next) {
    // An outside clock that went back: start counting anew.
    if (timer.is_periodic() && timer.next != Timer::kNever && timer.next - now > timer.period)
      timer.next = now + timer.period;
    return;
  }
  if (!timer.is_periodic()) {
    const Duration late = now - std::exchange(timer.next, Timer::kNever);
    fire(timer, now, late, lock);
    return;
  }
  const Duration late = now - timer.next;
  const std::int64_t skipped = late.nanoseconds / timer.period.nanoseconds;
  if (skipped > 0) {
    const std::lock_guard statistics_lock(timer.actor->mutex);
    timer.statistics.missed += static_cast<std::uint64_t>(skipped);
  }
  timer.next = timer.next + timer.period * (skipped + 1);
  fire(timer, now, late, lock);
}

void WallRunner::fire(Timer& timer, Time now, Duration late, std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  run_callback(*timer.actor, timer.name, true, [&] { timer.actor->fire(timer, now, late); });
  lock.lock();
}

void WallRunner::drain(InputEndpoint& inlet) {
  const Duration waited = steady_time() - Duration{inlet.queued_at_ns};
  inlet.queued = false;  // before the take: what arrives from now on makes a new event
  constexpr int kMaxAtOnce = 16;
  for (int i = 0; i < kMaxAtOnce; ++i) {
    if (!inlet.take_one(inlet.actor->own_time(clock_.now()), waited)) return;
  }
  arrived(inlet);  // others on this lane first
}

void WallRunner::wait(Lane& lane, std::unique_lock<std::mutex>& lock) {
  std::optional<Time> next;
  for (const Timer* timer : lane.timers) {
    if (timer->next != Timer::kNever) next = next ? std::min(*next, timer->next) : timer->next;
  }
  std::optional<Duration> sleep = next ? clock_.real_time_until(*next) : std::nullopt;
  if (sleep ? *sleep <= Duration{} : next && clock_.now() >= *next) return;
  if (watch_.period() != LaneWatch::kForever)
    sleep = std::min(sleep.value_or(watch_.period()), watch_.period());
  if (sleep) {
    lane.wake.wait_for(lock, std::chrono::nanoseconds(sleep->nanoseconds));
  } else {
    lane.wake.wait(lock);  // without timers, or with a clock that wakes us by itself
  }
}

void WallRunner::finish(RunEnd end, Duration grace) {
  const std::lock_guard lock(end_mutex_);
  if (end_) return;
  end_ = std::move(end);
  grace_ = grace;
  end_wake_.notify_one();
}

}  // namespace bw
