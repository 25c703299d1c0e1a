#include "components/local_planner/teb/association.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "components/local_planner/teb/nearest_statics.hpp"
#include "components/model/nearest_point.hpp"
#include "components/model/random.hpp"

namespace bw::teb {
namespace {

TEST(Associate, MoversAreWhereTheyWillBe) {
  // The robot needs 0.3 s per 0.3 m; the mover crosses x = 1.5 when pose 5 (t = 1.5 s) is there, and is far
  // from every other pose.
  Band band;
  for (int k = 0; k <= 10; ++k) band.poses.push_back({0.3 * k, 0.0, 0.0, 0.3});
  ObstacleField field;
  Mover mover;
  mover.position = {1.5, -6.0};
  mover.velocity = {0.0, 4.0};
  mover.radius = 0.1;
  field.movers = {mover};
  BandOptions options;
  options.clearance_step = 10.0;
  const std::vector<PoseTerms> terms = associate(band, field, options);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    ASSERT_EQ(terms[k].at_pose.size(), k == 5 ? 1U : 0U) << k;
  }
  EXPECT_NEAR(terms[5].at_pose[0].capsule.a.y(), 0.0, 1e-12);
}

TEST(Associate, TestsBetweenPosesWhatMovesFarInOneInterval) {
  // A thin mover at 4 m/s passes the robot's line in the middle of an interval: 0.6 m away at both poses, on
  // the line between them.
  Band band;
  for (int k = 0; k <= 4; ++k) band.poses.push_back({0.1 * k, 0.0, 0.0, 0.3});
  ObstacleField field;
  Mover mover;
  mover.position = {0.15, -1.8};
  mover.velocity = {0.0, 4.0};
  mover.radius = 0.0;
  field.movers = {mover};
  BandOptions options;
  options.min_obstacle_dist = options.inflation_dist = options.dynamic_obstacle_inflation_dist = 0.1;
  const std::vector<PoseTerms> terms = associate(band, field, options);
  EXPECT_FALSE(terms[1].along_segment.empty());
}

Band straight_band(int segments) {
  Band band;
  for (int k = 0; k <= segments; ++k) band.poses.push_back({0.3 * k, 0.0, 0.0, 0.3});
  return band;
}

// 300 points around the robot, out of reach of the band, and one far ahead right beside it.
TEST(Associate, WhatIsNearTheBandCountsHoweverMuchIsNearTheRobot) {
  StaticObstacles statics;
  for (int i = 0; i < 300; ++i) statics.points.push_back({-0.01 * i, 1.5});
  statics.points.push_back({8.1, 0.2});
  const ObstacleField field = field_of(statics, {}, {0.0, 0.0}, {.radius = 0.3});
  const std::vector<PoseTerms> terms = associate(straight_band(30), field, {});
  ASSERT_EQ(terms[27].at_pose.size(), 1U);
  EXPECT_EQ(terms[27].at_pose[0].capsule.a, Vector2(8.1, 0.2));
}

// Movers standing on one spot are as near as can be, and more than a pose has slots for.
TEST(Associate, MoversTakeNoPlaceFromWallsNorWallsFromMovers) {
  StaticObstacles statics;
  std::vector<Mover> movers;
  for (int i = 0; i < 8; ++i) statics.points.push_back({1.2 + 0.1 * i, 0.5});
  const ObstacleField alone = field_of(statics, {}, {0.0, 0.0}, {.radius = 0.3});
  for (std::uint32_t i = 0; i < 20; ++i) movers.push_back({.id = i, .position = {1.5, -0.4}});
  const ObstacleField both = field_of(statics, movers, {0.0, 0.0}, {.radius = 0.3});
  BandOptions options;
  options.max_obstacles_per_pose = 8;
  const auto count = [&](const ObstacleField& field, bool moving) {
    const std::vector<PoseTerms> terms = associate(straight_band(10), field, options);
    return std::count_if(terms[5].at_pose.begin(), terms[5].at_pose.end(),
                         [&](const ClearanceTerm& term) { return term.moving == moving; });
  };
  EXPECT_EQ(count(alone, false), 8);
  EXPECT_EQ(count(both, false), 8);
  EXPECT_EQ(count(both, true), 8);
}

TEST(Associate, TellsWhatItLeavesOut) {
  BandOptions options;
  options.max_obstacles_per_pose = 8;
  options.clearance_step = 10.0;
  std::vector<Mover> movers;
  for (std::uint32_t i = 0; i < 12; ++i) movers.push_back({.id = i, .position = {1.5, 0.1 * i - 0.6}});
  const ObstacleField few = field_of({}, {movers.begin(), movers.begin() + 8}, {0.0, 0.0}, {.radius = 0.3});
  const ObstacleField many = field_of({}, movers, {0.0, 0.0}, {.radius = 0.3});
  EXPECT_EQ(associate(straight_band(10), few, options)[5].left_out, 0U);
  // All twelve are within 0.6 m, half of the widths of robot and mover, of pose 5: each costs something.
  EXPECT_EQ(associate(straight_band(10), many, options)[5].left_out, 4U);
}

Capsule random_capsule(Random& random) {
  const Vector2 a(random.uniform(-1.0, 13.0), random.uniform(-1.5, 1.5));
  const double kind = random.uniform();
  if (kind < 0.5) return {a, a, 0.0};
  if (kind < 0.7) return {a, a, random.uniform(0.0, 0.5)};
  const double length = kind < 0.9 ? 0.5 : 10.0;
  const Vector2 offset(random.uniform(-length, length), random.uniform(-1.0, 1.0));
  return {a, a + offset, kind < 0.8 ? 0.0 : random.uniform(0.0, 0.2)};
}

// All in reach, sorted.
std::vector<NearStatic> all_in_reach(const ObstacleField& field, const Pose2& pose, double reach) {
  std::vector<NearStatic> all;
  for (std::uint32_t i = 0; i < field.statics.size(); ++i) {
    const Capsule& c = field.statics.capsules()[i];
    const Vector2 spot = nearest_point(Segment{c.a, c.b}, pose.position());
    if ((spot - pose.position()).norm() > reach + c.radius + field.footprint.radius) continue;
    all.push_back({gap_to(field.footprint, pose, c), spot, i});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const NearStatic& l, const NearStatic& r) { return l.distance < r.distance; });
  return all;
}

