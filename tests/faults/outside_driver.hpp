// A ROS 2 node outside of the graph that wants to drive, and sees what the robot does: a participant of its
// own.
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>

#include "runtime/dds/participant.hpp"
#include "runtime/ros/node_announcement.hpp"
#include "runtime/stamps.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::test {

inline geometry_msgs::msg::Twist twist(double v) {
  geometry_msgs::msg::Twist message;
  message.linear().x(v);
  return message;
}

inline Time system_time() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(now).count()};
}

template <class M>
dds::EndpointOptions ros_end(const std::string& topic, const Qos& qos = Qos::standard()) {
  return {
      .topic = "rt/" + topic, .type = std::string(MessageTraits<M>::dds_name), .qos = qos, .user_data = {}};
}

/// Publishes on one topic as node `name` until it goes out of scope.
template <class M>
class OutsideDriver {
 public:
  OutsideDriver(const std::string& name, const std::string& topic, std::chrono::microseconds period,
                std::function<M()> message)
      : writer_(participant_.create_writer(ros_end<M>(topic))), node_(participant_, name) {
    node_.add(*writer_);
    node_.publish();
    thread_ = std::thread([this, period, message] {
      std::vector<std::uint8_t> cdr;
      for (auto next = std::chrono::steady_clock::now(); !over_;
           std::this_thread::sleep_until(next += period)) {
        serialize(message(), cdr);
        last_ns_ = system_time().nanoseconds;
        writer_->write(cdr);
        ++sent_;
      }
    });
  }
  ~OutsideDriver() { stop(); }
  void stop() {
    over_ = true;
    if (thread_.joinable()) thread_.join();
  }
  /// When it wrote last.
  Time last() const { return {last_ns_}; }
  int sent() const { return sent_; }
  bool is_heard() const { return writer_->matched_readers() > 0; }

 private:
  dds::Participant participant_{{.network = dds::Network::from_environment({})}};
  std::unique_ptr<dds::Writer> writer_;
  NodeAnnouncement node_;
  std::atomic<bool> over_ = false;
  std::atomic<int> sent_ = 0;
  std::atomic<std::int64_t> last_ns_ = 0;
  std::thread thread_;
};

/// Looks at the true robot.
class Spectator {
 public:
  struct Sight {
    double t = 0.0;  ///< component clock [s]
    double x = 0.0, y = 0.0, v = 0.0;
  };

  /// The newest that is known; nothing before the first.
  std::optional<Sight> look() {
    dds::Sample sample;
    for (bandwagon_msgs::msg::GroundTruth truth; reader_->take(sample) && deserialize(sample.cdr, truth);) {
      last_ = Sight{.t = from_stamp(truth.header().stamp()).to_seconds(),
                    .x = truth.pose().position().x(),
                    .y = truth.pose().position().y(),
                    .v = truth.twist().linear().x()};
      farthest_ = std::max(farthest_, from_ ? std::hypot(last_->x - from_->x, last_->y - from_->y) : 0.0);
    }
    return last_;
  }
  bool sees(const std::function<bool(const Sight&)>& condition) {
    return eventually([&] {
      const auto sight = look();
      return sight && condition(*sight);
    });
  }
  /// How far the robot was at most from where it is now, in the next `seconds` of its clock [m]; infinite
  /// when that clock stands still.
  double moves_within(double seconds) {
    if (!sees([](const Sight&) { return true; })) return HUGE_VAL;
    from_ = last_;
    farthest_ = 0.0;
    const double end = last_->t + seconds;
    const bool is_over = sees([end](const Sight& sight) { return sight.t >= end; });
    return is_over ? farthest_ : HUGE_VAL;
  }
  bool sees_it_stand() {
    return sees([](const Sight& sight) { return std::abs(sight.v) < 1e-3; });
  }

 private:
  dds::Participant participant_{{.network = dds::Network::from_environment({})}};
  std::unique_ptr<dds::Reader> reader_ = participant_.create_reader(
      ros_end<bandwagon_msgs::msg::GroundTruth>("sim/ground_truth", Qos::standard(1000)), [] {});
  std::optional<Sight> last_, from_;
  double farthest_ = 0.0;
};

}  // namespace bw::test
