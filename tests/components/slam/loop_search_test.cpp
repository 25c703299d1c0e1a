#include "components/slam/loop_search.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

// Walls of length a along x and b along y: the lesser over the greater; a corridor 0, a square room 1.
TEST(AllRound, IsTheShareOfTheWallsThatSayLess) {
  std::vector<Surface> surfaces;
  for (int k = 0; k < 90; ++k) surfaces.push_back({0.05F * static_cast<float>(k), 1.0F, -1.0F, 0.0F, 1});
  EXPECT_EQ(all_round(surfaces), 0.0);
  for (int k = 0; k < 30; ++k) surfaces.push_back({1.0F, 0.05F * static_cast<float>(k), 1.0F, 0.0F, 1});
  EXPECT_NEAR(all_round(surfaces), 30.0 / 90.0, 1e-6);
  for (int k = 0; k < 60; ++k) surfaces.push_back({1.0F, 0.05F * static_cast<float>(k), 1.0F, 0.0F, 1});
  EXPECT_NEAR(all_round(surfaces), 1.0, 1e-6);
  EXPECT_EQ(all_round({}), 0.0);
}

// Walls seen on a metre from X_WS on.
Submap submap_of(test::Scanner& scanner, const Pose2& X_WS) {
  SurfaceMap map(0.05);
  for (int k = 0; k < 5; ++k) {
    const Pose2 X_SB{0.2 * k, 0.0, 0.0};
    map.insert(scanner.scan({}, X_WS * X_SB).points, X_SB);
  }
  Submap submap;
  submap.surfaces = map.surfaces();
  submap.centre = centre(submap.surfaces);
  return submap;
}

// A submap seen again from a pose 0.2 m and 0.03 rad off what is expected: found to a centimetre. The room's
// scan is exact, its surfaces are means of cells.
TEST(LoopSearch, FindsASubmapSeenAgain) {
  test::Scanner scanner(test::square_of_corridors(), 0.0, 1);
  const Pose2 X_W1{-5.0, -4.0, 0.0};
  const Pose2 X_W2{-4.7, -3.9, 0.4};
  const Submap earlier = submap_of(scanner, X_W1);
  const Submap later = submap_of(scanner, X_W2);
  const Scan scan = scanner.scan({}, X_W2);
  const Scan then = scanner.scan({}, X_W1);
  const Sights sights{{&scan.ranges}, {Pose2{}}};
  LoopSearch search(later.surfaces, sights, {});
  UncertainPose expected{inverse(X_W2) * X_W1, Eigen::Matrix3d::Identity()};
  expected.X.x += 0.15;
  expected.X.y -= 0.13;
  expected.X.theta += 0.03;
  expected.covariance.diagonal() << 0.01, 0.01, 0.0004;
  const auto loop = search.find(earlier, {{&then.ranges}, {Pose2{}}}, expected);
  ASSERT_TRUE(loop);
  EXPECT_TRUE(loop->edge.loop);
  const Eigen::Vector3d off = difference(loop->edge.X.X, inverse(X_W1) * X_W2);
  EXPECT_LT(off.head<2>().norm(), 0.01);
  EXPECT_LT(std::abs(off.z()), 0.003);
  EXPECT_LT(loop->through, 0.05);
  EXPECT_GT(loop->inliers, 0.8);
}

// A room of 8 x 6 m, and one of the same size with shelves of 6 and 4.5 m half a metre before its walls, which hide 12.6
// of their 28 m. What is seen of the first is nowhere seen through from the second; but of the second's 26 m of walls the
// first one's beams went through up to 10.5, less where they pass them at a low angle.
TEST(LoopSearch, WallsThatWereSeenThroughThenSpeakAgainstIt) {
  const StaticObstacles bare = test::room(8.0, 6.0);
  StaticObstacles furnished = bare;
  test::add_box(furnished, {-3.0, 2.5}, {3.0, 2.7});
  test::add_box(furnished, {-2.5, -2.7}, {2.0, -2.5});
  LaserOptions laser;
  laser.field_of_view = 6.27;
  test::Scanner then(bare, 0.0, 1, laser);
  test::Scanner now(furnished, 0.0, 1, laser);
  const Submap earlier = submap_of(then, {});
  const Submap later = submap_of(now, {});
  const Scan scan_then = then.scan({}, {});
  const Scan scan_now = now.scan({}, {});
  const Sights of_earlier{{&scan_then.ranges}, {Pose2{}}};
  const Sights of_later{{&scan_now.ranges}, {Pose2{}}};
  const UncertainPose expected{{}, Eigen::Vector3d{0.04, 0.04, 0.0004}.asDiagonal()};
  LoopSearch search(later.surfaces, of_later, {});
  EXPECT_NEAR(seen_through(earlier.surfaces, of_later), 0.0, 0.02);
  const double then_through = seen_through(later.surfaces, of_earlier);
  EXPECT_GT(then_through, 0.5 * 10.5 / 26.0);
  EXPECT_LT(then_through, 10.5 / 26.0);
  const auto from_now_alone = search.find(earlier, {}, expected);
  ASSERT_TRUE(from_now_alone);
  EXPECT_LT(from_now_alone->through, 0.02) << "who looks from the second alone does not notice";
  const auto both_ways = search.find(earlier, of_earlier, expected);
  ASSERT_TRUE(both_ways);
  EXPECT_NEAR(both_ways->through, then_through, 0.05);
}

