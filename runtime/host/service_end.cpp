#include "runtime/host/service_end.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "runtime/host/actor.hpp"

namespace bw {
namespace {

/// Replies kept for clients whose reader is not known yet.
constexpr std::size_t kMaxPending = 256;
constexpr Duration kLongestPending = Duration::milliseconds(1000);

/// The last octet of an entity id tells readers (RTPS 9.3.1.2).
bool is_reader(const dds::Guid& guid) {
  constexpr std::uint8_t kReaderNoKey = 0x04, kReaderWithKey = 0x07;
  return guid.back() == kReaderNoKey || guid.back() == kReaderWithKey;
}

/// The reader that a client asks to be answered at, or else its writer.
RequestId id_of(const dds::Sample& sample) {
  const bool is_told = sample.related.guid != dds::Guid{};
  return {is_told ? sample.related.guid : sample.writer, static_cast<std::int64_t>(sample.sequence)};
}

}  // namespace

ServiceEnd::ServiceEnd(Actor& owner, std::string declared, std::string resolved,
                       const ServiceType& service_type, ServiceScope service_scope)
    : name(std::move(declared)), service(std::move(resolved)), type(service_type), scope(service_scope) {
  actor = &owner;
  statistics.component = owner.name;
  statistics.callback = name;
}

bool ServiceEnd::take_one(Time now, std::optional<Duration> waited) {
  flush();
  if (keeps_foreign_apart) {
    sort_arrivals();
    if (own_.empty()) return false;
    const Request request = std::move(own_.front());
    own_.pop_front();
    answer(request, now);
    return true;
  }
  if (!reader->take(sample_)) return false;
  if (waited) {
    const std::lock_guard lock(actor->mutex);
    statistics.wait.add(*waited);
  }
  answer({id_of(sample_), sample_.cdr}, now);
  return true;
}

bool ServiceEnd::is_closed() const {
  if (!handler.handle) return true;
  if (scope == ServiceScope::node || actor->is_active()) return false;
  return changes_something() || actor->state != lifecycle::State::inactive;
}

void ServiceEnd::answer(const Request& request, Time now) {
  if (is_closed()) {
    refuse(request.from, actor->not_active());
    // Not every response has a place for the reason.
    if (complain && std::has_single_bit(++refused_))
      complain(fmt::format("{} is refused: {} ({} such so far)", service, actor->not_active(), refused_));
    return;
  }
  const Health health = off_lane ? Health::ok : actor->health(now);
  const bool accepted =
      handler.handle(request.cdr, request.from, Tick{.now = now, .health = health, .sequence = calls_});
  if (accepted) {
    ++calls_;
  } else if (handler.refuse) {
    refuse(request.from, "the request holds no " + std::string(type.ros_name));
  }
  {
    const std::lock_guard lock(actor->mutex);
    statistics.run.add(thread_cpu_lap());
    if (!accepted) ++statistics.rejected;
  }
  if (!accepted) complain_of(request);
}

// The first, the second, the fourth: whoever floods us with such requests does not flood the log.
void ServiceEnd::complain_of(const Request& request) const {
  if (!complain || !std::has_single_bit(statistics.rejected)) return;
  complain(fmt::format("a request of {} holds no {} ({} bytes; {} such so far)", service, type.ros_name,
                       request.cdr.size(), statistics.rejected));
}

void ServiceEnd::refuse(const RequestId& from, const std::string& reason) {
  std::vector<std::uint8_t> cdr;
  if (handler.refuse) {
    handler.refuse(reason, cdr);
  } else {
    handler.empty(cdr);
  }
  reply(from, cdr);
}

void ServiceEnd::reply(const RequestId& to, std::span<const std::uint8_t> cdr) {
  sink->when_done([this, to, bytes = std::vector<std::uint8_t>(cdr.begin(), cdr.end())] {
    if (is_reader(to.client) && !writer->is_matched(to.client)) {
      const std::lock_guard lock(pending_mutex_);
      if (pending_.size() >= kMaxPending) pending_.pop_front();
      pending_.push_back({to, bytes, steady_time()});
    } else {
      write(to, bytes);
    }
  });
  flush();  // the match may have come between the two
}

void ServiceEnd::flush() {
  const std::lock_guard lock(pending_mutex_);
  if (pending_.empty()) return;
  const Duration now = steady_time();
  std::erase_if(pending_, [&](const Pending& reply) {
    if (!writer->is_matched(reply.to.client)) return now - reply.since > kLongestPending;
    write(reply.to, reply.cdr);
    return true;
  });
}

void ServiceEnd::write(const RequestId& to, std::span<const std::uint8_t> cdr) {
  writer->write_related(cdr, {to.client, to.sequence});
}

std::vector<ServiceEnd::Request> ServiceEnd::take_foreign() {
  sort_arrivals();
  return std::exchange(foreign_, {});
}

void ServiceEnd::sort_arrivals() {
  while (reader->take(sample_)) {
    Request request{id_of(sample_), sample_.cdr};
    if (dds::same_participant(sample_.writer, reader->guid())) {
      own_.push_back(std::move(request));
    } else {
      foreign_.push_back(std::move(request));
    }
  }
}

}  // namespace bw
