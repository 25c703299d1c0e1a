#include "components/slam/refinement.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

SurfaceMap map_of(const Scan& scan, double resolution = 0.05) {
  SurfaceMap map(resolution);
  map.insert(scan.points, {});
  return map;
}

// Surfaces of a straight wall, one in each cell that it goes through.
void add_wall(const Vector2& from, const Vector2& along, double normal, int n,
              std::vector<Surface>& surfaces) {
  for (int k = 0; k < n; ++k) {
    const Vector2 p = from + k * along;
    surfaces.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()),
                        static_cast<float>(std::cos(2.0 * normal)),
                        static_cast<float>(std::sin(2.0 * normal)), 1});
  }
}

std::vector<SurfacePoint> points_at(const std::vector<Surface>& surfaces) {
  std::vector<SurfacePoint> points;
  for (const Surface& surface : surfaces) points.push_back(surface.point());
  return points;
}

// One point each, that does not move: the nearest to each cell's centre is that of a search through all of
// them, and the likelihood exp(-d^2 / (2 * 0.08^2)) in 255ths.
TEST(SurfaceMap, NearestAndLikelihoodAreThoseOfASearchThroughAll) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<SurfacePoint>
        points;  // one in a cell: a surface that moves would leave older distances behind
    for (int k = 0; k < 60; ++k) {
      const int i = static_cast<int>(random.bits() % 8) * 8 - 32;
      points.push_back({static_cast<float>((i + k / 8 + random.uniform()) * 0.05),
                        static_cast<float>((k - 30 + random.uniform()) * 0.05), 1.0F, 0.0F});
    }
    SurfaceMap map(0.05);
    map.insert(points, {});
    for (int i = -40; i < 40; ++i) {
      for (int j = -40; j < 40; ++j) {
        const Vector2 centre{(i + 0.5) * 0.05, (j + 0.5) * 0.05};
        double best = 1e9;
        for (const Surface& surface : map.surfaces())
          best = std::min(best, (surface.point().position() - centre).norm());
        const Surface* nearest = map.nearest(centre.x(), centre.y());
        ASSERT_EQ(nearest != nullptr, best <= SurfaceMap::kReach) << best;
        const double likelihood = nearest == nullptr ? 0.0 : 255.0 * std::exp(-best * best / (2.0 * 0.0064));
        ASSERT_NEAR(map.likelihood_of_cell(i, j), likelihood, 0.51);
        ASSERT_EQ(map.likelihood(centre.x(), centre.y()), map.likelihood_of_cell(i, j));
        if (nearest == nullptr) continue;
        ASSERT_NEAR((nearest->point().position() - centre).norm(), best, 1e-6);
      }
    }
  }
}

TEST(SurfaceMap, HitsInOneCellAreTheirMean) {
  const std::vector<SurfacePoint> points{
      {1.01F, 1.01F, 1.0F, 0.0F}, {1.03F, 1.02F, 0.0F, 1.0F}, {1.02F, 1.03F, 0.5F, 0.5F}};
  SurfaceMap map(0.05);
  map.insert(points, {});
  ASSERT_EQ(map.surfaces().size(), 1U);
  const Surface& surface = map.surfaces().front();
  EXPECT_EQ(surface.hits, 3);
  EXPECT_NEAR(static_cast<double>(surface.x), 1.02, 1e-6);
  EXPECT_NEAR(static_cast<double>(surface.y), 1.02, 1e-6);
  EXPECT_NEAR(static_cast<double>(surface.normal_cos2), 0.5, 1e-6);
  EXPECT_NEAR(static_cast<double>(surface.normal_sin2), 0.5, 1e-6);
}

// A normal turned by a is, doubled, turned by 2a.
TEST(SurfaceMap, TurnsNormalsWithThePose) {
  const std::vector<SurfacePoint> points{{1.0F, 0.0F, 1.0F, 0.0F}};
  SurfaceMap map(0.05);
  map.insert(points, {0.0, 0.0, 0.4});
  const Surface& surface = map.surfaces().front();
  EXPECT_NEAR(static_cast<double>(surface.x), std::cos(0.4), 1e-6);
  EXPECT_NEAR(static_cast<double>(surface.normal_cos2), std::cos(0.8), 1e-6);
  EXPECT_NEAR(static_cast<double>(surface.normal_sin2), std::sin(0.8), 1e-6);
}