// What a search finds in the corner of its window may be what the covariance excludes: an error of y in proportion to
// that of the heading, 0.1 rad with 1 m, and the same place 1.5 m aside with the heading as expected.
TEST(LoopSearch, NothingIsFoundWhereTheCovarianceExcludesIt) {
  test::Scanner scanner(test::square_of_corridors(), 0.0, 1);
  const Submap submap = submap_of(scanner, {-5.0, -4.0, 0.0});
  const Scan scan = scanner.scan({}, {-5.0, -4.0, 0.0});
  const Sights sights{{&scan.ranges}, {Pose2{}}};
  LoopSearch search(submap.surfaces, sights, {});
  UncertainPose expected{{0.0, 1.5, 0.0}, Eigen::Vector3d{0.01, 1.0, 0.01}.asDiagonal()};
  EXPECT_TRUE(search.find(submap, sights, expected));
  expected.covariance(1, 2) = expected.covariance(2, 1) = 0.0999;
  EXPECT_FALSE(search.find(submap, sights, expected));
  expected.X = {0.0, 0.0, 0.0};
  EXPECT_TRUE(search.find(submap, sights, expected));
}

// A wall along x at (1, 2), its normal along y, in a frame that is turned by a quarter and moved.
TEST(Moved, TurnsNormalsByTwiceTheAngle) {
  const Surface wall{1.0F, 2.0F, -1.0F, 0.0F, 7};
  const Surface there = moved(wall, {10.0, 20.0, std::numbers::pi / 2.0});
  EXPECT_NEAR(there.x, 8.0, 1e-6);
  EXPECT_NEAR(there.y, 21.0, 1e-6);
  EXPECT_NEAR(there.normal_cos2, 1.0, 1e-6) << "the normal is along x";
  EXPECT_NEAR(there.normal_sin2, 0.0, 1e-6);
  EXPECT_EQ(there.hits, 7);
}

// A ring of walls seen from the middle by scanners with each a field of view: beams that go 2 m on went
// through all of it, beams that end there through nothing. 3 m away, half a degree apart.
TEST(SeenThrough, IsAllOrNothingOfARingWhateverTheFieldOfView) {
  std::vector<Surface> ring;
  for (int k = 0; k < 720; ++k) {
    const Vector2 p = 3.0 * direction(k * std::numbers::pi / 360.0);
    ring.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 1.0F, 0.0F, 1});
  }
  for (const double view : {1.5, 3.0, 4.7, 6.26}) {
    for (const double sign : {1.0, -1.0}) {
      RangeImage image;
      image.angle_min = -0.5 * sign * view;
      image.angle_increment = sign * view / 359.0;
      const Sights sights{{&image}, {Pose2{}}};
      image.millimetres.assign(360, 5000);
      EXPECT_EQ(seen_through(ring, sights), 1.0) << view << ", sign " << sign;
      image.millimetres.assign(360, 3000);
      EXPECT_EQ(seen_through(ring, sights), 0.0) << view << ", sign " << sign;
    }
  }
}

// Half of the view is seen through, whichever half: the left and the right count alike.
TEST(SeenThrough, CountsAllOfTheView) {
  std::vector<Surface> ring;
  for (int k = 0; k < 720; ++k) {
    const Vector2 p = 3.0 * direction(k * std::numbers::pi / 360.0);
    ring.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 1.0F, 0.0F, 1});
  }
  for (const bool left : {false, true}) {
    RangeImage image;
    image.angle_min = -std::numbers::pi;
    image.angle_increment = 2.0 * std::numbers::pi / 720.0;
    image.millimetres.assign(720, 3000);
    for (std::size_t i = 0; i < 360; ++i) image.millimetres[left ? 360 + i : i] = 5000;
    const Sights sights{{&image}, {Pose2{}}};
    EXPECT_NEAR(seen_through(ring, sights), 0.5, 0.02) << (left ? "left" : "right");
  }
}

}  // namespace
}  // namespace bw::slam
