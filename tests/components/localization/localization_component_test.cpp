// The localization on its topics, in lock-step: a robot on an arc, its sensors by closed form, odometry that
// started elsewhere.
#include <cmath>
#include <limits>
#include <vector>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/local_plane.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using geometry_msgs::msg::PoseWithCovarianceStamped;

constexpr Twist2 kTwist{0.8, 0.3};
const Pose2 kStart{3.0, 1.0, 0.7};
const localization::Geodetic kDatum{21.0, 105.8, 0.0};
const std::string kGraph =
    "components: {localization: {parameters: {datum: {enabled: true, latitude: 21.0, longitude: 105.8}";

Pose2 truth(double t) { return kStart * advance_exact({}, kTwist, t); }

struct Seen {
  std::vector<nav_msgs::msg::Odometry> filtered;
  std::vector<PoseWithCovarianceStamped> poses;
  std::vector<Pose2> X_MO;    ///< from /tf
  std::string diagnostics;    ///< the last message of the component
  bool hears_course = false;  ///< among its sources
};

struct Drive {
  double seconds = 8.0;
  bool compass = true;
  bool receiver = true;
  double fix_error = 0.0;      ///< eastward, of every fix after `spoilt_from` [m]
  double spoilt_from = 1e9;    ///< [s]
  double nan_from = 1e9;       ///< IMU and fixes hold NaN from here on [s]
  std::optional<Pose2> click;  ///< sent on initialpose at 2 s
  std::string click_frame = "map";
  double click_quaternion = 1.0;  ///< its length
};

class Sensors {
 public:
  Sensors(Setup& setup, const Drive& drive)
      : drive_(drive),
        odom_(setup.output<nav_msgs::msg::Odometry>("odom")),
        imu_(setup.output<sensor_msgs::msg::Imu>("imu")),
        fix_(setup.output<sensor_msgs::msg::NavSatFix>("gps/fix")),
        click_(setup.output<PoseWithCovarianceStamped>("initialpose")) {}

  void tick(const Tick& tick) {
    const double t = seconds_since_start(tick.now);
    const bool spoilt = t >= drive_.nan_from;
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    if (drive_.compass) {
      sensor_msgs::msg::Imu imu;
      imu.header(make_header("base_link", tick.now));
      imu.orientation(to_quaternion(spoilt ? kNan : truth(t).theta));
      imu.angular_velocity().z(spoilt ? kNan : kTwist.omega);
      imu_.publish(imu);
    }
    nav_msgs::msg::Odometry odometry;
    odometry.header(make_header("odom", tick.now));
    odometry.pose().pose(to_pose(advance_exact({}, kTwist, t)));
    odom_.publish(odometry);
    if (drive_.receiver && tick.sequence % 10 == 0) fix_.publish(fix(t, tick.now, spoilt ? kNan : 0.0));
    if (drive_.click && !clicked_ && t >= 2.0) {
      clicked_ = true;
      PoseWithCovarianceStamped message;
      message.header(make_header(drive_.click_frame, tick.now));
      message.pose().pose(to_pose(*drive_.click));
      auto& q = message.pose().pose().orientation();
      q.z(q.z() * drive_.click_quaternion);
      q.w(q.w() * drive_.click_quaternion);
      click_.publish(message);  // no covariance, as some tools send it
    }
  }

 private:
  sensor_msgs::msg::NavSatFix fix(double t, Time now, double spoil) const {
    Vector2 position = truth(t).position();
    if (t >= drive_.spoilt_from) position.x() += drive_.fix_error;
    const auto plane = localization::LocalPlane::around(kDatum);
    const auto on_earth = plane->to_geodetic({position.x(), position.y(), 0.0});
    sensor_msgs::msg::NavSatFix message;
    message.header(make_header("base_link", now));
    message.latitude(on_earth.latitude + spoil);
    message.longitude(on_earth.longitude);
    message.position_covariance()[0] = message.position_covariance()[4] = 0.01;
    message.position_covariance_type(2);
    return message;
  }

  Drive drive_;
  bool clicked_ = false;
  Output<nav_msgs::msg::Odometry> odom_;
  Output<sensor_msgs::msg::Imu> imu_;
  Output<sensor_msgs::msg::NavSatFix> fix_;
  Output<PoseWithCovarianceStamped> click_;
};

