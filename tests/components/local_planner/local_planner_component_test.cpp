// The local planner on its topics in lock-step, with a script in place of robot, map and navigator.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/local_planner/planner_registry.hpp"
#include "tests/components/local_planner/planner_neighbours.hpp"

namespace bw {
namespace {

class EveryPlanner : public testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(LocalPlannerComponent, EveryPlanner, testing::ValuesIn(planner_names()),
                         [](const auto& planner) { return std::string(planner.param); });

// 3 m at 1 m/s and 1 m/s^2 take 4 s; every planner has arrived after 12 s, past a post beside the path, and
// kept the limits of the base in every command.
TEST_P(EveryPlanner, FollowsThePathOfTheMapToItsEnd) {
  Neighbours n;
  n.requests = {{5, FollowRequest_Constants::FOLLOW}};
  n.obstacles = one_disc(1.5, 0.8, 0.2);
  n.run(12.0, "parameters: {algorithm: " + std::string(GetParam()) + ", command_lead: 0.1}");
  EXPECT_LT((n.X_MB.position() - Vector2(3.0, 0.0)).norm(), 0.15);
  EXPECT_NEAR(n.twist.v, 0.0, 0.02);
  ASSERT_FALSE(n.statuses.empty());
  EXPECT_EQ(n.statuses.back().status(), FollowStatus_Constants::FOLLOWING) << n.statuses.back().reason();
  EXPECT_EQ(n.statuses.back().id(), kRequestId);
  EXPECT_LT(n.statuses.back().distance_to_goal(), 0.15);
  EXPECT_EQ(n.plan.header().frame_id(), "odom");
  const Limits limits;
  for (std::size_t i = 0; i < n.commands.size(); ++i) {
    const Twist2& now = n.commands[i].second;
    const Twist2& before = i == 0 ? Twist2{} : n.commands[i - 1].second;
    ASSERT_LE(now.v, limits.v_max + 1e-9);
    ASSERT_LE(std::abs(now.omega), limits.omega_max + 1e-9);
    ASSERT_LE(std::abs(now.v - before.v), limits.stop_deceleration * 0.1 + 1e-9) << i;
  }
  EXPECT_EQ(n.diagnostics["planner"], GetParam());
}

// 1 m/s at 3 s, when 0.3 m/s is asked for: 0.7 s of braking with 1 m/s^2 and a second for planners that brake
// more softly.
// What is no limit changes nothing; 0 takes it away.
TEST_P(EveryPlanner, KeepsASpeedLimit) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Neighbours n;
  n.requests = {{5, FollowRequest_Constants::FOLLOW}};
  n.path.clear();
  for (int i = 0; i <= 20; ++i) n.path.push_back({1.0 * i, 0.0, 0.0});
  n.speed_limits = {{150, {false, 0.3}},
                    {300, {false, kNan}},
                    {310, {false, -1.0}},
                    {320, {true, 150.0}},
                    {400, {true, 0.0}}};
  n.run(11.0, "parameters: {algorithm: " + std::string(GetParam()) + ", command_lead: 0.1}");
  const Limits limits;
  // mppi's shipped weights balance at 0.67 m/s, and speed up slowly to it (mppi/theory.md 5.8).
  const double brisk = GetParam() == "mppi" ? 0.35 : 0.8;
  double before_limit = 0.0;
  double slowest = 1.0;
  for (std::size_t i = 1; i < n.commands.size(); ++i) {
    const auto& [t, now] = n.commands[i];
    ASSERT_LE(std::abs(now.v - n.commands[i - 1].second.v), limits.stop_deceleration * 0.1 + 1e-9) << t;
    if (t < 3.0) before_limit = std::max(before_limit, now.v);
    if (t > 5.0 && t < 8.0) {
      ASSERT_LE(now.v, 0.3 + 1e-9) << t;
      slowest = std::min(slowest, now.v);
    }
  }
  EXPECT_GT(before_limit, brisk);
  EXPECT_GT(slowest, 0.15);
  EXPECT_GT(n.twist.v, brisk);
}

// The drive ends within half of what counts as reached, unless the planner has a figure of its own, which
// counts as long as it lies inside.
TEST(LocalPlannerComponent, EndsTheDriveWellWithinWhatCountsAsReached) {
  const auto left_to_go = [](double xy_tolerance, const std::string& parameters) {
    Neighbours n;
    n.requests = {{5, FollowRequest_Constants::FOLLOW}};
    n.xy_tolerance = xy_tolerance;
    n.run(12.0, "parameters: {algorithm: teb, command_lead: 0.1" + parameters + "}");
    EXPECT_NEAR(n.twist.v, 0.0, 0.02);
    return (n.X_MB.position() - Vector2(3.0, 0.0)).norm();
  };
  EXPECT_LT(left_to_go(0.0, ""), 0.1);  // says nothing: the usual 0.2 m
  const double wide = left_to_go(2.4, "");
  EXPECT_LT(wide, 1.2);
  EXPECT_GT(wide, 0.4);  // from 1 m/s it comes to rest within 0.5 m, and a cycle and the lead more
  EXPECT_LT(left_to_go(2.4, ", xy_goal_tolerance: 0.1"), 0.1);
  const double explicitly = left_to_go(2.4, ", xy_goal_tolerance: 1.2");
  EXPECT_EQ(explicitly, wide);
  EXPECT_LT(left_to_go(0.2, ", xy_goal_tolerance: 1.2"), 0.1);  // would stop short of the goal: not used
}

TEST(LocalPlannerComponent, IsSilentUntilToldAndAfterItStopped) {
  Neighbours n;
  n.requests = {{50, FollowRequest_Constants::FOLLOW}, {150, FollowRequest_Constants::STOP}};
  n.run(5.0);
  ASSERT_FALSE(n.commands.empty());
  EXPECT_GE(n.commands.front().first, 1.0);  // 50 steps of 0.02 s
  // Asked to stop at 3 s at 1 m/s at most; 2 m/s^2 take 0.5 s, and the last command is for standing.
  EXPECT_LE(n.commands.back().first, 3.02 + 0.7);
  EXPECT_EQ(n.commands.back().second, Twist2{});
  EXPECT_GT(n.X_MB.x, 0.8);
  EXPECT_NEAR(static_cast<double>(n.statuses.size()), 50.0, 1.0);  // ten a second, whatever happens
  EXPECT_EQ(n.statuses.front().status(), FollowStatus_Constants::IDLE);
  EXPECT_EQ(n.statuses[25].status(), FollowStatus_Constants::FOLLOWING);
  EXPECT_EQ(n.statuses.back().status(), FollowStatus_Constants::IDLE);
  EXPECT_EQ(n.diagnostic_message, "idle");
}

TEST(LocalPlannerComponent, SaysWhatIsMissing) {
  Neighbours no_odometry;
  no_odometry.odometry_begins = 1'000'000;
  no_odometry.requests = {{0, FollowRequest_Constants::FOLLOW}};
  no_odometry.run(1.0);
  EXPECT_EQ(no_odometry.statuses.back().status(), FollowStatus_Constants::FAILED);
  EXPECT_EQ(no_odometry.statuses.back().reason(), "no odometry yet");

  Neighbours no_transform;
  no_transform.transforms = false;
  no_transform.requests = {{0, FollowRequest_Constants::FOLLOW}};
  no_transform.run(1.5);
  EXPECT_EQ(no_transform.statuses.back().status(), FollowStatus_Constants::FAILED);
  EXPECT_EQ(no_transform.statuses.back().reason(), "no transform from map to odom");
  EXPECT_EQ(no_transform.X_MB, kStart);
  EXPECT_EQ(no_transform.diagnostic_message, "no transform from map to odom");
}

/// [s] of the last command that is not for standing; before all where there is none.
double last_motion(const Neighbours& n) {
  const auto moving = std::find_if(n.commands.rbegin(), n.commands.rend(),
                                   [](const auto& command) { return command.second.v > 0.0; });
  return moving == n.commands.rend() ? -1.0 : moving->first;
}

/// Under way along 10 m, while something falls silent; it says why it stops, and that it is to be braked hard.
void expect_stop(Neighbours& n, const std::string& settings, double earliest, double latest,
                 const std::string& reason) {
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  n.path = {{0, 0, 0}, {10, 0, 0}};
  n.run(3.5, settings);
  EXPECT_GT(last_motion(n), earliest);
  EXPECT_LT(last_motion(n), latest);
  EXPECT_EQ(n.statuses.back().status(), FollowStatus_Constants::FAILED);
  EXPECT_EQ(n.statuses.back().reason(), reason);
  ASSERT_FALSE(n.brakes_hard.empty());
  EXPECT_TRUE(n.brakes_hard.back());
}

// Odometry ends at 2 s while the robot drives. It is stale 0.3 s later; the commands for standing follow at
// the next cycle, since the velocity last heard of is all that is known: 2 m/s^2 over the lead of 0.5 s take
// away 1 m/s at once.
TEST(LocalPlannerComponent, StopsWhenOdometryIsStale) {
  Neighbours n;
  n.odometry_ends = 100;
  expect_stop(n, "parameters: {command_lead: 0.5}, inputs: {odom: {max_age: 300ms, on_stale: stop}}", 2.0,
              2.4, "a needed input is stale");
}

// Whoever tells where odom is in map ends at 2 s, as a localization that is killed. Half a second later it is no pose any more;
// a cycle of 0.1 s after that the commands are for standing, and people and obstacles are as fresh as ever.
TEST(LocalPlannerComponent, StopsWhenTheTransformIsStale) {
  Neighbours n;
  n.transforms_end = 100;
  expect_stop(n, "parameters: {command_lead: 0.5}", 2.3, 2.61,
              "the transform from map to odom is older than 0.5 s");
}

TEST(LocalPlannerComponent, BacksOffUntilSomethingIsBehind) {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::BACK_OFF}};
  // Surface of the disc at x = -0.8; the robot (0.3 m) keeps 0.15 m: its centre ends at -0.35 m, within the
  // 0.02 m of one cycle.
  n.obstacles = one_disc(-1.0, 0.0, 0.2);
  n.run(6.0, "parameters: {back_off_margin: 0.15, command_lead: 0.1}");
  EXPECT_GT(n.X_MB.x, -0.37 - 1e-9);
  EXPECT_LT(n.X_MB.x, -0.25);
  for (const auto& [time, twist] : n.commands) EXPECT_GE(twist.v, -0.2 - 1e-9);
  EXPECT_EQ(n.statuses.back().status(), FollowStatus_Constants::BLOCKED);
  EXPECT_EQ(n.statuses.back().reason(), "something is close behind");
}

