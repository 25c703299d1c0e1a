#include "runtime/host/actor.hpp"

#include <algorithm>

#include "runtime/host/commanded_motion.hpp"
#include "runtime/host/nested_lifecycle.hpp"
#include "runtime/host/writer_clock.hpp"

namespace bw {

Actor::Actor() = default;
Actor::~Actor() = default;

bool Input::calls_component() const { return kind == InputKind::callback && (of_node || actor->is_active()); }

void Input::keep(const dds::Sample& sample, bool is_given) {
  kept.push_back({sample.writer, sample.cdr, is_given});
  const auto is_same_writer = [&](const Kept& other) { return other.writer == sample.writer; };
  if (std::ranges::count_if(kept, is_same_writer) > qos.depth)
    kept.erase(std::ranges::find_if(kept, is_same_writer));
}

// One that was killed counts as there for seconds, but says nothing: who takes its place is obeyed once its last command
// is old.
bool Input::has_rival(const dds::Guid& writer, Time now) {
  constexpr Duration kForgotten = Duration::milliseconds(1000);
  if (last_heard && last_heard->writer != writer) rival = last_heard;
  last_heard = Heard{writer, now};
  if (rival) rival->at = std::min(rival->at, now);  // a clock that went back
  return rival && rival->writer != writer && now - rival->at < kForgotten && reader->matched_writers() > 1;
}

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

bool Actor::is_onlooker() const {
  const auto is_nodes = [](const auto& end) { return end->of_node; };
  return std::ranges::all_of(inputs, is_nodes) && std::ranges::all_of(outputs, is_nodes) &&
         std::ranges::all_of(timers, is_nodes) && std::ranges::all_of(services, is_nodes) &&
         std::ranges::all_of(actions, is_nodes) && std::ranges::all_of(clients, is_nodes);
}

std::string Actor::not_active() const {
  return name + " is not active (" + std::string(lifecycle::label(state)) + ")";
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
  // Two who command: nobody is obeyed, and what moves stops because its commands are too old.
  if (!input.commander.empty() && input.has_rival(sample_.writer, now)) {
    ++input.refused;
    return true;
  }
  const bool is_heard = input.of_node || is_active();
  if (role == ActorRole::component && !input.of_node && input.qos.durability == Durability::transient_local)
    input.keep(sample_, is_heard);
  if (!is_heard) return true;
  see(now);
  {
    const std::lock_guard lock(mutex);
    input.last_received = now;
  }
  give(input, sample_.writer, sample_.cdr, now, waited);
  return true;
}

void Actor::give(Input& input, const dds::Guid& writer, std::span<const std::uint8_t> cdr, Time now,
                 std::optional<Duration> waited) {
  if (motion != nullptr && !input.commander.empty()) motion->see(input.type, cdr, steady_time());
  const Tick tick{
      .now = now,
      .health = health(now),
      .sequence = input.calls,
      .from = {writer, writer_clock == nullptr || writer_clock->is_own(writer, input.reader->guid())}};
  const bool accepted = input.handler(cdr, tick);
  const Duration spent = thread_cpu_lap();
  if (accepted) ++input.calls;
  {
    const std::lock_guard lock(mutex);
    input.statistics.run.add(spent);
    if (waited) input.statistics.wait.add(*waited);
    if (!accepted) ++input.statistics.rejected;
  }
  if (!accepted && input.statistics.rejected == 1 && on_first_rejected) on_first_rejected(input);
}

void Actor::fire(Timer& timer, Time now, std::optional<Duration> waited) {
  if (!runs(timer)) return;
  // The runtime's timers go by the run's clock, whatever is wrong with the component's.
  if (!timer.of_node) now = own_time(now);
  if (!timer.of_node || !clock_error) see(now);
  timer.handler(Tick{.now = now, .health = health(now), .sequence = timer.calls++});
  const Duration spent = thread_cpu_lap();
  const std::lock_guard lock(mutex);
  timer.statistics.run.add(spent);
  if (waited) timer.statistics.wait.add(*waited);
}

}  // namespace bw