// Walls without noise: what is left is the cells' means at the corners.
TEST(Refine, FindsAKnownDisplacementInARoom) {
  test::Scanner scanner(test::room(8.0, 6.0), 0.0, 1);
  const SurfaceMap map = map_of(scanner.scan({}, {}));
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Pose2 truth = test::random_pose(random, 0.12, 0.04);
    const Refined found = refine(map, scanner.scan({}, truth).points, {}, nullptr, 20);
    ASSERT_LT(test::distance(found.X, truth), 0.001) << "seed " << seed;
    ASSERT_LT(std::abs(wrap_angle(found.X.theta - truth.theta)), 0.0005) << "seed " << seed;
    ASSERT_GT(found.inliers, 0.99);
    ASSERT_TRUE(found.unseen.isZero());
  }
}

// 1 cm of noise in 700 beams: millimetres.
TEST(Refine, FindsItWithNoiseToMillimetres) {
  test::Scanner scanner(test::room(8.0, 6.0), 0.01, 3);
  SurfaceMap map(0.05);
  for (int k = 0; k < 10; ++k) map.insert(scanner.scan({}, {}).points, {});
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const Pose2 truth = test::random_pose(random, 0.1, 0.04);
    const Refined found = refine(map, scanner.scan({}, truth).points, {}, nullptr, 20);
    ASSERT_LT(test::distance(found.X, truth), 0.005) << "seed " << seed;
    ASSERT_LT(std::abs(wrap_angle(found.X.theta - truth.theta)), 0.002) << "seed " << seed;
  }
}

// A wrong Jacobian would converge slowly or elsewhere: from 0.1 m and 0.04 rad off, four steps are enough,
// and further ones move nothing.
TEST(Refine, ConvergesInFourSteps) {
  test::Scanner scanner(test::room(8.0, 6.0), 0.0, 1);
  const SurfaceMap map = map_of(scanner.scan({}, {}));
  const Scan scan = scanner.scan({}, {});
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const Pose2 start = test::random_pose(random, 0.08, 0.03);
    const Refined four = refine(map, scan.points, start, nullptr, 4);
    const Refined many = refine(map, scan.points, start, nullptr, 40);
    ASSERT_LT(test::distance(four.X, many.X), 0.002) << "seed " << seed;
    ASSERT_LT(test::distance(many.X, {}), 0.001) << "seed " << seed;
  }
}

// All points on straight walls, without errors: H = (inliers / 0.025)^2 * 15 / n * sum J J^T with J = (n, p x
// n). Walls x = 3 (40 points from y = -1 on) and y = 2 (60 points from x = -2 on).
TEST(Refine, InformationIsThatOfTheClosedForm) {
  std::vector<Surface> surfaces;
  add_wall({3.02, -0.98}, {0.0, 0.05}, 0.0, 40, surfaces);
  add_wall({-1.98, 2.02}, {0.05, 0.0}, 0.5 * std::numbers::pi, 60, surfaces);
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 40; ++k) {
    const Eigen::Vector3d J{1.0, 0.0, -(-0.98 + 0.05 * k)};
    expected += J * J.transpose();
  }
  for (int k = 0; k < 60; ++k) {
    const Eigen::Vector3d J{0.0, 1.0, -1.98 + 0.05 * k};
    expected += J * J.transpose();
  }
  expected *= 15.0 / 100.0 / (0.025 * 0.025);
  const Refined found = refine(SurfaceMap(0.05, surfaces), points_at(surfaces), {}, nullptr, 0);
  EXPECT_EQ(found.inliers, 1.0);
  EXPECT_LT((found.information - expected).norm(), 1e-4 * expected.norm());
}

