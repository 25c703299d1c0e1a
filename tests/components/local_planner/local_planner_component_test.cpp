// The local planner on its topics in lock-step, with a script in place of robot, map and navigator.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/planner_cycle.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gtest/gtest.h>
#include <nav2_msgs/msg/speed_limit.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/msg/path.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/local_planner/planner_factory.hpp"
#include "components/messages/geometry.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/speed_limit.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/parameter_change.hpp"

namespace bw {
namespace {

using namespace bandwagon_msgs::msg;

constexpr double kStep = 0.02;      // [s] of the robot and of what it publishes
const Pose2 kX_MO{4.0, -3.0, 2.0};  // odometry began somewhere in the map, and turned
const Pose2 kStart{0.0, 0.0, 0.0};  // of the robot in the map
constexpr std::uint64_t kRequestId = 17;

/// The neighbours of the planner. The robot obeys at once; people and obstacles are in the map.
struct Neighbours {
  // What happens.
  std::map<int, std::uint8_t> requests;        ///< mode by step
  std::map<int, bw::SpeedLimit> speed_limits;  ///< by step
  std::vector<Pose2> path = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  Obstacles obstacles;
  Tracks tracks;
  double tracks_age = 0.0;  ///< [s] of their stamp
  double xy_tolerance = 0.0;
  int odometry_ends = 1'000'000;
  int odometry_begins = 0;
  bool transforms = true;
  std::vector<NamedValue> change;  ///< of the planner's parameters, at 2.05 s
  // What is seen.
  Pose2 X_MB = kStart;
  Twist2 twist;
  std::vector<std::pair<double, Twist2>> commands;  ///< [s] since the start
  std::vector<FollowStatus> statuses;
  std::vector<PlannerCycle> cycles;
  nav_msgs::msg::Path plan;
  visualization_msgs::msg::MarkerArray markers;
  std::map<std::string, std::string> diagnostics;
  std::string diagnostic_message;
  std::vector<std::string> refusals;  ///< of the changes

  void configure(bw::Setup& setup) {
    setup.input<geometry_msgs::msg::Twist>("cmd_vel_nav", Qos::command(),
                                           [this](const auto& m, const Tick& tick) {
                                             twist = from_twist(m);
                                             commands.emplace_back(seconds_since_start(tick.now), twist);
                                           });
    setup.input<FollowStatus>("follow_status", Qos::standard(50),
                              [this](const auto& m, const Tick&) { statuses.push_back(m); });
    setup.input<PlannerCycle>("local_planner_cycle", Qos::standard(50),
                              [this](const auto& m, const Tick&) { cycles.push_back(m); });
    setup.input<nav_msgs::msg::Path>("local_plan", Qos::standard(),
                                     [this](const auto& m, const Tick&) { plan = m; });
    setup.input<visualization_msgs::msg::MarkerArray>("local_planner_markers", Qos::standard(),
                                                      [this](const auto& m, const Tick&) { markers = m; });
    setup.input<diagnostic_msgs::msg::DiagnosticArray>(
        "/diagnostics", Qos::standard(),
        [this](const auto& m, const Tick&) {
          for (const auto& status : m.status()) {
            if (status.name() != "local_planner") continue;
            diagnostic_message = status.message();
            for (const auto& pair : status.values()) diagnostics[pair.key()] = pair.value();
          }
        },
        Need::optional);
    if (!change.empty()) change_parameters(setup, "/local_planner", 2.05, change, refusals);
    setup.every(
        Duration::seconds(kStep), "neighbours",
        [this, odometry = setup.output<nav_msgs::msg::Odometry>("odom"),
         obstacles_out = setup.output<Obstacles>("obstacles"), tracks_out = setup.output<Tracks>("tracks"),
         request = setup.output<FollowRequest>("follow_request"),
         speed_limit = setup.output<nav2_msgs::msg::SpeedLimit>("speed_limit"),
         tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) mutable {
          const int step = static_cast<int>(tick.sequence);
          X_MB = advance_exact(X_MB, twist, kStep);
          if (transforms) tf.publish(map_to_odom(tick.now));
          if (step >= odometry_begins && step < odometry_ends) odometry.publish(odom(tick.now));
          obstacles.header(make_header("map", tick.now));
          obstacles_out.publish(obstacles);
          tracks.header(make_header("map", tick.now - Duration::seconds(tracks_age)));
          tracks_out.publish(tracks);
          if (const auto limit = speed_limits.find(step); limit != speed_limits.end()) {
            nav2_msgs::msg::SpeedLimit limit_out;
            limit_out.percentage(limit->second.percentage);
            limit_out.speed_limit(limit->second.value);
            speed_limit.publish(limit_out);
          }
          if (!requests.contains(step)) return;
          FollowRequest message;
          message.id(kRequestId);
          message.mode(requests[step]);
          message.path(to_path("map", tick.now, path));
          message.xy_tolerance(xy_tolerance);
          request.publish(message);
        });
  }

