// Two robots of one graph cross in the hallway, each from its end to the other's, among walkers. The full
// count of 20 seeds:
//   BANDWAGON_CROSSINGS=20 build/release/bin/test_two_robots
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>

#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::GroundTruth;
using bandwagon_msgs::msg::NavigationStatus;
using bandwagon_msgs::msg::Tracks;
using nav_msgs::msg::Odometry;

constexpr std::uint32_t kFirstRobot = 2'000'000'000;
constexpr double kRadius = 0.3;  // [m], config/robots/generic.yaml

int crossings() {
  const char* text = std::getenv("BANDWAGON_CROSSINGS");
  return text != nullptr ? std::max(1, std::atoi(text)) : 2;
}

struct Crossing {
  std::array<bool, 2> has_arrived{};
  std::array<double, 2> arrived_at{};         ///< [s]
  std::array<std::uint32_t, 2> contacts{};    ///< with anybody, until the robot arrived
  std::array<std::uint32_t, 2> with_robot{};  ///< samples in which the bodies of the robots overlap
  std::array<int, 2> told_tracks{};           ///< messages with the other's own word
  double nearest = std::numeric_limits<double>::infinity();  ///< the robots, rim to rim [m]
  std::string sha256;
};

/// Listens to both robots; ends the run when both have arrived. Passes their words on to /relay/robotN while
/// `passes_on` says so.
class Watcher final : public Component {
 public:
  Watcher(Crossing& seen, std::function<bool(double t)> passes_on)
      : seen_(seen), passes_on_(std::move(passes_on)) {}

  void configure(Setup& setup) override {
    finish_ = setup.finish_run();
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string robot = "/robot" + std::to_string(i + 1);
      setup.input<GroundTruth>(robot + "/sim/ground_truth", Qos::standard(),
                               [this, i](const auto& m, const Tick&) { see(i, m); });
      setup.input<NavigationStatus>(robot + "/navigation_status", Qos::standard(),
                                    [this, i](const auto& m, const Tick& tick) { hear(i, m, tick); });
      setup.input<Tracks>(robot + "/tracks", Qos::standard(), [this, i](const auto& m, const Tick&) {
        const auto& tracks = m.tracks();
        seen_.told_tracks[i] +=
            std::ranges::any_of(tracks, [](const auto& track) { return track.id() >= kFirstRobot; });
      });
      relays_[i] = setup.output<Odometry>("/relay" + robot + "/odometry/filtered");
      setup.input<Odometry>(robot + "/odometry/filtered", Qos::standard(50),
                            [this, i](const auto& m, const Tick& tick) {
                              if (passes_on_(seconds_since_start(tick.now))) relays_[i].publish(m);
                            });
    }
  }

 private:
  void see(std::size_t i, const GroundTruth& truth) {
    if (!seen_.has_arrived[i]) seen_.contacts[i] = truth.contacts();
    for (const auto& other : truth.people()) {
      if (other.id() < kFirstRobot) continue;
      const Vector2 apart(other.position().x() - truth.pose().position().x(),
                          other.position().y() - truth.pose().position().y());
      const double gap = apart.norm() - 2.0 * kRadius;
      seen_.nearest = std::min(seen_.nearest, gap);
      seen_.with_robot[i] += gap < 0.0;
    }
  }
  void hear(std::size_t i, const NavigationStatus& status, const Tick& tick) {
    if (status.status() != bandwagon_msgs::msg::NavigationStatus_Constants::SUCCEEDED) return;
    if (!seen_.has_arrived[i]) seen_.arrived_at[i] = seconds_since_start(tick.now);
    seen_.has_arrived[i] = true;
    if (seen_.has_arrived[0] && seen_.has_arrived[1]) finish_(true, "both have arrived");
  }

  Crossing& seen_;
  std::function<bool(double t)> passes_on_;
  std::array<Output<Odometry>, 2> relays_;
  std::function<void(bool, const std::string&)> finish_;
};

