// A sweep takes its time: beams of a robot that rotates, and people who walk meanwhile.
#include "components/people/sweep_timing.hpp"

#include <gtest/gtest.h>

#include "components/model/sweep_motion.hpp"
#include "components/people/detector/detector.hpp"
#include "tests/components/model/moving_sweep.hpp"

namespace bw::people {
namespace {

/// The same sweep by a scanner that lists its beams the other way round.
struct Reversed {
  std::vector<float> ranges;
  std::vector<Pose2> poses;
  LaserSweep sweep;

  explicit Reversed(const LaserSweep& of)
      : ranges(of.ranges.rbegin(), of.ranges.rend()),
        poses(of.beam_poses.rbegin(), of.beam_poses.rend()),
        sweep(of) {
    sweep.angle_min = of.angle_min + of.angle_increment * static_cast<double>(ranges.size() - 1);
    sweep.angle_increment = -of.angle_increment;
    sweep.time_increment = -of.time_increment;
    sweep.ranges = ranges;
    sweep.beam_poses = poses;
  }
};

TEST(SweepTiming, AWallIsStraightFromARobotThatTurns) {
  test::MovingSweep moving{.twist = {0.5, 1.9}};
  LaserSweep sweep = moving.scan();
  const std::vector<Pose2> poses =
      beam_poses(sweep, moving.X_BL, [&](Time time) { return moving.X_OB(time); });
  const auto farthest_off = [](const LaserSweep& seen) {
    Beams beams;
    read_beams(seen, beams);
    double farthest = 0.0;
    for (std::size_t i = 0; i < beams.points.size(); ++i) {
      if (beams.kinds[i] == BeamKind::hit) farthest = std::max(farthest, std::abs(beams.points[i].x() - 2.5));
    }
    return farthest;
  };
  // Taken for one instant: the laser is rotated by 0.3 rad, so that the wall's end at -72 degrees, 7.6 m
  // aside, is a quarter of a turn from the middle: 1.9 / 28 = 0.068 rad, and 0.5 / 28 m of travel.
  sweep.X_FL = moving.X_BL;
  EXPECT_NEAR(farthest_off(sweep), 7.6 * 0.068 + 0.018, 0.03);
  sweep.beam_poses = poses;
  EXPECT_LT(farthest_off(sweep), 1e-6);
  EXPECT_LT(farthest_off(Reversed(sweep).sweep), 1e-6);
}

TEST(SweepTiming, DirectionsOfBeamsAreThoseOfTheTurningScanner) {
  test::MovingSweep moving{.twist = {0.0, 1.4}, .X_BL = {}};
  LaserSweep sweep = moving.scan();
  const std::vector<Pose2> poses = beam_poses(sweep, {}, [&](Time time) { return moving.X_OB(time); });
  sweep.beam_poses = poses;
  const Reversed reversed(sweep);
  for (const LaserSweep& seen : {sweep, reversed.sweep}) {
    Beams beams;
    read_beams(seen, beams);
    // Beam 0 looks at -pi, taken last, 1/14 s after the middle: 0.1 rad further round; the last one is a turn
    // of time earlier.
    EXPECT_NEAR(beams.angle_min, -std::numbers::pi + 0.1, 1e-6);
    EXPECT_NEAR(beams.angle_increment * 719.0, 2.0 * std::numbers::pi * 719.0 / 720.0 - 0.2 * 719.0 / 720.0,
                1e-6);
    EXPECT_TRUE(beams.closed);
    EXPECT_NEAR(beams.taken_after(0), 1.0 / 14.0, 1e-9);
    EXPECT_NEAR(beams.taken_after(540), -1.0 / 28.0, 1e-9);
    for (const int i : {300, 360, 420}) {
      const Vector2 straight_on = beams.points[static_cast<std::size_t>(i)].normalized();
      const double angle = beams.angle_min + i * beams.angle_increment;
      EXPECT_LT((straight_on - direction(angle)).norm(), 1e-6) << i;
    }
  }
}

TrackedPerson walker(const Vector2& position, const Vector2& velocity) {
  TrackedPerson person;
  person.position = position;
  person.velocity = velocity;
  person.covariance(2, 2) = person.covariance(3, 3) = 0.04;
  return person;
}

// Seen 40 ms after the sweep's time, at 1.2 m/s to the left: 4.8 cm back. Of its velocity 0.2 m/s is not
// sure, 8 mm.
TEST(SweepTiming, WhoWalksIsMovedToTheTimeOfTheSweep) {
  DetectionSet set{.time = Time::seconds(10.1)};
  set.detections.resize(4);
  for (Detection& detection : set.detections) detection = {.position = {2.0, 0.12}, .after = 0.04};
  set.detections[1].after = -0.04;
  set.detections[2].on_static = true;
  set.detections[3].position = {2.0, 1.0};  // nobody is within half a metre
  const std::vector<TrackedPerson> people = {walker({2.0, 0.0}, {0.0, 1.2}), walker({2.0, -0.6}, {5.0, 0.0})};
  move_to_one_time(set, people, Time::seconds(10.0));
  EXPECT_NEAR(set.detections[0].position.y(), 0.072, 1e-12);
  EXPECT_NEAR(set.detections[1].position.y(), 0.168, 1e-12);
  EXPECT_NEAR(set.detections[0].covariance(0, 0), 0.01 + 0.008 * 0.008, 1e-12);
  EXPECT_EQ(set.detections[2].position.y(), 0.12);
  EXPECT_EQ(set.detections[3].position.y(), 1.0);
}

// Of 720 beams in 1/7 s, the post 90 degrees to the left was seen 1/28 s before the middle, that to the right
// as much after it.
TEST(SweepTiming, TheDetectorSaysWhenEachThingWasSeen) {
  std::vector<float> ranges(720, std::numeric_limits<float>::infinity());
  for (const std::size_t middle : {180U, 540U})
    for (std::size_t i = middle - 5; i <= middle + 5; ++i) ranges[i] = 2.0F;
  const LaserSweep sweep{.time = Time::seconds(1.0),
                         .angle_min = -std::numbers::pi,
                         .angle_increment = 2.0 * std::numbers::pi / 720.0,
                         .range_min = 0.05,
                         .range_max = 8.0,
                         .ranges = ranges,
                         .time_increment = -1.0 / 7.0 / 720.0};
  Detector detector(DetectorOptions{});
  const DetectionSet& set = detector.detect(sweep, {});
  ASSERT_EQ(set.detections.size(), 2U);
  for (const Detection& detection : set.detections)
    EXPECT_NEAR(detection.after, detection.position.y() > 0.0 ? -1.0 / 28.0 : 1.0 / 28.0, 1e-9);
}

}  // namespace
}  // namespace bw::people