  nav_msgs::msg::Odometry odom(Time now) const {
    nav_msgs::msg::Odometry message;
    message.header(make_header("odom", now));
    message.pose().pose(to_pose(inverse(kX_MO) * X_MB));
    message.twist().twist(to_twist_message(twist));
    return message;
  }
  static tf2_msgs::msg::TFMessage map_to_odom(Time now) {
    geometry_msgs::msg::TransformStamped transform;
    transform.header(make_header("map", now));
    transform.child_frame_id("odom");
    transform.transform().translation(to_vector3(kX_MO.position()));
    transform.transform().rotation(to_quaternion(kX_MO.theta));
    tf2_msgs::msg::TFMessage message;
    message.transforms().push_back(transform);
    return message;
  }
  void run(double seconds, const std::string& settings = "") {
    run_with_script("components: {local_planner: {" + settings + "}}", seconds,
                    [this](bw::Setup& setup) { configure(setup); });
  }
};

Obstacles one_disc(double x, double y, double radius) {
  Obstacles obstacles;
  obstacles.discs().resize(1);
  obstacles.discs()[0].x(static_cast<float>(x));
  obstacles.discs()[0].y(static_cast<float>(y));
  obstacles.discs()[0].radius(static_cast<float>(radius));
  return obstacles;
}

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

// 1 m/s at 3 s, when 0.3 m/s is asked for: 0.7 s of braking with 1 m/s^2 and a second for planners that brake more softly.
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
  EXPECT_GT(before_limit, 0.8);
  EXPECT_GT(slowest, 0.15);
  EXPECT_GT(n.twist.v, 0.8);
}

// The drive ends within half of what counts as reached, unless the planner has a figure of its own, which counts as long
// as it lies inside.
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

// Odometry ends at 2 s while the robot drives. It is stale 0.3 s later; the commands for standing follow at
// the next cycle, since the velocity last heard of is all that is known: 2 m/s^2 over the lead of 0.5 s take
// away 1 m/s at once.
TEST(LocalPlannerComponent, StopsWhenOdometryIsStale) {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  n.path = {{0, 0, 0}, {10, 0, 0}};
  n.odometry_ends = 100;
  n.run(3.0, "parameters: {command_lead: 0.5}, inputs: {odom: {max_age: 300ms, on_stale: stop}}");
  const auto moving = std::find_if(n.commands.rbegin(), n.commands.rend(),
                                   [](const auto& command) { return command.second.v > 0.0; });
  ASSERT_NE(moving, n.commands.rend());
  EXPECT_GT(moving->first, 2.0);
  EXPECT_LT(moving->first, 2.4);
  EXPECT_EQ(n.statuses.back().status(), FollowStatus_Constants::FAILED);
  EXPECT_EQ(n.statuses.back().reason(), "a needed input is stale");
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

// The picture in lock-step holds nothing measured: budget as the parameter says, no times.
TEST(LocalPlannerComponent, DiagnosticsTellPlannerAndWork) {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  n.run(2.5, "parameters: {algorithm: teb, max_iterations: 77, max_cycle_time: 0.000001}");
  EXPECT_EQ(n.diagnostic_message, "following");
  EXPECT_EQ(n.diagnostics["planner"], "teb");
  EXPECT_EQ(n.diagnostics["candidates"], "1");
  EXPECT_EQ(n.diagnostics["iteration_budget"], "77");
  EXPECT_GT(std::stoi(n.diagnostics["iterations"]), 0);
  EXPECT_FALSE(n.diagnostics.contains("cycle_p95_ms"));
  EXPECT_FALSE(n.diagnostics.contains("overruns"));
}

// One message a cycle, at 10 Hz: idle until it is told at 1 s, following until 2 s, braking and idle from there on. What
// only a real clock could tell is left open; half of the period is what the parameters leave to a cycle.
TEST(LocalPlannerComponent, TellsOfEveryCycle) {
  Neighbours n;
  n.requests = {{50, FollowRequest_Constants::FOLLOW}, {100, FollowRequest_Constants::STOP}};
  n.run(3.0, "parameters: {algorithm: eteb, max_iterations: 77}");
  EXPECT_NEAR(static_cast<double>(n.cycles.size()), 30.0, 1.0);
  for (const PlannerCycle& cycle : n.cycles) {
    const double t = seconds_since_start(from_stamp(cycle.header().stamp()));
    const bool follows = t > 1.05 && t < 2.0;
    EXPECT_EQ(cycle.header().frame_id(), "odom");
    EXPECT_EQ(cycle.planner(), "eteb");
    EXPECT_EQ(cycle.iteration_budget(), 77U);
    EXPECT_TRUE(std::isnan(cycle.duration_ms()));
    EXPECT_EQ(cycle.budget_ms(), 50.0);
    EXPECT_EQ(cycle.period_ms(), 100.0);
    EXPECT_FALSE(cycle.class_switched());
    if (follows || t < 0.95 || t > 2.05) {
      EXPECT_EQ(cycle.status(), follows ? PlannerCycle_Constants::OK : PlannerCycle_Constants::IDLE) << t;
      EXPECT_EQ(cycle.number_of_candidates(), follows ? 1U : 0U) << t;
      EXPECT_EQ(std::isnan(cycle.chosen_cost()), !follows) << t;
      EXPECT_EQ(cycle.chosen_label().empty(), !follows) << t;
      EXPECT_EQ(cycle.iterations() > 0, follows) << t;
    }
  }
}

// 3 m from rest with 1 m/s and 1 m/s^2 take 4 s, and no less than 3.
TEST(LocalPlannerComponent, PosesOfTheTrajectoryAreStampedWithWhenTheRobotIsThere) {
  Neighbours n;
  n.requests = {{5, FollowRequest_Constants::FOLLOW}};
  n.run(0.35);
  const auto& poses = n.plan.poses();
  ASSERT_GE(poses.size(), 3U);
  const Time start = from_stamp(n.plan.header().stamp());
  EXPECT_EQ(from_stamp(poses.front().header().stamp()), start);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double dt =
        (from_stamp(poses[i].header().stamp()) - from_stamp(poses[i - 1].header().stamp())).to_seconds();
    const double way =
        (from_pose(poses[i].pose()).position() - from_pose(poses[i - 1].pose()).position()).norm();
    ASSERT_GT(dt, 0.0) << i;
    EXPECT_LT(way / dt, 1.1) << i;  // the band's limits are soft
  }
  EXPECT_GT((from_stamp(poses.back().header().stamp()) - start).to_seconds(), 3.0);
}

// On the wall clock the same component has workers and a budget in time. The run ends when its figures came.
TEST(LocalPlannerComponent, OnTheWallClockDiagnosticsTellTimesToo) {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  const auto path = std::filesystem::path(testing::TempDir()) / "local_planner_wall.yaml";
  std::ofstream(path) << "components: {local_planner: {parameters: {algorithm: teb, threads: 3, "
                         "max_cycle_time: 0.000001, max_iterations: 50}}}";
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>([&n](bw::Setup& setup) {
                     n.configure(setup);
                     setup.every(Duration::milliseconds(50), "until_seen",
                                 [&n, finish = setup.finish_run()](const Tick&) {
                                   if (n.diagnostics.contains("overruns") &&
                                       n.diagnostics["iteration_budget"] == "10")
                                     finish(true, "seen");
                                 });
                   })});
  Host host(load_graph(path, {}), {.clock = ClockMode::wall}, std::move(extra));
  const RunEnd end = host.run(Duration::seconds(60));
  EXPECT_EQ(end.reason, "seen");
  EXPECT_GT(std::stod(n.diagnostics["cycle_p95_ms"]), 0.0);
  ASSERT_FALSE(n.cycles.empty());
  EXPECT_GT(n.cycles.back().duration_ms(), 0.0);
  EXPECT_EQ(n.cycles.back().budget_ms(), 0.001);
  // A microsecond has room for no iteration: the floor of the budget.
  EXPECT_EQ(n.diagnostics["iteration_budget"], "10");
}

/// Three seconds along a wall of one disc; parameters are changed at 2.05 s, between the cycles of 2.0 and 2.1 s.
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

// A parameter of another planner has this one made anew. It drives on as if nothing had been: its bands are still there.
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