// Those of them that touch no spot before them.
std::vector<NearStatic> by_brute_force(const ObstacleField& field, const Pose2& pose, double reach) {
  std::vector<NearStatic> kept;
  for (const NearStatic& n : all_in_reach(field, pose, reach)) {
    const auto touches = [&](const NearStatic& k) { return (k.spot - n.spot).norm() < 0.05; };
    if (std::none_of(kept.begin(), kept.end(), touches)) kept.push_back(n);
  }
  return kept;
}

// The `most` of them where there are more, by the rules of NearestStatics in words: spots widen by 1.5 times
// what they are away from costing, and a side has half of the slots as long as the other has something
// costly.
std::vector<NearStatic> fair_shares(const std::vector<NearStatic>& all, const Pose2& pose, std::size_t most,
                                    double costly) {
  std::vector<NearStatic> kept, spare;
  std::size_t left = (most + 1) / 2, right = left;
  for (const NearStatic& n : all) {
    if (kept.size() == most || (n.distance >= costly && kept.size() + spare.size() >= most)) break;
    std::size_t& slots = cross(direction(pose.theta), n.spot - pose.position()) > 0.0 ? left : right;
    if (slots == 0 && spare.size() == most) continue;
    const auto touches = [&](const NearStatic& k) {
      return (k.spot - n.spot).norm() < std::max(0.05, 1.5 * (k.distance - costly));
    };
    if (std::any_of(kept.begin(), kept.end(), touches)) continue;
    if (std::any_of(spare.begin(), spare.end(), touches)) continue;
    (slots > 0 ? kept : spare).push_back(n);
    if (slots > 0) --slots;
  }
  kept.insert(kept.end(), spare.begin(),
              spare.begin() + static_cast<std::ptrdiff_t>(std::min(most - kept.size(), spare.size())));
  std::stable_sort(kept.begin(), kept.end(),
                   [](const NearStatic& l, const NearStatic& r) { return l.distance < r.distance; });
  return kept;
}

