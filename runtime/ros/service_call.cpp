#include "runtime/ros/service_call.hpp"

#include <condition_variable>
#include <mutex>

#include "runtime/ros/service_ends.hpp"

namespace bw {
namespace {

using Clock = std::chrono::steady_clock;

/// Wakes one thread from DDS threads.
class Bell {
 public:
  void ring() {
    const std::lock_guard lock(mutex_);
    rung_ = true;
    wake_.notify_one();
  }
  /// False at `end`.
  bool wait(Clock::time_point end) {
    std::unique_lock lock(mutex_);
    const bool rung = wake_.wait_until(lock, end, [this] { return rung_; });
    rung_ = false;
    return rung;
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool rung_ = false;
};

}  // namespace

std::optional<std::vector<std::uint8_t>> call_service(dds::Participant& participant, const std::string& name,
                                                      const ServiceType& type,
                                                      std::span<const std::uint8_t> request,
                                                      std::chrono::milliseconds limit) {
  const Clock::time_point end = Clock::now() + limit;
  Bell bell;
  const auto ring = [&bell] { bell.ring(); };
  const auto reader = participant.create_reader(service_end(reply_topic(name), type.response), ring, ring);
  const auto writer = participant.create_writer(service_end(request_topic(name), type.request), ring);
  while (writer->matched_readers() == 0 || reader->matched_writers() == 0) {
    if (!bell.wait(end)) return std::nullopt;
  }
  const auto asked = writer->write_related(request, {reader->guid(), 0});
  if (!asked) return std::nullopt;
  dds::Sample sample;
  do {
    while (reader->take(sample)) {
      const dds::Guid& to = sample.related.guid;
      if ((to == reader->guid() || to == writer->guid()) && sample.related.sequence == asked->sequence)
        return std::move(sample.cdr);
    }
  } while (bell.wait(end));
  return std::nullopt;
}

}  // namespace bw
