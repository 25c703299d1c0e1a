// What becomes background, and what must not.
#include <gtest/gtest.h>

#include "components/people/detector/detector.hpp"
#include "tests/components/people/detector_scan.hpp"

namespace bw::people {
namespace {

const Disc kLeg{{2.0, 0.5}, 0.07};

/// The detection nearest to a position.
const Detection* at(const DetectionSet& set, const Vector2& p_O) {
  const Detection* best = nullptr;
  for (const Detection& d : set.detections) {
    if ((d.position - p_O).norm() > 0.2 || d.width > 0.5) continue;
    if (best == nullptr || (d.position - p_O).norm() < (best->position - p_O).norm()) best = &d;
  }
  return best;
}

TEST(LocalBackground, WhatStandsForTwoAndAHalfSecondsIsBackground) {
  Scanner scanner(0.02);
  Detector detector(DetectorOptions{});
  double first_static = -1.0;
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.1 * i;
    const DetectionSet& set = detector.detect(scanner.scan(square_room(5.0), {kLeg}, {}, t), {});
    const Detection* leg = at(set, kLeg.center);
    ASSERT_NE(leg, nullptr) << t;
    if (leg->on_static && first_static < 0.0) first_static = t;
  }
  // 2.5 s after the first sweep; with noise over the borders of cells a little later.
  EXPECT_GE(first_static, 2.45);
  EXPECT_LE(first_static, 3.5);
}

TEST(LocalBackground, TrackedPeopleAreNotAbsorbed) {
  Scanner scanner(0.02);
  Detector detector(DetectorOptions{});
  const std::vector<Vector2> people = {kLeg.center + Vector2(0.1, 0.1)};
  for (int i = 0; i <= 200; ++i) {
    const DetectionSet& set =
        detector.detect(scanner.scan(square_room(5.0), {kLeg}, {}, 0.1 * i), {nullptr, std::nullopt, people});
    const Detection* leg = at(set, kLeg.center);
    ASSERT_NE(leg, nullptr) << i;
    EXPECT_FALSE(leg->on_static) << i;
  }
}

TEST(LocalBackground, WhatIsGoneIsForgottenAndWhatIsHiddenIsKept) {
  Scanner scanner;
  Detector detector(DetectorOptions{});
  double t = 0.0;
  const auto sweeps = [&](int count, const std::vector<Disc>& discs) -> const DetectionSet& {
    for (int i = 0; i < count - 1; ++i, t += 0.1) detector.detect(scanner.scan({}, discs, {}, t), {});
    const DetectionSet& set = detector.detect(scanner.scan({}, discs, {}, t), {});
    t += 0.1;
    return set;
  };
  sweeps(60, {kLeg});
  const Disc screen{{1.0, 0.25}, 0.2};  // before the leg
  sweeps(100, {kLeg, screen});
  const DetectionSet& after = sweeps(1, {kLeg});
  ASSERT_NE(at(after, kLeg.center), nullptr);
  EXPECT_TRUE(at(after, kLeg.center)->on_static);
  sweeps(30, {});  // seen through for 3 s: loses 9 of at most 5 s
  const DetectionSet& again = sweeps(1, {kLeg});
  ASSERT_NE(at(again, kLeg.center), nullptr);
  EXPECT_FALSE(at(again, kLeg.center)->on_static);
}

TEST(LocalBackground, LearnsWhileTheRobotDrivesFarBeyondTheGrid) {
  // Walls along a corridor of 60 m: cells of 0.1 m roll over the 25.6 m of the grid more than twice.
  StaticObstacles walls;
  walls.segments = {{{-5.0, 1.5}, {65.0, 1.5}}, {{-5.0, -1.5}, {65.0, -1.5}}};
  Scanner scanner(0.01, 1, 2.0 * std::numbers::pi * 719.0 / 720.0);
  Detector detector(DetectorOptions{});
  int points = 0;
  int background = 0;
  for (int i = 0; i <= 600; ++i) {
    const Pose2 X_OL{0.1 * i, 0.0, 0.0};  // 1 m/s
    const DetectionSet& set = detector.detect(scanner.scan(walls, {}, X_OL, 0.1 * i), {});
    if (i < 50) continue;
    for (const Detection& d : set.detections) {
      // Behind the robot and near: seen for more than 4 s.
      if (d.position.x() > X_OL.x - 0.2 || d.position.x() < X_OL.x - 2.0) continue;
      points += d.points;
      if (d.on_static) background += d.points;
    }
  }
  ASSERT_GT(points, 10'000);
  EXPECT_GT(static_cast<double>(background) / points, 0.99);
}

TEST(LocalBackground, AClockThatGoesBackLearnsNothing) {
  Scanner scanner;
  Detector detector(DetectorOptions{});
  for (int i = 0; i < 100; ++i) detector.detect(scanner.scan({}, {kLeg}, {}, 100.0 - i), {});
  EXPECT_FALSE(at(detector.detect(scanner.scan({}, {kLeg}, {}, 0.0), {}), kLeg.center)->on_static);
}

OccupancyGrid map_with_wall_at(double x) {
  OccupancyGrid map{0.05, {-2.0, -6.0}, 240, 240, std::vector<std::int8_t>(240 * 240, OccupancyGrid::kFree)};
  for (int row = 0; row < map.height; ++row)
    map.cells[map.index(map.column_of(x), row)] = OccupancyGrid::kOccupied;
  return map;
}

TEST(StaticMapOfDetector, WallsOfTheMapAreBackgroundAtOnceEvenWithAPoseThatErrs) {
  Detector detector(DetectorOptions{});
  const OccupancyGrid map = map_with_wall_at(4.0);
  Scanner scanner(0.02);
  StaticObstacles wall;
  wall.segments = {{{4.0, -3.0}, {4.0, 3.0}}};
  const Pose2 X_MO_wrong{0.1, 0.0, std::numbers::pi / 180.0};
  const DetectionSet& set = detector.detect(scanner.scan(wall, {kLeg}, {}, 0.0), {&map, X_MO_wrong, {}});
  int walls = 0;
  for (const Detection& d : set.detections) {
    if (d.position.x() < 3.5) continue;
    EXPECT_TRUE(d.on_static);
    ++walls;
  }
  EXPECT_GE(walls, 1);
  ASSERT_NE(at(set, kLeg.center), nullptr);
  EXPECT_FALSE(at(set, kLeg.center)->on_static);
}

TEST(StaticMapOfDetector, WithoutAPoseOrWithAMapThatIsNoneNothingIsWall) {
  Scanner scanner;
  StaticObstacles wall;
  wall.segments = {{{4.0, -3.0}, {4.0, 3.0}}};
  const auto any_static = [&](const OccupancyGrid& map, std::optional<Pose2> X_MO) {
    Detector detector(DetectorOptions{});
    const DetectionSet& set = detector.detect(scanner.scan(wall, {}, {}, 0.0), {&map, X_MO, {}});
    EXPECT_FALSE(set.detections.empty());
    return std::any_of(set.detections.begin(), set.detections.end(),
                       [](const Detection& d) { return d.on_static; });
  };
  EXPECT_TRUE(any_static(map_with_wall_at(4.0), Pose2{}));
  EXPECT_FALSE(any_static(map_with_wall_at(4.0), std::nullopt));
  OccupancyGrid broken = map_with_wall_at(4.0);
  broken.cells.pop_back();
  EXPECT_FALSE(any_static(broken, Pose2{}));
}

}  // namespace
}  // namespace bw::people