TEST(NearestStatics, AreThoseThatALookAtAllOfThemFinds) {
  Random random(18);
  const Footprint rectangle{.radius = 0.34,
                            .polygon = {{0.25, 0.21}, {-0.25, 0.21}, {-0.25, -0.21}, {0.25, -0.21}}};
  std::size_t compared = 0;
  for (const int count : {1, 8, 40, 300, 3000}) {
    for (int scene = 0; scene < 12; ++scene) {
      std::vector<Capsule> capsules;
      for (int i = 0; i < count; ++i) {
        capsules.push_back(random_capsule(random));
        // A third of the scenes is of walls of points, millimetres apart.
        if (scene % 3 == 0) capsules.back() = {{random.uniform(0.0, 12.0), 0.7}, {0.0, 0.0}, 0.0};
        if (scene % 3 == 0) capsules.back().b = capsules.back().a;
      }
      ObstacleField field;
      field.statics = CapsuleIndex(capsules);
      field.footprint = scene % 2 == 0 ? Footprint{} : rectangle;
      NearestStatics search(field, 0.7, 0.3);
      std::vector<NearStatic> found;
      for (int slot = 0; slot < 10; ++slot) {
        const Pose2 pose{random.uniform(0.0, 12.0), random.uniform(-1.0, 1.0), random.uniform(-3.0, 3.0)};
        search.look_along({pose.position() + Vector2(0.4, 0.0), pose.position() + Vector2(0.4, 0.3)}, 0.5);
        const std::vector<NearStatic> expected = by_brute_force(field, pose, 0.7);
        EXPECT_EQ(search.find(pose, 1000, found), 0U);
        ASSERT_EQ(found.size(), expected.size()) << count << " capsules, scene " << scene;
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_EQ(found[i].index, expected[i].index);
          EXPECT_NEAR(found[i].distance, expected[i].distance, 1e-12);
        }
        // Of more than there are slots for, what costs nothing yet is thinned out.
        if (expected.size() > 5) {
          const std::vector<NearStatic> thinned = fair_shares(all_in_reach(field, pose, 0.7), pose, 5, 0.3);
          search.find(pose, 5, found);
          ASSERT_EQ(found.size(), std::min<std::size_t>(5, thinned.size()));
          for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].index, thinned[i].index);
        }
        compared += expected.size();
      }
    }
  }
  EXPECT_GT(compared, 5000U);
}

TEST(NearestStatics, CountWhatIsCostlyAndLeftOut) {
  std::vector<Capsule> walls;
  for (int i = -100; i <= 100; ++i) {
    walls.push_back({{0.01 * i, 0.40}, {0.01 * i, 0.40}, 0.0});
    walls.push_back({{0.01 * i, -0.47}, {0.01 * i, -0.47}, 0.0});
  }
  ObstacleField field;
  field.statics = CapsuleIndex(walls);
  field.footprint.radius = 0.3;
  NearestStatics search(field, 0.7, 0.3);
  search.look_along({{0.0, 0.0}, {0.0, 0.0}}, 0.0);
  std::vector<NearStatic> found;
  // By brute force: of the spots within 0.3 m of the rim of the robot, 5 cm apart, those beyond the eighth.
  std::size_t costly = 0;
  for (const NearStatic& n : by_brute_force(field, {}, 0.7)) costly += n.distance < 0.3;
  EXPECT_GT(costly, 20U);
  const std::size_t left_out = search.find({}, 8, found);
  EXPECT_GE(left_out, costly - 8);
  EXPECT_LE(left_out, 2 * costly);  // a spot of 5 cm is of one or two groups of 3.5 cm
  ASSERT_EQ(found.size(), 8U);
  EXPECT_NEAR(found[0].spot.y(), 0.4, 1e-12);
  // The left wall is nearer, and has half of the slots.
  EXPECT_EQ(std::count_if(found.begin(), found.end(), [](const NearStatic& n) { return n.spot.y() > 0.0; }),
            4);
}

}  // namespace
}  // namespace bw::teb
