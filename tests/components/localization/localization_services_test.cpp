// AMCL's services of the localization, in lock-step: a robot that stands in a room of 12 x 8 m.
#include <algorithm>
#include <limits>

#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <gtest/gtest.h>
#include <nav2_msgs/msg/particle_cloud.hpp>
#include <nav2_msgs/srv/set_initial_pose.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_srvs/srv/empty.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/mapping/rasterize.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/world/ray.hpp"
#include "tests/components/service_calls.hpp"

namespace bw {
namespace {

using geometry_msgs::msg::PoseWithCovarianceStamped;
using nav2_msgs::srv::SetInitialPose;
using std_srvs::srv::Empty;

const std::string kNothingElse =
    "sensors: {gyro: false, compass: false, gps: false, poses: false, ranges: false}";
const std::string kEkf = "components: {localization: {parameters: {algorithm: ekf, " + kNothingElse + "}}}";
const std::string kParticles = "components: {localization: {parameters: {algorithm: particle_filter, " +
                               kNothingElse +
                               ", set_initial_pose: true, initial_pose: {x: 3.0, y: 2.0, yaw: 0.5}}}}";
const Pose2 kX_MB{3.0, 2.0, 0.5};

std::vector<Segment> room() {
  return {{{0.0, 0.0}, {12.0, 0.0}},
          {{12.0, 0.0}, {12.0, 8.0}},
          {{12.0, 8.0}, {0.0, 8.0}},
          {{0.0, 8.0}, {0.0, 0.0}},
          {{7.0, 3.0}, {7.0, 5.5}}};
}

nav_msgs::msg::OccupancyGrid map(Time now, double resolution = 0.05, const Vector2& origin = {-0.5, -0.5}) {
  OccupancyGrid grid{.resolution = resolution, .origin = origin, .width = 260, .height = 180};
  grid.cells.assign(std::size_t{260} * 180, OccupancyGrid::kFree);
  for (const Segment& wall : room()) draw_segment(grid, wall);
  return to_message(grid, "map", now);
}

sensor_msgs::msg::LaserScan sweep(Time now) {
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("base_link", now));
  scan.angle_min(-3.0F);
  scan.angle_increment(6.0F / 359.0F);
  scan.angle_max(3.0F);
  scan.range_min(0.05F);
  scan.range_max(30.0F);
  for (int i = 0; i < 360; ++i) {
    double range = kNoHit;
    for (const Segment& wall : room())
      range =
          std::min(range, ray_hit(kX_MB.position(), direction(kX_MB.theta - 3.0 + 6.0 / 359.0 * i), wall));
    scan.ranges().push_back(static_cast<float>(range));
  }
  return scan;
}

struct Answers {
  std::vector<nav_msgs::msg::Odometry> filtered;
  std::vector<PoseWithCovarianceStamped> poses;
  std::vector<std::pair<double, nav2_msgs::msg::ParticleCloud>> clouds;  ///< [s] since the start
};

/// `later`: published on map at 2 s, 2.1 s and so on.
Answers run(const std::string& graph, const std::function<void(Setup&)>& ask,
            const std::vector<nav_msgs::msg::OccupancyGrid>& later = {}) {
  Answers seen;
  run_with_script(graph, 4.0, [&](bw::Setup& setup) {
    setup.input<nav_msgs::msg::Odometry>("odometry/filtered", Qos::standard(50),
                                         [&](const auto& m, const Tick&) { seen.filtered.push_back(m); });
    setup.input<PoseWithCovarianceStamped>("amcl_pose", Qos::latched(),
                                           [&](const auto& m, const Tick&) { seen.poses.push_back(m); });
    setup.input<nav2_msgs::msg::ParticleCloud>(
        "particle_cloud", Qos::standard(),
        [&](const auto& m, const Tick& tick) { seen.clouds.emplace_back(seconds_since_start(tick.now), m); });
    setup.every(
        Duration::milliseconds(100), "robot",
        [&later, odom = setup.output<nav_msgs::msg::Odometry>("odom"),
         scan = setup.output<sensor_msgs::msg::LaserScan>("scan", Qos::sensor()),
         map_out = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched()),
         tf_static = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched())](const Tick& tick) {
          if (tick.sequence == 0) map_out.publish(map(tick.now));
          if (tick.sequence >= 20 && tick.sequence < 20 + later.size())
            map_out.publish(later[tick.sequence - 20]);
          nav_msgs::msg::Odometry message;
          message.header(make_header("odom", tick.now));
          message.pose().pose(to_pose({}));
          odom.publish(message);
          scan.publish(sweep(tick.now));
        });
    ask(setup);
  });
  return seen;
}

SetInitialPose::Request pose_at(const Pose2& X, const std::string& frame = "map") {
  SetInitialPose::Request request;
  request.pose().header().frame_id(frame);
  request.pose().pose().pose(to_pose(X));
  return request;
}

TEST(LocalizationServices, SetInitialPoseIsThePose) {
  std::vector<SetInitialPose::Response> responses;
  const Answers seen = run(kEkf, [&](bw::Setup& setup) {
    call_at<SetInitialPose>(setup, "set_initial_pose", {{1.0, pose_at({10.0, -4.0, 1.0})}}, responses);
  });
  EXPECT_EQ(responses.size(), 1U);
  ASSERT_FALSE(seen.filtered.empty());
  EXPECT_NEAR(seconds_since_start(from_stamp(seen.filtered.front().header().stamp())), 1.05, 0.06);
  const Pose2 last = from_pose(seen.filtered.back().pose().pose());
  EXPECT_NEAR(last.x, 10.0, 1e-6);
  EXPECT_NEAR(last.y, -4.0, 1e-6);
  EXPECT_NEAR(last.theta, 1.0, 1e-6);
}

