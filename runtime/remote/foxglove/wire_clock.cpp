#include "runtime/remote/foxglove/wire_clock.hpp"

#include <algorithm>
#include <iterator>

#include <rosgraph_msgs/msg/clock.hpp>

#include "runtime/ros/dds_names.hpp"
#include "runtime/stamps.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw::foxglove {
namespace {

using Clock = rosgraph_msgs::msg::Clock;

constexpr const char* kTopic = "rt/clock";
constexpr int kDepth = 1000;  // that many steps may come between two looks
constexpr std::size_t kMaxSteps = 1000;
constexpr std::chrono::milliseconds kPatience{1000};    // with a /clock that says nothing
constexpr Duration kStep = Duration::milliseconds(10);  // of the system clock, when it is told

}  // namespace

void WireClock::look(const std::vector<dds::Endpoint>& endpoints) {
  is_published_ = std::ranges::any_of(endpoints, [](const dds::Endpoint& e) {
    return e.is_writer && e.topic == kTopic && e.type == MessageTraits<Clock>::dds_name;
  });
  open_or_close();
}

void WireClock::want(bool is_wanted) {
  is_wanted_ = is_wanted;
  open_or_close();
}

void WireClock::open_or_close() {
  if ((is_wanted_ && is_published_) == (reader_ != nullptr)) return;
  steps_.clear();
  if (reader_) {
    link_.remove(*reader_);
    reader_.reset();
    return;
  }
  opened_ = std::chrono::steady_clock::now();
  Qos qos = Qos::clock();
  qos.depth = kDepth;
  reader_ = link_.participant.create_reader(
      {.topic = kTopic,
       .type = std::string(MessageTraits<Clock>::dds_name),
       .qos = qos,
       .user_data = user_data_of(std::string(MessageTraits<Clock>::type_hash))},
      [] {});
  link_.add(*reader_);
}

void WireClock::hear() {
  Clock message;
  while (reader_->take(sample_)) {
    if (deserialize(sample_.cdr, message)) steps_[sample_.received] = from_stamp(message.clock());
  }
  while (steps_.size() > kMaxSteps) steps_.erase(steps_.begin());
}

bool WireClock::is_known() {
  if (!reader_ || !steps_.empty()) return true;
  hear();
  return !steps_.empty() || std::chrono::steady_clock::now() - opened_ > kPatience;
}

Time WireClock::time_of(Time received) {
  if (!reader_) return received;
  hear();  // what came before this sample is there by now
  if (steps_.empty()) return received;
  const auto after = steps_.upper_bound(received);
  return after == steps_.begin() ? after->second : std::prev(after)->second;
}

void WireClock::tell(Time now) {
  const bool is_small_step = !reader_ && now >= told_ && now - told_ < kStep;
  if (now == told_ || is_small_step || link_.listener == nullptr) return;
  told_ = now;
  link_.listener->on_time(now);
}

void WireClock::tell_newest() {
  if (!reader_) return;
  hear();
  if (!steps_.empty()) tell(steps_.rbegin()->second);
}

}  // namespace bw::foxglove
