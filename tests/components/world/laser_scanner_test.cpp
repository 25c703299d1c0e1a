// Whole scans against an independent search over every shape for every beam, and the statistics of their
// noise.
#include "components/world/laser_scanner.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/world/legs.hpp"
#include "components/world/ray.hpp"

namespace bw {
namespace {

constexpr double kPi = std::numbers::pi;

LaserOptions quiet() {
  LaserOptions options;
  options.range_noise = 0.0;
  return options;
}

TEST(LaserScanner, ScansARoomExactly) {
  // Square room of half width 5: the range at angle a is 5 / max(|cos a|, |sin a|).
  const StaticScene room(
      {{}, {}, {{{-5, -5}, {5, -5}}, {{5, -5}, {5, 5}}, {{5, 5}, {-5, 5}}, {{-5, 5}, {-5, -5}}}},
      std::nullopt);
  LaserScanner laser(quiet(), Random(1));
  const Pose2 pose{0.0, 0.0, 2.5};
  const LaserScan scan = laser.scan(room, {}, pose);
  ASSERT_EQ(scan.ranges.size(), 720u);
  EXPECT_NEAR(scan.angle_min, -0.75 * kPi, 1e-12);
  EXPECT_NEAR(scan.angle_min + 719 * scan.angle_increment, 0.75 * kPi, 1e-12);
  for (int i = 0; i < 720; ++i) {
    const double angle = pose.theta + scan.angle_min + i * scan.angle_increment;
    const double expected = 5.0 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
    EXPECT_NEAR(scan.ranges[static_cast<std::size_t>(i)], expected, 1e-6) << i;  // float
  }
}

TEST(LaserScanner, AgreesWithBruteForceInClutter) {
  Random random(42);
  for (int trial = 0; trial < 100; ++trial) {
    StaticObstacles shapes;
    std::vector<Disc> movers;
    movers.reserve(10);
    const auto position = [&] { return Vector2(random.uniform(-12, 12), random.uniform(-12, 12)); };
    for (int i = 0; i < 25; ++i) shapes.segments.push_back({position(), position()});
    for (int i = 0; i < 10; ++i) shapes.discs.push_back({position(), random.uniform(0.05, 1.0)});
    for (int i = 0; i < 10; ++i) movers.push_back({position(), 0.07});
    OccupancyGrid grid{0.1, {-10.0, -10.0}, 200, 200, std::vector<std::int8_t>(40000, 0)};
    for (int i = 0; i < 100; ++i) grid.cells[random.bits() % 40000] = OccupancyGrid::kOccupied;
    const StaticScene scene(shapes, grid);
    LaserOptions options = quiet();
    options.field_of_view = random.uniform(0.1, 2.0 * kPi);
    options.range_max = random.uniform(2.0, 20.0);
    options.range_min = 0.0;
    LaserScanner laser(options, Random(1));
    const Pose2 eye_pose{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-kPi, kPi)};
    const LaserScan scan = laser.scan(scene, movers, eye_pose);

    const Vector2 eye = eye_pose.position();
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double angle = eye_pose.theta + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      double expected = scene.grid()->ray_hit(eye, direction(angle), options.range_max);
      for (const Segment& s : shapes.segments)
        expected = std::min(expected, ray_hit(eye, direction(angle), s));
      for (const Disc& d : shapes.discs) expected = std::min(expected, ray_hit(eye, direction(angle), d));
      for (const Disc& d : movers) expected = std::min(expected, ray_hit(eye, direction(angle), d));
      if (expected >= options.range_max) {
        EXPECT_EQ(scan.ranges[i], std::numeric_limits<float>::infinity())
            << "trial " << trial << " beam " << i;
      } else {
        EXPECT_NEAR(scan.ranges[i], expected, 2e-6) << "trial " << trial << " beam " << i;
      }
    }
  }
}

TEST(LaserScanner, SaysTooNearAndNothingByRep117) {
  LaserOptions options = quiet();
  options.range_min = 0.1;
  LaserScanner laser(options, Random(1));
  const StaticScene wall({{}, {}, {{{0.05, -9.0}, {0.05, 9.0}}}}, std::nullopt);
  const LaserScan scan = laser.scan(wall, {}, {});
  EXPECT_EQ(scan.ranges[360], -std::numeric_limits<float>::infinity());  // 0.05 m ahead
  EXPECT_EQ(scan.ranges[0], std::numeric_limits<float>::infinity());     // 135 deg to the right: behind
}

