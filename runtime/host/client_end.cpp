#include "runtime/host/client_end.hpp"

#include <algorithm>

#include "runtime/host/actor.hpp"
#include "runtime/host/runner.hpp"

namespace bw {

ClientEnd::ClientEnd(Actor& owner, std::string declared, std::string resolved,
                     const ServiceType& service_type, Need service_need)
    : name(std::move(declared)), service(std::move(resolved)), type(service_type), need(service_need) {
  actor = &owner;
  deadline_timer.actor = &owner;
  deadline_timer.of_node = true;
  deadline_timer.name = name + " deadline";
  deadline_timer.handler = [this](const Tick& tick) { expire(tick); };
  deadline_timer.statistics.component = owner.name;
  deadline_timer.statistics.callback = deadline_timer.name;
}

bool ClientEnd::is_ready() const {
  return writer && writer->matched_readers() > 0 && reader->matched_writers() > 0;
}

void ClientEnd::call(std::span<const std::uint8_t> cdr, Duration deadline, ReplyHandler on_reply) {
  const std::uint64_t number = next_call_++;
  calls_[number] = {.unsent = {cdr.begin(), cdr.end()},
                    .sequence = 0,
                    .deadline = runner->now() + deadline,
                    .on_reply = std::move(on_reply)};
  watch_deadlines();
  runner->when_done([this, number] {
    if (const auto found = calls_.find(number); found != calls_.end() && is_ready()) send(found->second);
  });
}

void ClientEnd::send(Call& call) {
  const auto identity = writer->write_related(call.unsent, {reader->guid(), 0});
  if (!identity) return;
  call.sequence = identity->sequence;
  call.unsent.clear();
}

bool ClientEnd::take_one(Time now, std::optional<Duration>) {
  if (is_ready()) {
    for (auto& [number, call] : calls_) {
      if (!call.unsent.empty()) send(call);
    }
  }
  while (reader->take(sample_)) {
    // All clients of a service see all replies.
    if (sample_.related.guid != reader->guid() && sample_.related.guid != writer->guid()) continue;
    const auto found = std::ranges::find_if(calls_, [&](const auto& item) {
      return item.second.unsent.empty() && item.second.sequence == sample_.related.sequence;
    });
    if (found == calls_.end()) continue;  // nobody waits for it any more
    const ReplyHandler on_reply = std::move(found->second.on_reply);
    calls_.erase(found);
    on_reply(sample_.cdr, Tick{.now = now, .health = actor->health(now)});
    return true;
  }
  return false;
}

void ClientEnd::expire(const Tick& tick) {
  std::vector<ReplyHandler> expired;
  std::erase_if(calls_, [&](auto& item) {
    if (item.second.deadline > tick.now) return false;
    expired.push_back(std::move(item.second.on_reply));
    return true;
  });
  for (const ReplyHandler& on_reply : expired) on_reply(std::nullopt, tick);
  watch_deadlines();
}

void ClientEnd::forget_calls() {
  if (calls_.empty()) return;
  calls_.clear();
  watch_deadlines();
}

void ClientEnd::watch_deadlines() {
  Time earliest = Timer::kNever;
  for (const auto& [number, call] : calls_) earliest = std::min(earliest, call.deadline);
  if (earliest != deadline_timer.next) runner->schedule(deadline_timer, earliest);
}

}  // namespace bw
