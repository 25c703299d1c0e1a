#include "runtime/host/lockstep_runner.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace bw {

namespace {

/// With the callback, also when it throws: what is told of that is not held back.
template <class T>
class CollectingEnds {
 public:
  explicit CollectingEnds(T*& collecting) : collecting_(collecting) {}
  ~CollectingEnds() { collecting_ = nullptr; }
  CollectingEnds(const CollectingEnds&) = delete;
  CollectingEnds& operator=(const CollectingEnds&) = delete;

 private:
  T*& collecting_;
};

}  // namespace

LockstepRunner::LockstepRunner(std::vector<Actor*> actors, const LockstepOptions& options)
    : actors_(std::move(actors)), options_(options), now_(options.start) {}

void LockstepRunner::push(Event event) {
  event.sequence = next_sequence_++;
  events_.push(event);
}

void LockstepRunner::arrived(InputEndpoint& inlet) {
  if (std::this_thread::get_id() != thread_) {
    if (options_.outside != nullptr) options_.outside->has_news();
    return;
  }
  push({.time = now_, .rank = inlet.actor->rank, .actor = inlet.actor, .inlet = &inlet});
}

void LockstepRunner::publish(OutputEnd& output, std::span<const std::uint8_t> cdr) {
  if (collecting_ != nullptr) {
    collecting_->held.emplace_back(
        [this, &output, bytes = std::vector<std::uint8_t>(cdr.begin(), cdr.end())] { write(output, bytes); });
  } else {
    write(output, cdr);
  }
}

void LockstepRunner::when_done(std::function<void()> action) {
  if (collecting_ != nullptr) {
    collecting_->held.push_back(std::move(action));
  } else {
    action();
  }
}

void LockstepRunner::write(OutputEnd& output, std::span<const std::uint8_t> cdr) {
  hash_.add(output.topic, now_, cdr);
  if (!output.writer->write(cdr)) throw std::runtime_error("DDS refused a sample on " + output.topic);
  // After the write: what a replay publishes in answer comes behind this sample.
  if (tap_ != nullptr) tap_->on_sample(output, now_, cdr);
}

RunEnd LockstepRunner::run(std::optional<Duration> duration) {
  real_start_ = steady_time();
  thread_cpu_lap();  // what led to the run is of no callback
  for (Actor* actor : actors_) {
    for (const auto& input : actor->inputs) input->last_received = now_;
    for (const auto& timer : actor->timers) {
      if (timer->is_periodic() && actor->runs(*timer)) schedule_next(*timer, now_);
    }
  }
  std::optional<Time> last = duration ? std::optional(now_ + *duration) : std::nullopt;
  bool stopping = false;
  while (const std::optional<Time> next = next_time()) {
    if (end_requested_ && !stopping) {
      stopping = true;
      for (Actor* actor : actors_) actor->stop_requested = grace_ > Duration{};
      const Time end_time = now_ + grace_;
      last = last ? std::min(*last, end_time) : end_time;
    }
    if (last && *next > *last) break;
    if (options_.outside != nullptr) options_.outside->look(now_);
    if (*next != now_) go_to(*next);
    if (events_.empty() || events_.top().time != now_) continue;
    const Event event = events_.top();
    events_.pop();
    count_event(event);
    dispatch(event);
    if (stopping && grace_ == Duration{}) break;
  }
  const std::lock_guard lock(finish_mutex_);
  return end_.value_or(RunEnd{.ok = true, .reason = "the time is over"});
}

std::optional<Time> LockstepRunner::next_time() const {
  std::optional<Time> next = options_.source == nullptr ? std::nullopt : options_.source->next();
  if (!events_.empty() && (!next || events_.top().time < *next)) next = events_.top().time;
  return next;
}

void LockstepRunner::go_to(Time time) {
  now_ = time;
  events_at_now_ = 0;
  instant_callbacks_.clear();
  wait_for_pace();
  if (options_.outside != nullptr) options_.outside->enter(now_);
  if (options_.source != nullptr) options_.source->run(now_);
}