TEST(LaserScanner, NoiseIsNormalWithItsSigma) {
  LaserOptions options;
  options.range_noise = 0.03;
  options.field_of_view = 0.02;
  options.range_max = 50.0;
  LaserScanner laser(options, Random(7));
  const StaticScene disc_around({{}, {}, {{{10.0, -1.0}, {10.0, 1.0}}}}, std::nullopt);
  double sum = 0.0;
  double squares = 0.0;
  int beyond_two_sigma = 0;
  int n = 0;
  for (int k = 0; k < 100; ++k) {
    const LaserScan scan = laser.scan(disc_around, {}, {});
    for (std::size_t i = 0; i < scan.ranges.size(); ++i, ++n) {
      const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      const double error = scan.ranges[i] - 10.0 / std::cos(angle);
      sum += error;
      squares += error * error;
      beyond_two_sigma += std::abs(error) > 0.06 ? 1 : 0;
    }
  }
  // 72,000 draws; bounds of five standard errors: sigma / sqrt(n), sigma / sqrt(2 n), sqrt(p (1 - p) / n).
  EXPECT_NEAR(sum / n, 0.0, 5.0 * 0.03 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.03, 5.0 * 0.03 / std::sqrt(2.0 * n));
  const double p = std::erfc(2.0 / std::sqrt(2.0));
  EXPECT_NEAR(static_cast<double>(beyond_two_sigma) / n, p, 5.0 * std::sqrt(p * (1.0 - p) / n));
}

TEST(Legs, SwingAgainstEachOtherAndStandStill) {
  LegOptions options;  // separation 0.24, stride 1.4, swing 0.18 at 1.3 m/s
  Legs legs(options);
  // A quarter of a stride at 1.3 m/s along +y: the left leg is a full swing ahead, the right one behind.
  const double quarter = 0.35 / 1.3;
  const std::vector<Person> walking = {{5, {2.0, 3.0}, {0.0, 1.3}, 0.3}};
  legs.step(quarter, walking);
  const auto discs = legs.discs(walking);
  ASSERT_EQ(discs.size(), 2u);
  EXPECT_NEAR(discs[0].center.x(), 2.0 - 0.12, 1e-12);
  EXPECT_NEAR(discs[0].center.y(), 3.0 + 0.18, 1e-12);
  EXPECT_NEAR(discs[1].center.x(), 2.0 + 0.12, 1e-12);
  EXPECT_NEAR(discs[1].center.y(), 3.0 - 0.18, 1e-12);
  EXPECT_EQ(discs[0].radius, 0.07);
  // Who stops keeps facing +y with both legs beside each other.
  const std::vector<Person> standing = {{5, {2.0, 3.0}, {0.0, 0.0}, 0.3}};
  legs.step(1.0, standing);
  EXPECT_NEAR(legs.discs(standing)[0].center.x(), 1.88, 1e-12);
  EXPECT_NEAR(legs.discs(standing)[0].center.y(), 3.0, 1e-12);
}

TEST(Legs, OfWhoStandsSwayAsMuchAsAskedAndTakeSmallSteps) {
  const std::vector<Person> standing = {{5, {2.0, 3.0}, {0.0, 0.0}, 0.3}};
  constexpr int kSteps = 300'000;  // 3000 s
  const auto look = [&](const LegOptions& options, const auto& at) {
    Legs legs(options);
    for (int k = 0; k < kSteps; ++k) {
      legs.step(0.01, standing);
      at(k, legs.discs(standing));
    }
  };
  // Facing +x: the left leg belongs 0.12 m to the left. Wandering is forgotten in 1 s: 1500 draws of its
  // square, whose standard error is sqrt(2 / 1500) of it, 3.7 %; five of them.
  double squares = 0.0;
  look({.sway = 0.003}, [&](int, const std::vector<Disc>& discs) {
    squares += std::pow(discs[0].center.y() - 3.12, 2.0) / kSteps;
  });
  EXPECT_NEAR(squares / 9e-6, 1.0, 0.19);
  // Waits are uniform in 5 to 25 s: 200 steps in 3000 s, standard error 200 * 0.385 / sqrt(200) = 5.4.
  int steps = 0;
  double nearest = 1.0;
  double widest = 0.0;
  std::vector<Disc> before;
  bool moved_before = false;
  look({.shift_every = 15.0}, [&](int k, const std::vector<Disc>& discs) {
    const bool moves = k > 0 && (discs[0].center != before[0].center || discs[1].center != before[1].center);
    if (moves && !moved_before) ++steps;
    moved_before = moves;
    before = discs;
    nearest = std::min(nearest, (discs[0].center - discs[1].center).norm());
    widest = std::max(widest, (discs[0].center - discs[1].center).norm());
  });
  EXPECT_NEAR(steps, 200, 27);
  EXPECT_GE(nearest, 0.1);  // set down 0.14 m apart at least; on its way a foot may pass a little nearer
  EXPECT_LE(widest, 0.46);
}

}  // namespace
}  // namespace bw
