#include "components/recordings/recorded_drive.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/recordings/hold_out.hpp"
#include "components/recordings/synthetic_sensors.hpp"

namespace bw {
namespace {

constexpr localization::Geodetic kDatum{21.0, 105.8, 0.0};

/// 100 s along x with 1 m/s, reference at 10 Hz, odometry at 1 Hz from 10 s on.
RecordedDrive straight() {
  RecordedDrive drive;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 10.0;
    drive.truth.push_back({Time::seconds(t), {t, 0.0}, 0.0});
  }
  for (int t = 10; t <= 200; ++t) drive.odometry.push_back({Time::seconds(t), {}, {1.0, 0.0}});
  return drive;
}

TEST(ReferenceAt, InterpolatesAlongTheShorterTurnAndNotAcrossGaps) {
  RecordedDrive drive;
  drive.truth = {{Time::seconds(1), {0.0, 0.0}, 3.0}, {Time::seconds(2), {4.0, 0.0}, -3.0}};
  const auto middle = reference_at(drive, Time::seconds(1.5), Duration::seconds(1));
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->position.x(), 2.0, 1e-12);
  EXPECT_NEAR(std::abs(*middle->heading), std::numbers::pi, 1e-12);
  EXPECT_FALSE(reference_at(drive, Time::seconds(1.5), Duration::seconds(0.9)));
  EXPECT_FALSE(reference_at(drive, Time::seconds(0.9), Duration::seconds(1)));
  EXPECT_FALSE(reference_at(drive, Time::seconds(2.1), Duration::seconds(1)));
  EXPECT_EQ(reference_at(drive, Time::seconds(2), Duration::seconds(0.1))->position.x(), 4.0);
}

// 90 s with both: 90 fixes, 900 headings, and what they err by.
TEST(SyntheticSensors, HaveTheirRatesAndNoise) {
  RecordedDrive drive = straight();
  add_synthetic_sensors(drive, {}, kDatum, 3);
  ASSERT_EQ(drive.fixes.size(), 90U);
  ASSERT_EQ(drive.imu.size(), 900U);
  EXPECT_EQ(drive.fixes.front().time, Time::seconds(11));
  const auto plane = localization::LocalPlane::around(kDatum);
  double squares = 0.0;
  for (const FixSample& fix : drive.fixes) {
    const Eigen::Vector3d p = plane->to_plane(fix.position);
    squares += std::pow(p.x() - fix.time.to_seconds(), 2) + std::pow(p.y(), 2);
    EXPECT_DOUBLE_EQ(fix.variance.x(), 0.04);
  }
  // Mean square of 180 draws: 0.04 with relative standard deviation sqrt(2 / 180) = 0.105; 3 of them.
  EXPECT_NEAR(squares / 180.0, 0.04, 0.04 * 0.32);
  squares = 0.0;
  for (const ImuSample& imu : drive.imu) squares += std::pow(*imu.heading, 2);
  EXPECT_NEAR(squares / 900.0, std::pow(0.01745, 2), std::pow(0.01745, 2) * 0.15);
}

TEST(SyntheticSensors, NoiseOfOneDoesNotDependOnTheOther) {
  RecordedDrive both = straight();
  RecordedDrive alone = straight();
  add_synthetic_sensors(both, {}, kDatum, 3);
  add_synthetic_sensors(alone, {.compass_rate = 0.0}, kDatum, 3);
  EXPECT_TRUE(alone.imu.empty());
  ASSERT_EQ(both.fixes.size(), alone.fixes.size());
  EXPECT_EQ(both.fixes.back().position.latitude, alone.fixes.back().position.latitude);
}

std::vector<double> seconds_of(const std::vector<FixSample>& fixes) {
  std::vector<double> seconds;
  for (const FixSample& fix : fixes) seconds.push_back(fix.time.to_seconds());
  return seconds;
}

TEST(HoldOut, FollowsItsRule) {
  RecordedDrive all;
  for (int t = 0; t < 6; ++t) all.fixes.push_back({Time::seconds(t), kDatum});
  using Seconds = std::vector<double>;
  RecordedDrive drive = all;
  EXPECT_TRUE(hold_out(drive, {}).empty());
  EXPECT_EQ(drive.fixes.size(), 6U);
  drive = all;
  EXPECT_EQ(seconds_of(hold_out(drive, {.rule = HoldOutRule::every_second})), (Seconds{1, 3, 5}));
  EXPECT_EQ(seconds_of(drive.fixes), (Seconds{0, 2, 4}));
  drive = all;
  hold_out(drive, {.rule = HoldOutRule::sparse, .period = 2.5});
  EXPECT_EQ(seconds_of(drive.fixes), (Seconds{0, 3}));
  drive = all;
  EXPECT_EQ(seconds_of(hold_out(drive, {.rule = HoldOutRule::outage, .from = 2, .to = 3})), (Seconds{2, 3}));
}

TEST(InTimeOrder, SortsByStampThenByKind) {
  RecordedDrive drive;
  drive.odometry = {{Time::seconds(2), {}, {}}};
  drive.imu = {{Time::seconds(1), 0.0, {}}, {Time::seconds(2), 0.0, {}}};
  drive.truth = {{Time::seconds(1), {0.0, 0.0}, {}}};
  const std::vector<RecordedEvent> events = in_time_order(drive);
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(std::get<const ImuSample*>(events[0]), &drive.imu[0]);
  EXPECT_EQ(std::get<const ReferencePose*>(events[1]), &drive.truth[0]);
  EXPECT_EQ(std::get<const OdometrySample*>(events[2]), &drive.odometry[0]);
  EXPECT_EQ(std::get<const ImuSample*>(events[3]), &drive.imu[1]);
}

}  // namespace
}  // namespace bw