Seen run(const Drive& drive, const std::string& parameters = "") {
  Seen seen;
  run_with_script(kGraph + parameters + "}}}", drive.seconds, [&](bw::Setup& setup) {
    setup.input<nav_msgs::msg::Odometry>("odometry/filtered", Qos::standard(50),
                                         [&](const auto& m, const Tick&) { seen.filtered.push_back(m); });
    setup.input<PoseWithCovarianceStamped>("amcl_pose", Qos::latched(),
                                           [&](const auto& m, const Tick&) { seen.poses.push_back(m); });
    setup.input<tf2_msgs::msg::TFMessage>("/tf", Qos::tf(), [&](const auto& m, const Tick&) {
      const auto& transform = m.transforms().at(0);
      EXPECT_EQ(transform.header().frame_id(), "map");
      EXPECT_EQ(transform.child_frame_id(), "odom");
      const auto& p = transform.transform().translation();
      seen.X_MO.push_back({p.x(), p.y(), yaw_of(transform.transform().rotation())});
    });
    setup.input<diagnostic_msgs::msg::DiagnosticArray>(
        "/diagnostics", Qos::standard(),
        [&](const auto& m, const Tick&) {
          for (const auto& status : m.status()) {
            if (status.name().find("localization") == std::string::npos) continue;
            seen.diagnostics = status.message();
            for (const auto& value : status.values()) seen.hears_course |= value.key() == "course";
          }
        },
        Need::optional);
    auto sensors = std::make_shared<Sensors>(setup, drive);
    setup.every(Duration::milliseconds(20), "sensors", [sensors](const Tick& tick) { sensors->tick(tick); });
  });
  return seen;
}

double error_at_end(const Seen& seen) {
  const auto& last = seen.filtered.back();
  const double t = seconds_since_start(from_stamp(last.header().stamp()));
  return (from_pose(last.pose().pose()).position() - truth(t).position()).norm();
}

// Exact sensors: the estimate is the truth but for the arc between two odometry poses, which their chord
// gives exactly.
TEST(LocalizationComponent, FindsThePoseAndPublishesItOnEveryTopic) {
  const Seen seen = run({});
  ASSERT_FALSE(seen.filtered.empty());
  EXPECT_EQ(seen.filtered.back().header().frame_id(), "map");
  EXPECT_EQ(seen.filtered.back().child_frame_id(), "base_link");
  EXPECT_LT(error_at_end(seen), 1e-3);
  EXPECT_NEAR(seen.filtered.back().twist().twist().linear().x(), kTwist.v, 1e-6);
  EXPECT_NEAR(seen.filtered.back().twist().twist().angular().z(), kTwist.omega, 1e-4);
  EXPECT_GT(seen.filtered.back().pose().covariance()[0], 0.0);
  // The odometry started at the origin: odom lies in map where the robot began.
  EXPECT_NEAR(seen.X_MO.back().x, kStart.x, 1e-3);
  EXPECT_NEAR(seen.X_MO.back().y, kStart.y, 1e-3);
  EXPECT_NEAR(seen.X_MO.back().theta, kStart.theta, 1e-3);
  EXPECT_EQ(seen.X_MO.size(), seen.filtered.size());
  EXPECT_EQ(seen.poses.back().header().frame_id(), "map");
  EXPECT_EQ(seen.diagnostics, "OK");
}

TEST(LocalizationComponent, SaysNothingOfThePoseBeforeItKnowsOne) {
  const Seen seen = run({.compass = false, .receiver = false});
  EXPECT_TRUE(seen.filtered.empty());
  EXPECT_TRUE(seen.X_MO.empty());
  EXPECT_TRUE(seen.poses.empty());
  EXPECT_EQ(seen.diagnostics.substr(0, 4), "INIT");
}

TEST(LocalizationComponent, TakesThePoseOfTheGraphAndDrivesOnByWheels) {
  const Seen seen = run({.compass = false, .receiver = false},
                        ", set_initial_pose: true, initial_pose: {x: 3.0, y: 1.0, yaw: 0.7}");
  ASSERT_FALSE(seen.filtered.empty());
  EXPECT_LT(error_at_end(seen), 0.02);  // the first odometry comes 20 ms after the start
}