TEST(LocalizationServices, SetInitialPoseRefusesWhatIsNoPose) {
  std::vector<SetInitialPose::Response> responses;
  SetInitialPose::Request zero = pose_at({1.0, 2.0, 0.0});
  zero.pose().pose().pose().orientation({});
  zero.pose().pose().pose().orientation().w(0.0);
  SetInitialPose::Request indefinite = pose_at({1.0, 2.0, 0.0});
  indefinite.pose().pose().covariance()[0] = -1.0;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Answers seen = run(kEkf, [&](bw::Setup& setup) {
    call_at<SetInitialPose>(setup, "set_initial_pose",
                            {{1.0, pose_at({kNan, 2.0, 0.0})},
                             {1.1, zero},
                             {1.2, pose_at({1.0, 2.0, 0.0}, "odom")},
                             {1.3, pose_at({1.0, 2.0, 0.0}, "")},
                             {1.4, indefinite}},
                            responses);
  });
  EXPECT_EQ(responses.size(), 5U);
  EXPECT_TRUE(seen.filtered.empty());
}

/// Variance of the particles along x [m^2].
double spread(const nav2_msgs::msg::ParticleCloud& cloud) {
  double sum = 0.0;
  double squares = 0.0;
  for (const auto& particle : cloud.particles()) {
    sum += particle.pose().position().x();
    squares += particle.pose().position().x() * particle.pose().position().x();
  }
  const auto n = static_cast<double>(cloud.particles().size());
  return squares / n - sum / n * sum / n;
}

// 12 m of free floor: the variance of a uniform distribution is 12^2 / 12 = 12 m^2. The next sweep, 50 ms
// later, finds places.
TEST(LocalizationServices, ReinitializeSearchesTheWholeMap) {
  std::vector<Empty::Response> responses;
  const Answers seen = run(kParticles, [&](bw::Setup& setup) {
    call_at<Empty>(setup, "reinitialize_global_localization", {{1.99}}, responses);
  });
  EXPECT_EQ(responses.size(), 1U);
  double before = 0.0;
  double most = 0.0;
  for (const auto& [t, cloud] : seen.clouds)
    (t < 1.99 ? before : most) = std::max(t < 1.99 ? before : most, spread(cloud));
  EXPECT_LT(before, 1.0);
  EXPECT_GT(most, 5.0);

  // A filter that cannot search says so and goes on.
  std::vector<SetInitialPose::Response> set;
  const Answers ekf = run(kEkf, [&](bw::Setup& setup) {
    call_at<SetInitialPose>(setup, "set_initial_pose", {{0.5, pose_at(kX_MB)}}, set);
    call_at<Empty>(setup, "reinitialize_global_localization", {{1.0}}, responses);
  });
  EXPECT_EQ(responses.size(), 2U);
  ASSERT_FALSE(ekf.filtered.empty());
  EXPECT_NEAR(from_pose(ekf.filtered.back().pose().pose()).x, kX_MB.x, 1e-6);
}

// While the robot stands no sweep counts after the first (update_min_d), so that the estimate stays as it is;
// one that is asked for makes it surer.
TEST(LocalizationServices, NomotionUpdateUsesASweepThoughTheRobotStands) {
  std::vector<Empty::Response> responses;
  const Answers seen = run(kParticles, [&](bw::Setup& setup) {
    call_at<Empty>(setup, "request_nomotion_update", {{2.0}}, responses);
  });
  EXPECT_EQ(responses.size(), 1U);
  const auto variance_at = [&](double t) {
    for (const auto& pose : seen.poses) {
      if (seconds_since_start(from_stamp(pose.header().stamp())) > t) return pose.pose().covariance()[0];
    }
    ADD_FAILURE() << "no pose after " << t;
    return 0.0;
  };
  EXPECT_NEAR(variance_at(1.0), variance_at(1.9), 1e-4);  // it grows a little with time
  EXPECT_LT(variance_at(2.5), 0.7 * variance_at(1.9));
  EXPECT_NEAR(variance_at(2.5), variance_at(3.7), 1e-4);
}

// The same room in coarser cells, from another origin on: the particles stay where they are and match it.
// Messages that are no maps change nothing, and in one of elsewhere the robot is nowhere, which is no reason
// to fall.
TEST(LocalizationServices, AnotherMapIsTakenAsItComes) {
  const Time now = LockstepRunner::kStart;
  const auto error = [](const Answers& seen) {
    return (from_pose(seen.filtered.back().pose().pose()).position() - kX_MB.position()).norm();
  };
  const auto ask = [](bw::Setup&) {};
  auto no_cells = map(now);
  no_cells.data().clear();
  auto nan = map(now);
  nan.info().resolution(std::numeric_limits<float>::quiet_NaN());
  auto tiny = map(now);
  tiny.info().resolution(1e-5F);  // the fields of a filter reach a metre beyond the map
  const Answers seen = run(kParticles, ask, {map(now, 0.1, {-5.0, -4.0}), no_cells, nan, tiny});
  ASSERT_FALSE(seen.filtered.empty());
  EXPECT_NEAR(seconds_since_start(from_stamp(seen.filtered.back().header().stamp())), 4.0, 0.11);
  EXPECT_LT(error(seen), 0.1);

  const Answers lost = run(kParticles, ask, {map(now, 0.05, {500.0, 500.0})});
  EXPECT_FALSE(lost.clouds.empty());
}

}  // namespace
}  // namespace bw
