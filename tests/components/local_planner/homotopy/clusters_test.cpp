#include "components/local_planner/homotopy/clusters.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "components/local_planner/homotopy/edge_check.hpp"
#include "components/local_planner/homotopy/segment_distance.hpp"
#include "tests/components/local_planner/homotopy/scenes.hpp"

namespace bw::homotopy {
namespace {

StaticObstacles random_obstacles(Random& random, int count, double extent) {
  StaticObstacles all;
  for (int i = 0; i < count; ++i) {
    const Vector2 a{random.uniform(-extent, extent), random.uniform(-extent, extent)};
    const Vector2 b = a + Vector2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
    const double kind = random.uniform();
    if (kind < 0.4) all.points.push_back(a);
    if (kind >= 0.4 && kind < 0.7) all.discs.push_back({a, random.uniform(0.0, 0.5)});
    if (kind >= 0.7) all.segments.push_back({a, b});
  }
  return all;
}

// Parts with the number of their cluster, found by joining every pair that is near enough until nothing
// changes.
std::vector<int> joined_pair_by_pair(const std::vector<Part>& parts, double widest_gap) {
  std::vector<int> cluster(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) cluster[i] = static_cast<int>(i);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double reach = widest_gap + parts[i].radius + parts[k].radius;
      if (squared_distance(parts[i].axis, parts[k].axis) > reach * reach) continue;
      const int from = cluster[i], to = cluster[k];
      std::replace(cluster.begin(), cluster.end(), from, to);
    }
  }
  return cluster;
}

TEST(Clusters, AreThoseThatEveryPairJoinedMakes) {
  Random random(9);
  std::size_t clusters_seen = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const int count = scene < 30 ? 5 + scene : 200;
    const StaticObstacles all = random_obstacles(random, count, scene % 2 == 0 ? 5.0 : 20.0);
    const double widest_gap = scene % 3 == 0 ? 0.0 : 0.6;
    const std::vector<std::vector<Part>> clusters = clusters_of(all, widest_gap);
    std::vector<Part> parts;
    for (const std::vector<Part>& cluster : clusters)
      parts.insert(parts.end(), cluster.begin(), cluster.end());
    ASSERT_EQ(parts.size(), all.size());
    const std::vector<int> expected = joined_pair_by_pair(parts, widest_gap);
    std::size_t i = 0;
    std::set<int> numbers;
    for (const std::vector<Part>& cluster : clusters) {
      numbers.insert(expected[i]);
      for (std::size_t k = 0; k < cluster.size(); ++k, ++i) {
        EXPECT_EQ(expected[i], expected[i - k]) << "scene " << scene;
      }
    }
    EXPECT_EQ(numbers.size(), clusters.size()) << "scene " << scene;
    clusters_seen += clusters.size();
  }
  EXPECT_GT(clusters_seen, 500U);
}

// A body of many parts is looked at where the edge is; the same parts as bodies of one are looked at one by
// one.
TEST(Clusters, OfManyPartsBlockTheEdgesThatTheirPartsBlock) {
  Random random(10);
  int blocked = 0;
  for (int scene = 0; scene < 20; ++scene) {
    Body together = standing({0.0, 0.0}, 0.0);
    together.parts.clear();
    std::vector<Body> apart;
    for (int i = 0; i < 100; ++i) {
      const Vector2 a{random.uniform(1.0, 9.0), random.uniform(-3.0, 3.0)};
      const Vector2 offset(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
      Body one = standing(a, i % 3 == 0 ? 0.1 : 0.0);
      if (i % 2 == 0) one.parts[0].axis.b = a + offset;
      together.parts.push_back(one.parts[0]);
      apart.push_back(one);
    }
    const std::vector<Body> whole{together};
    const EdgeCheck of_one(ten_metres(), whole, 0.1);
    const EdgeCheck of_many(ten_metres(), apart, 0.1);
    for (int edge = 0; edge < 100; ++edge) {
      const Vector2 from{random.uniform(0.5, 9.5), random.uniform(-3.0, 3.0)};
      const double length = edge % 2 == 0 ? 0.3 : 3.0;
      const Vector2 to = from + Vector2(random.uniform(-length, length), random.uniform(-length, length));
      const bool clear = of_many.clear(from, to);
      EXPECT_EQ(of_one.clear(from, to), clear);
      blocked += clear ? 0 : 1;
    }
  }
  EXPECT_GT(blocked, 300);
  EXPECT_LT(blocked, 1900);
}

}  // namespace
}  // namespace bw::homotopy