// A wall of 10 m, the first 5 m of which the map has not: moved on by 2 m more of it lies on the map's, 7 of 10 m and the
// reach of its end, and fits as well as before. Beside the wall by more than kInlier nothing fits.
TEST(Refine, OverlapIsNotFit) {
  std::vector<Surface> map;
  add_wall({5.02, 1.02}, {0.05, 0.0}, 0.5 * std::numbers::pi, 200, map);
  std::vector<Surface> wall;
  add_wall({0.02, 1.02}, {0.05, 0.0}, 0.5 * std::numbers::pi, 200, wall);
  const auto at = [&](const Pose2& X) {
    return refine(SurfaceMap(0.05, map), points_at(wall), X, nullptr, 0);
  };
  EXPECT_NEAR(at({}).inliers, 0.5, 0.04);
  EXPECT_NEAR(at({2.0, 0.0, 0.0}).inliers, 0.7, 0.04);
  EXPECT_EQ(at({}).fit, 1.0);
  EXPECT_EQ(at({2.0, 0.0, 0.0}).fit, 1.0);
  EXPECT_EQ(at({0.0, 0.15, 0.0}).fit, 0.0);
}

// Walls at y = +-1 whose ends are out of sight: across and the heading are seen, along is not.
TEST(Refine, InACorridorThePriorDecidesAlongIt) {
  for (const double heading : {0.0, 0.5, 1.2, -2.0}) {
    const Pose2 X_CM{0.0, 0.0, heading};
    StaticObstacles corridor;
    for (const double y : {-1.0, 1.0})
      corridor.segments.push_back({X_CM * Vector2{-30.0, y}, X_CM * Vector2{30.0, y}});
    test::Scanner scanner(corridor, 0.0, 1, {.range_max = 10.0});
    const SurfaceMap map = map_of(scanner.scan({}, {0.0, 0.0, 0.0}));
    const Vector2 along = direction(heading);
    const Vector2 across{-along.y(), along.x()};
    const Vector2 p = 0.5 * along + 0.06 * across;
    const Pose2 truth{p.x(), p.y(), 0.02};
    const Vector2 q = 0.3 * along;
    UncertainPose prior{{q.x(), q.y(), 0.0}, Eigen::Matrix3d::Identity()};
    prior.covariance.diagonal() << 0.04, 0.04, 0.01;
    const Refined found = refine(map, scanner.scan({}, truth).points, prior.X, &prior, 20);
    EXPECT_GT(std::abs(found.unseen.dot(along)), std::cos(0.035)) << "heading " << heading;
    EXPECT_NEAR(found.X.position().dot(along), 0.3, 0.002) << "heading " << heading;
    EXPECT_NEAR(found.X.position().dot(across), 0.06, 0.003) << "heading " << heading;
    EXPECT_NEAR(found.X.theta, 0.02, 0.001) << "heading " << heading;
    const Eigen::Vector3d u{found.unseen.x(), found.unseen.y(), 0.0};
    EXPECT_LT((found.information * u).norm(), 1e-6 * found.information.norm());
  }
}

// Equal information from both: halfway. By the closed form above a wall's 100 points say 24000 across it.
TEST(Refine, PriorAndScanMeetByTheirInformation) {
  std::vector<Surface> surfaces;
  add_wall({3.02, -2.48}, {0.0, 0.05}, 0.0, 100, surfaces);
  UncertainPose prior{{0.01, 0.0, 0.0}, Eigen::Matrix3d::Zero()};
  prior.covariance.diagonal() << 1.0 / 24000.0, 1e-8, 1e-10;
  const Refined found = refine(SurfaceMap(0.05, surfaces), points_at(surfaces), prior.X, &prior, 20);
  EXPECT_NEAR(found.X.x, 0.005, 2e-4);
  EXPECT_NEAR(found.X.y, 0.0, 1e-6);
}

TEST(Refine, WithNothingToGoByStaysAtTheStart) {
  const SurfaceMap nothing(0.05);
  const std::vector<SurfacePoint> points{{1.0F, 1.0F, 1.0F, 0.0F}};
  const Pose2 start{1.0, 2.0, 0.3};
  for (const auto& some : {points, std::vector<SurfacePoint>{}}) {
    const Refined found = refine(nothing, some, start, nullptr, 10);
    EXPECT_EQ(found.X, start);
    EXPECT_EQ(found.inliers, 0.0);
    EXPECT_TRUE(found.information.isZero());
  }
}

}  // namespace
}  // namespace bw::slam
