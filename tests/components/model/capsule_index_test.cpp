#include "components/model/capsule_index.hpp"

#include <set>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

Capsule random_capsule(Random& random, double extent) {
  const Vector2 a(random.uniform(-extent, extent), random.uniform(-extent, extent));
  const double kind = random.uniform();
  const double length = kind < 0.4 ? 0.0 : kind < 0.6 ? 0.05 : kind < 0.8 ? 1.0 : 30.0;
  const Vector2 axis(random.uniform(-length, length), random.uniform(-length, length));
  return {a, a + axis, random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 0.6)};
}

// From none to thousands of capsules, on a table and in a hall, near the origin and 100 km away: no capsule
// within reach is missed, and what is far from the position is hardly looked at.
TEST(CapsuleIndex, FindsAllThatALookAtEachOneFinds) {
  Random random(41);
  std::size_t within = 0, groups_seen = 0, looks_of_brute_force = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const double extent = scene % 3 == 0 ? 0.5 : scene % 3 == 1 ? 5.0 : 50.0;
    const int count = scene % 5 == 0 ? scene / 5 : 200 * (scene % 5) * (scene % 5);
    const Vector2 origin = scene % 2 == 0 ? Vector2(0.0, 0.0) : Vector2(1e5, -1e5);
    std::vector<Capsule> capsules;
    for (int i = 0; i < count; ++i) {
      capsules.push_back(random_capsule(random, extent));
      capsules.back().a += origin;
      capsules.back().b += origin;
    }
    const CapsuleIndex index(capsules);
    ASSERT_EQ(index.size(), capsules.size());
    for (int query = 0; query < 10; ++query) {
      const Vector2 position =
          origin + Vector2(random.uniform(-extent, extent), random.uniform(-extent, extent));
      const double reach = query == 0 ? 0.0 : random.uniform(0.0, 3.0);
      std::set<std::uint32_t> seen;
      index.visit_near(position, reach, [&](const CapsuleIndex::Group& group) {
        for (const std::uint32_t i : index.members(group)) seen.insert(i);
        ++groups_seen;
      });
      looks_of_brute_force += capsules.size();
      for (std::uint32_t i = 0; i < capsules.size(); ++i) {
        if (distance_to(position, capsules[i]).distance > reach - 1e-9) continue;
        ++within;
        EXPECT_TRUE(seen.contains(i)) << "scene " << scene << " capsule " << i;
      }
    }
  }
  EXPECT_GT(within, 10000U);
  EXPECT_LT(groups_seen, looks_of_brute_force / 2);
}

// A wall of 2000 km and a disc of 50 m among a thousand points: neither costs a look at all else from
// everywhere, and both are found.
TEST(CapsuleIndex, FindsWhatReachesFarAmongManySmallOnes) {
  std::vector<Capsule> capsules;
  for (int i = 0; i < 1000; ++i) capsules.push_back({{0.2 * i, 5.0}, {0.2 * i, 5.0}, 0.0});
  capsules.push_back({{-1e6, 0.0}, {1e6, 0.0}, 0.0});
  capsules.push_back({{100.0, -60.0}, {100.0, -60.0}, 50.0});
  const CapsuleIndex index(capsules);
  const auto found_at = [&](const Vector2& position, double reach) {
    std::set<std::uint32_t> found;
    index.visit_near(position, reach, [&](const CapsuleIndex::Group& group) {
      for (const std::uint32_t i : index.members(group)) found.insert(i);
    });
    return found;
  };
  const std::set<std::uint32_t> at_the_wall = found_at({30.0, 0.5}, 1.0);
  EXPECT_EQ(at_the_wall, (std::set<std::uint32_t>{1000}));
  const std::set<std::uint32_t> at_both = found_at({100.0, -9.5}, 9.8);
  EXPECT_TRUE(at_both.contains(1000) && at_both.contains(1001));
  EXPECT_TRUE(found_at({50.0, 4.9}, 0.2).contains(250));
  std::size_t pieces = 0;
  index.visit_near({0.0, 0.0}, 1e7,
                   [&](const CapsuleIndex::Group& group) { pieces += index.members(group).front() == 1000; });
  EXPECT_EQ(pieces, 200U);
}

TEST(CapsuleIndex, KeepsPointsMillimetresApartInFewGroups) {
  std::vector<Capsule> wall;
  for (int i = 0; i < 10000; ++i) wall.push_back({{0.001 * i, 1.0}, {0.001 * i, 1.0}, 0.0});
  const CapsuleIndex index(wall);
  int groups = 0;
  index.visit_near({5.0, 1.0}, 0.5, [&](const CapsuleIndex::Group&) { ++groups; });
  EXPECT_GE(groups, 1000 / 35);  // a metre of wall in cells of 35 mm
  EXPECT_LE(groups, 1000 / 35 + 3);
}

TEST(CapsuleIndex, TakesPointsDiscsAndSegmentsInThisOrder) {
  StaticObstacles statics;
  statics.points = {{1.0, 2.0}};
  statics.discs = {{{3.0, 4.0}, 0.5}};
  statics.segments = {{{0.0, 0.0}, {1.0, 0.0}}};
  const std::vector<Capsule> capsules = capsules_of(statics);
  ASSERT_EQ(capsules.size(), 3U);
  EXPECT_EQ(capsules[0].b, Vector2(1.0, 2.0));
  EXPECT_EQ(capsules[1].radius, 0.5);
  EXPECT_EQ(capsules[2].b, Vector2(1.0, 0.0));
}

}  // namespace
}  // namespace bw