// A track of 0.5 s ago that walks at 1 m/s from (2, 2) in the map is at (2, 2.5) now; the first dot is half a
// second further. All in odom.
TEST(LocalPlannerComponent, TracksAreCarriedToNowAndIntoOdom) {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  n.tracks_age = 0.5;
  Track track;
  track.confidence(1.0);
  track.id(1);
  track.radius(0.3);
  track.position(to_point({2.0, 2.0}));
  track.velocity(to_vector3({0.0, 1.0}));
  n.tracks.tracks().push_back(track);
  n.run(0.5);
  const auto dots = std::find_if(n.markers.markers().begin(), n.markers.markers().end(),
                                 [](const auto& m) { return m.ns() == "predictions"; });
  ASSERT_NE(dots, n.markers.markers().end());
  EXPECT_EQ(dots->header().frame_id(), "odom");
  const Vector2 expected = inverse(kX_MO) * Vector2(2.0, 3.0);
  EXPECT_NEAR(dots->points()[0].x(), expected.x(), 0.021);  // one step of 0.02 s at 1 m/s
  EXPECT_NEAR(dots->points()[0].y(), expected.y(), 0.021);
}

/// Three seconds along a wall of one disc; parameters are changed at 2.05 s, between the cycles of 2.0 and
/// 2.1 s.
std::vector<std::pair<double, Twist2>> drive_with(const std::vector<NamedValue>& change,
                                                  const std::string& refusal = "") {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  n.path = {{0, 0, 0}, {10, 0, 0}};
  n.obstacles = one_disc(3.0, 0.8, 0.2);
  n.change = change;
  n.run(3.0);
  EXPECT_EQ(n.refusals, std::vector<std::string>(change.empty() ? 0 : 1, refusal));
  return n.commands;
}