// A click moves the estimate there; wheels alone keep what it was off by, rotated with the heading.
TEST(LocalizationComponent, TakesAPoseClickedInRviz) {
  Drive drive{.compass = false, .receiver = false};
  drive.click = Pose2{10.0, 20.0, -1.0};
  const Seen seen = run(drive);
  ASSERT_FALSE(seen.filtered.empty());
  const auto& last = seen.filtered.back();
  const double t = seconds_since_start(from_stamp(last.header().stamp()));
  const Pose2 expected = *drive.click * advance_exact({}, kTwist, t - 2.0);
  EXPECT_NEAR(last.pose().pose().position().x(), expected.x, 0.03);
  EXPECT_NEAR(last.pose().pose().position().y(), expected.y, 0.03);

  drive.click_quaternion = 2.0;  // the same direction
  EXPECT_EQ(run(drive).filtered.back().pose().pose(), last.pose().pose());
  drive.click_quaternion = 0.0;  // none
  EXPECT_TRUE(run(drive).filtered.empty());
  drive.click_quaternion = 1.0;
  drive.click_frame = "odom";
  EXPECT_TRUE(run(drive).filtered.empty());
}

TEST(LocalizationComponent, SurvivesSensorsThatTurnToNan) {
  const Seen seen = run({.nan_from = 4.0});
  EXPECT_LT(error_at_end(seen), 0.01);  // 4 s by wheels alone, which are exact here
  EXPECT_EQ(seen.diagnostics.substr(0, 8), "DEGRADED") << seen.diagnostics;
}

// All fixes jump by 5 m, twenty times what the gate lets pass: after 3 s of contradiction LOST, and no pose
// any more; after 10 s of agreement among themselves the fixes take over.
TEST(LocalizationComponent, StopsThePoseWhenLostAndReturnsAfterReacquisition) {
  const Seen seen = run({.seconds = 24.0, .fix_error = 5.0, .spoilt_from = 5.0});
  std::vector<double> stamps;
  for (const auto& m : seen.filtered) stamps.push_back(seconds_since_start(from_stamp(m.header().stamp())));
  double gap_begins = 0.0;
  double gap_ends = 0.0;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    if (stamps[i] - stamps[i - 1] > gap_ends - gap_begins) {
      gap_begins = stamps[i - 1];
      gap_ends = stamps[i];
    }
  }
  EXPECT_NEAR(gap_begins, 8.0, 0.5);
  EXPECT_NEAR(gap_ends, 15.0, 0.7);
  EXPECT_NEAR(seen.filtered.back().pose().pose().position().x() - truth(stamps.back()).x, 5.0, 0.1);

  // Nor on amcl_pose, which comes ten times a second from 0.5 s on. 50 ms: the state is looked at between two
  // poses.
  for (const auto& m : seen.poses) {
    const double stamp = seconds_since_start(from_stamp(m.header().stamp()));
    EXPECT_TRUE(stamp < gap_begins + 0.05 || stamp > gap_ends - 0.05) << stamp;
  }
  EXPECT_NEAR(static_cast<double>(seen.poses.size()), 10.0 * (23.5 - (gap_ends - gap_begins)), 3.0);

  const Seen stubborn =
      run({.seconds = 12.0, .fix_error = 5.0, .spoilt_from = 5.0}, ", publish_when_lost: true");
  EXPECT_NEAR(static_cast<double>(stubborn.filtered.size()), 50.0 * 12.0, 50.0);
  EXPECT_NEAR(static_cast<double>(stubborn.poses.size()), 10.0 * 12.0, 10.0);
}

TEST(LocalizationComponent, TakesTheCourseBetweenFixesWhenAsked) {
  const Seen seen = run({.compass = false}, ", sensors: {course: true}");
  EXPECT_TRUE(seen.hears_course);
  EXPECT_LT(error_at_end(seen), 0.05);
  EXPECT_FALSE(run({.compass = false}).hears_course);
}

TEST(LocalizationComponent, RefusesParametersThatContradictEachOther) {
  EXPECT_THROW(run({}, ", start_anywhere: true"), ConfigError);
  EXPECT_THROW(run({}, ", algorithm: ukf"), ConfigError);
}

}  // namespace
}  // namespace bw
