// `run --clock topic`: whatever an outside clock does, the robot's odometry goes on within a second of that
// clock.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <geometry_msgs/msg/pose_stamped.hpp>
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
        goal_(participant_.create_writer(
            endpoint<geometry_msgs::msg::PoseStamped>("/goal_pose", Qos::standard()))),
        odometry_(participant_.create_reader(endpoint<nav_msgs::msg::Odometry>("/odom", Qos::standard(1000)),
                                             [this] {
                                               const std::lock_guard lock(mutex_);
                                               has_news_ = true;
                                               news_.notify_one();
                                             })) {
    const auto all_there = [this] {
      return clock_->matched_readers() > 0 && goal_->matched_readers() > 0 &&
             odometry_->matched_writers() > 0;
    };
    if (!eventually(all_there)) throw std::runtime_error("no graph: " + graph_.err());
  }

  void set(Time now) {
    now_ = now;
    rosgraph_msgs::msg::Clock message;
    message.clock(to_stamp(now));
    write(*clock_, message);
  }
  void jump(Duration by) { set(now_ + by); }

  void send_goal(double x) {
    geometry_msgs::msg::PoseStamped message;
    message.header().frame_id("map");
    message.pose().position().x(x);
    message.pose().orientation().w(1.0);
    write(*goal_, message);
  }

  /// Lets `span` of the clock pass in steps that `next_step` gives, each lasting `slowness` times as long;
  /// the longest time of the clock without odometry of about now. A machine that is held up holds up the
  /// clock as well.
  Duration run(Duration span, double slowness, const std::function<Duration()>& next_step) {
    Duration longest{};
    Time heard = now_;
    for (const Time end = now_ + span; now_ < end;) {
      const Duration step = next_step();
      const double pause = slowness * static_cast<double>(step.nanoseconds);
      std::this_thread::sleep_for(std::chrono::nanoseconds(static_cast<std::int64_t>(pause)));
      set(now_ + step);
      if (take() || (now_ - heard > Duration::milliseconds(100) && wait_for_news() && take())) heard = now_;
      longest = std::max(longest, now_ - heard);
    }
    return longest;
  }

  double x() const { return x_; }
  std::string log() const { return graph_.err(); }
  int stop() {
    graph_.signal(SIGINT);
    return graph_.wait(std::chrono::seconds(20)).value_or(-1);
  }

 private:
  template <class M>
  static void write(dds::Writer& writer, const M& message) {
    std::vector<std::uint8_t> cdr;
    serialize(message, cdr);
    writer.write(cdr);
  }
  /// True when odometry came that is of about now.
  bool take() {
    constexpr Duration kOld = Duration::milliseconds(600);
    bool is_new = false;
    has_news_ = false;
    for (dds::Sample sample; odometry_->take(sample);) {
      nav_msgs::msg::Odometry message;
      if (!deserialize(sample.cdr, message)) continue;
      const Duration age = now_ - from_stamp(message.header().stamp());
      is_new |= age < kOld && age > kOld * -1;
      x_ = message.pose().pose().position().x();
    }
    return is_new;
  }
  bool wait_for_news() {
    std::unique_lock lock(mutex_);
    return news_.wait_for(lock, std::chrono::milliseconds(100), [this] { return has_news_.load(); });
  }

  Process graph_;
  std::mutex mutex_;
  std::condition_variable news_;
  std::atomic<bool> has_news_ = false;
  dds::Participant participant_;
  std::unique_ptr<dds::Writer> clock_;
  std::unique_ptr<dds::Writer> goal_;
  std::unique_ptr<dds::Reader> odometry_;
  Time now_;
  double x_ = 0.0;  ///< of the robot since its start
};

constexpr Time kNoon = {1'700'000'000'000'000'000};
constexpr Duration kSoon = Duration::milliseconds(1000);
constexpr Duration kWhile = Duration::milliseconds(1500);

Duration ten_milliseconds() { return Duration::milliseconds(10); }

// At half the real pace, with even steps and uneven ones; ahead and back by seconds; and from another year
// on. The first stamp comes when the graph is up already. What comes back must be there within a second of
// the clock.
TEST(ClockTopic, EverythingRunsAgainASecondAfterAnyJump) {
  OutsideClock clock;
  clock.set(kNoon);
  EXPECT_LE(clock.run(kWhile, 2.0, ten_milliseconds), kSoon) << "from the start";
  std::mt19937 random(5);
  std::uniform_int_distribution<int> milliseconds(1, 40);
  const auto uneven = [&] { return Duration::milliseconds(milliseconds(random)); };
  EXPECT_LE(clock.run(kWhile, 2.0, uneven), kSoon) << "with uneven steps";
  clock.jump(Duration::seconds(5.0));
  EXPECT_LE(clock.run(kWhile, 1.0, ten_milliseconds), kSoon) << "5 s ahead";
  clock.jump(Duration::seconds(-5.0));
  EXPECT_LE(clock.run(kWhile, 1.0, ten_milliseconds), kSoon) << "5 s back";
  clock.jump(Duration::seconds(-0.3));
  EXPECT_LE(clock.run(kWhile, 1.0, ten_milliseconds), kSoon) << "0.3 s back";
  clock.set(Time::seconds(5.0));
  EXPECT_LE(clock.run(kWhile, 1.0, ten_milliseconds), kSoon) << "from 5 s on";
  EXPECT_EQ(clock.stop(), 0);
}

// 1 m to a goal that is sent while the clock stands 60 s and 2 s before what it was.
TEST(ClockTopic, AGoalIsReachedAfterTheClockWentBack) {
  OutsideClock clock;
  clock.set(kNoon);
  clock.run(kWhile, 1.0, ten_milliseconds);
  clock.jump(Duration::seconds(-60.0));
  clock.run(kSoon, 1.0, ten_milliseconds);
  clock.send_goal(2.0);
  clock.run(kSoon, 1.0, ten_milliseconds);
  clock.jump(Duration::seconds(-2.0));
  const auto is_reached = [&] { return clock.log().find("goal 1: reached in") != std::string::npos; };
  for (int seconds = 0; seconds < 15 && !is_reached(); ++seconds) clock.run(kSoon, 1.0, ten_milliseconds);
  EXPECT_TRUE(is_reached()) << clock.log();
  EXPECT_NEAR(clock.x(), 1.0, 0.3);
  EXPECT_EQ(clock.stop(), 0);
}

}  // namespace
}  // namespace bw::test