// The command of 2.1 s is the first that a changed distance to obstacles has a part in.
TEST(LocalPlannerComponent, TakesChangedParametersInTheNextCycle) {
  const auto before = drive_with({});
  const auto changed = drive_with({{"teb.band.min_obstacle_dist", 0.8}});
  ASSERT_EQ(changed.size(), before.size());
  const auto [first, other] = std::mismatch(before.begin(), before.end(), changed.begin());
  ASSERT_NE(first, before.end());
  EXPECT_NEAR(first->first, 2.1, 1e-6);
}

// A parameter of another planner has this one made anew. It drives on as if nothing had been: its bands are
// still there.
TEST(LocalPlannerComponent, KeepsItsBandsWhenParametersChange) {
  EXPECT_EQ(drive_with({{"hrvo.lookahead", 2.0}}), drive_with({}));
}

TEST(LocalPlannerComponent, DrivesOnWhenAChangeIsRefused) {
  const auto before = drive_with({});
  EXPECT_EQ(drive_with({{"teb.band.min_obstacle_dist", -0.1}},
                       "teb.band.min_obstacle_dist = -0.1: must be between 0 and 10 m"),
            before);
  EXPECT_EQ(
      drive_with({{"algorithm", "dwa"}},
                 "algorithm may not change while local_planner is active; deactivate and clean up first"),
      before);
}

TEST(LocalPlannerComponent, RefusesAnUnknownPlannerByName) {
  Neighbours n;
  try {
    n.run(0.1, "parameters: {algorithm: tbe}");
    FAIL();
  } catch (const std::exception& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("tbe"), std::string::npos) << text;
    for (const std::string_view name : planner_names()) EXPECT_NE(text.find(name), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace bw
