// `run --clock topic`: whatever an outside clock does, the robot's odometry goes on within a second of that clock.
#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <rosgraph_msgs/msg/clock.hpp>

#include "runtime/dds/participant.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/stamps.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

template <class M>
dds::EndpointOptions endpoint(const std::string& topic, const Qos& qos) {
  return {.topic = dds_topic(topic),
          .type = std::string(MessageTraits<M>::dds_name),
          .qos = qos,
          .user_data = user_data_of(std::string(MessageTraits<M>::type_hash))};
}

/// A graph on the clock of this test.
class OutsideClock {
 public:
  OutsideClock()
      : graph_({BANDWAGON_PROGRAM, "run", std::string(BANDWAGON_SOURCE_DIR) + "/tests/interop/one_room.yaml",
                "--clock", "topic", "--stay"}),
        participant_({.network = dds::Network::from_environment({})}),
        clock_(participant_.create_writer(endpoint<rosgraph_msgs::msg::Clock>("/clock", Qos::standard()))),
        odometry_(participant_.create_reader(endpoint<nav_msgs::msg::Odometry>("/odom", Qos::standard(1000)),
                                             [] {})) {
    if (!eventually([this] { return clock_->matched_readers() > 0 && odometry_->matched_writers() > 0; }))
      throw std::runtime_error("no graph: " + graph_.err());
  }

  void set(Time now) {
    now_ = now;
    rosgraph_msgs::msg::Clock message;
    message.clock(to_stamp(now));
    std::vector<std::uint8_t> cdr;
    serialize(message, cdr);
    clock_->write(cdr);
  }

  /// Lets `span` of the clock pass in steps that `next_step` gives, each lasting `slowness` times as long; the longest time
  /// of the clock without odometry.
  Duration run(Duration span, double slowness, const std::function<Duration()>& next_step) {
    Duration longest{};
    Time heard = now_;
    for (const Time end = now_ + span; now_ < end;) {
      const Duration step = next_step();
      std::this_thread::sleep_for(std::chrono::nanoseconds(
          static_cast<std::int64_t>(slowness * static_cast<double>(step.nanoseconds))));
      set(now_ + step);
      if (take()) heard = now_;
      longest = std::max(longest, now_ - heard);
    }
    return longest;
  }

  /// The newest stamp that came; true when one did.
  bool take() {
    bool is_new = false;
    for (dds::Sample sample; odometry_->take(sample);) {
      nav_msgs::msg::Odometry message;
      if (!deserialize(sample.cdr, message)) continue;
      newest_ = from_stamp(message.header().stamp());
      is_new = true;
    }
    return is_new;
  }

  Time now() const { return now_; }
  Time newest() const { return newest_; }
  std::string log() const { return graph_.err(); }
  int stop() {
    graph_.signal(SIGINT);
    return graph_.wait(std::chrono::seconds(20)).value_or(-1);
  }

 private:
  Process graph_;
  dds::Participant participant_;
  std::unique_ptr<dds::Writer> clock_;
  std::unique_ptr<dds::Reader> odometry_;
  Time now_;
  Time newest_;
};

Duration ten_milliseconds() { return Duration::milliseconds(10); }

constexpr Time kNoon = {1'700'000'000'000'000'000};
constexpr Duration kSoon = Duration::milliseconds(1000);

TEST(ClockTopic, ScenariosForNow) {
  OutsideClock clock;
  clock.set(kNoon);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> ms(1, 40);
  const auto irregular = [&] { return Duration::milliseconds(ms(random)); };
  const auto say = [&](const char* what, Duration longest) {
    std::cout << what << " " << longest.to_seconds() << " behind "
              << (clock.now() - clock.newest()).to_seconds() << std::endl;
  };
  say("start", clock.run(Duration::seconds(3.0), 2.0, ten_milliseconds));
  say("irregular", clock.run(Duration::seconds(3.0), 2.0, irregular));
  clock.set(clock.now() + Duration::seconds(5.0));
  say("ahead 5", clock.run(Duration::seconds(3.0), 2.0, ten_milliseconds));
  clock.set(clock.now() + Duration::seconds(-5.0));
  say("back 5", clock.run(Duration::seconds(3.0), 2.0, ten_milliseconds));
  clock.set(clock.now() + Duration::seconds(-0.3));
  say("back 0.3", clock.run(Duration::seconds(3.0), 2.0, ten_milliseconds));
  clock.set({5'000'000'000});
  say("restart", clock.run(Duration::seconds(3.0), 2.0, ten_milliseconds));
  std::cout << clock.log();
  EXPECT_EQ(clock.stop(), 0);
}

}  // namespace
}  // namespace bw::test