void LockstepRunner::dispatch(const Event& event) {
  Actor& actor = *event.actor;
  if (event.inlet == nullptr && event.timer == nullptr) {
    run_callback(actor, "what it held back for its latency", true, [&] { complete(actor); });
    return;
  }
  // Moved since, or of a component that is not active: activation sets it anew.
  if (event.timer != nullptr && event.timer->next != event.time && !event.was_deferred) return;
  if (event.timer != nullptr && !actor.runs(*event.timer)) return;
  // Keeping the newest message runs no user code, so it costs nothing and happens even while the actor is
  // busy.
  if (event.inlet != nullptr && !event.inlet->calls_component()) {
    run_callback(actor, event.inlet->label(), true,
                 [&] { event.inlet->take_one(actor.own_time(now_), std::nullopt); });
    return;
  }
  if (const auto busy = busy_.find(actor.rank); busy != busy_.end()) {
    auto& deferred = busy->second.deferred;
    const bool already_due = event.timer != nullptr && std::ranges::any_of(deferred, [&](const Event& e) {
                               return e.timer == event.timer;
                             });
    if (already_due) {
      ++event.timer->statistics.missed;
    } else {
      deferred.push_back(event);
    }
    if (event.timer != nullptr && !event.was_deferred) schedule_next(*event.timer, event.time);
    return;
  }
  const bool takes_latency = event.inlet == nullptr || event.inlet->takes_latency();
  if (takes_latency && actor.latency > Duration{}) {
    collecting_ = &busy_[actor.rank];
    push({.time = now_ + actor.latency, .rank = actor.rank, .actor = &actor});
  }
  // The successor of a deferred tick is already scheduled.
  if (event.timer != nullptr && !event.was_deferred) schedule_next(*event.timer, event.time);
  run_callback(actor, event.inlet != nullptr ? event.inlet->label() : event.timer->name, true, [&] {
    const CollectingEnds ends(collecting_);
    if (event.inlet != nullptr) {
      event.inlet->take_one(actor.own_time(now_), std::nullopt);
    } else {
      actor.fire(*event.timer, now_, std::nullopt);
    }
  });
}

void LockstepRunner::complete(Actor& actor) {
  Busy done = std::move(busy_.at(actor.rank));
  busy_.erase(actor.rank);
  for (const auto& action : done.held) action();
  // In their own places: what has waited comes before what arrives at this instant, whoever sends that and
  // when.
  for (Event event : done.deferred) {
    event.time = now_;
    event.was_deferred = true;
    events_.push(event);
  }
}

void LockstepRunner::schedule(Timer& timer, Time at) {
  timer.next = at;
  if (at != Timer::kNever)
    push({.time = at, .rank = timer.actor->rank, .actor = timer.actor, .timer = &timer});
}

void LockstepRunner::schedule_next(Timer& timer, Time due) {
  if (!timer.is_periodic()) {
    timer.next = Timer::kNever;
    return;
  }
  timer.next = due + timer.period;
  push({.time = timer.next, .rank = timer.actor->rank, .actor = timer.actor, .timer = &timer});
}

void LockstepRunner::count_event(const Event& event) {
  ++events_at_now_;
  if (events_at_now_ <= kMaxEventsPerInstant / 2) return;
  const std::string what = event.inlet != nullptr   ? event.inlet->label()
                           : event.timer != nullptr ? event.timer->name
                                                    : "latency";
  ++instant_callbacks_[event.actor->name + " (" + what + ")"];
  if (events_at_now_ <= kMaxEventsPerInstant) return;
  std::string message =
      "more than " + std::to_string(kMaxEventsPerInstant) + " events at one instant; the loop runs through";
  for (const auto& [name, count] : instant_callbacks_) message += " " + name;
  throw std::runtime_error(message);
}

void LockstepRunner::wait_for_pace() const {
  if (options_.pace <= 0.0) return;
  const double real = static_cast<double>((now_ - options_.start).nanoseconds) / options_.pace;
  const Duration ahead = Duration{static_cast<std::int64_t>(real)} - (steady_time() - real_start_);
  if (ahead > Duration{}) std::this_thread::sleep_for(std::chrono::nanoseconds(ahead.nanoseconds));
}

void LockstepRunner::finish(RunEnd end, Duration grace) {
  const std::lock_guard lock(finish_mutex_);
  if (end_) return;
  end_ = std::move(end);
  grace_ = grace;
  end_requested_ = true;
}

}  // namespace bw