Crossing cross(
    std::uint64_t seed, const std::vector<std::string>& set = {},
    std::function<bool(double t)> passes_on = [](double) { return false; }) {
  Crossing seen;
  std::vector<ExtraComponent> extra;
  extra.push_back({"watcher", std::make_unique<Watcher>(seen, std::move(passes_on))});
  const std::string graph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/two_robots.yaml";
  Host host(load_graph(graph, set), {.clock = ClockMode::lockstep, .seed = seed}, std::move(extra));
  host.run(Duration::seconds(120.0));
  seen.sha256 = host.samples_sha256();
  std::cout << fmt::format(
      "seed {}: arrived {} {} at {:.1f} and {:.1f} s, contacts {} {}, robots {:.2f} m apart at least\n", seed,
      seen.has_arrived[0], seen.has_arrived[1], seen.arrived_at[0], seen.arrived_at[1], seen.contacts[0],
      seen.contacts[1], seen.nearest);
  return seen;
}

void expect_clean(const Crossing& seen, std::uint64_t seed) {
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(seen.has_arrived[i]) << "seed " << seed << ", robot" << i + 1;
    EXPECT_EQ(seen.contacts[i], 0U) << "seed " << seed << ", robot" << i + 1;
    EXPECT_EQ(seen.with_robot[i], 0U) << "seed " << seed << ", robot" << i + 1;
  }
}

TEST(TwoRobots, CrossInTheHallwayWithoutContact) {
  for (int seed = 1; seed <= crossings(); ++seed) {
    const Crossing seen = cross(static_cast<std::uint64_t>(seed));
    expect_clean(seen, static_cast<std::uint64_t>(seed));
    // Each knew of the other by its word for more than five seconds: tracks come at 10 Hz.
    EXPECT_GT(seen.told_tracks[0], 50) << "seed " << seed;
    EXPECT_GT(seen.told_tracks[1], 50) << "seed " << seed;
  }
}

// Nothing is heard of the other from 6 s on, before they meet (18 m apart, 1 m/s each: not before 9 s).
// People are not what is tried here: a walker may run into a robot that stands.
TEST(TwoRobots, DoNotTouchEachOtherWhenTheyFallSilent) {
  const std::vector<std::string> relayed = {"other_robots.robots=[/relay/robot1, /relay/robot2]"};
  for (int seed = 1; seed <= std::max(1, crossings() / 2); ++seed) {
    const Crossing seen = cross(static_cast<std::uint64_t>(seed), relayed, [](double t) { return t < 6.0; });
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(seen.has_arrived[i]) << "seed " << seed << ", robot" << i + 1;
      EXPECT_EQ(seen.with_robot[i], 0U) << "seed " << seed << ", robot" << i + 1;
    }
  }
}

// Each behind the cables of its own base and laser: 2 m, in which firmware, driver, sweep and the scans of
// both are needed.
TEST(TwoRobots, DriveThroughEmulatedBasesAndLasers) {
  const std::string robots = std::string(BANDWAGON_SOURCE_DIR) + "/config/robots/";
  for (const char* robot : {"kobuki.yaml", "eddie.yaml"}) {
    const Crossing seen = cross(3, {"robot=" + robots + robot, "emulate=true", "robot1/navigator.goal.x=3.0",
                                    "robot2/navigator.goal.x=17.0"});
    expect_clean(seen, 3);
    // 2 m at 0.65 m/s, 3 s until the robot knows where it is.
    EXPECT_GT(seen.arrived_at[0], 3.0) << robot;
    EXPECT_LT(seen.arrived_at[0], 20.0) << robot;
  }
}

TEST(TwoRobots, OneSeedIsOneRun) {
  // Both goals a little ahead, so that it is short.
  const std::vector<std::string> near = {"robot1/navigator.goal.x=3.0", "robot2/navigator.goal.x=17.0"};
  const std::string once = cross(3, near).sha256;
  EXPECT_EQ(once, cross(3, near).sha256);
  EXPECT_NE(once, cross(4, near).sha256);
}

}  // namespace
}  // namespace bw
