#include "runtime/host/actor.hpp"

#include <algorithm>

namespace bw {

bool Input::take_one(Time now, std::optional<Duration> waited) { return actor->deliver(*this, now, waited); }

Health Actor::health(Time now) const {
  if (stop_requested) return Health::stop;
  Health worst = Health::ok;
  for (const Input* input : watched) {
    if (now - input->last_received <= *input->max_age) continue;
    if (input->on_stale == OnStale::stop) worst = Health::stop;
    if (input->on_stale == OnStale::degrade) worst = std::max(worst, Health::degraded);
  }
  return worst;
}

std::vector<std::string> Actor::stale_inputs(Time now) const {
  std::vector<std::string> stale;
  for (const Input* input : watched) {
    if (now - input->last_received > *input->max_age) stale.push_back(input->name);
  }
  return stale;
}

void Actor::see(Time now) {
  if (now < now_) {
    const std::lock_guard lock(mutex);
    for (const auto& input : inputs) input->last_received = std::min(input->last_received, now);
  }
  now_ = now;
}

bool Actor::deliver(Input& input, Time now, std::optional<Duration> waited) {
  if (!input.reader->take(sample_)) return false;
  see(now);
  {
    const std::lock_guard lock(mutex);
    input.last_received = now;
  }
  const Duration start = thread_cpu_time();
  const bool accepted =
      input.handler(sample_.cdr, Tick{.now = now, .health = health(now), .sequence = input.calls});
  const Duration spent = thread_cpu_time() - start;
  if (accepted) ++input.calls;
  {
    const std::lock_guard lock(mutex);
    input.statistics.run.add(spent);
    if (waited) input.statistics.wait.add(*waited);
    if (!accepted) ++input.statistics.rejected;
  }
  if (!accepted && input.statistics.rejected == 1 && on_first_rejected) on_first_rejected(input);
  return true;
}

void Actor::fire(Timer& timer, Time now, std::optional<Duration> waited) {
  see(now);
  const Duration start = thread_cpu_time();
  timer.handler(Tick{.now = now, .health = health(now), .sequence = timer.calls++});
  const Duration spent = thread_cpu_time() - start;
  const std::lock_guard lock(mutex);
  timer.statistics.run.add(spent);
  if (waited) timer.statistics.wait.add(*waited);
}

}  // namespace bw
