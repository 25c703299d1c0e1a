#include "components/local_planner/homotopy/roadmap.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/homotopy/edge_check.hpp"
#include "tests/components/local_planner/homotopy/scenes.hpp"

namespace bw::homotopy {
namespace {

bool has_vertex(const Roadmap& map, const Vector2& p) {
  for (const Vector2& v : map.vertices) {
    if ((v - p).norm() < 1e-9) return true;
  }
  return false;
}

TEST(Roadmap, KeypointsLieBesideADisc) {
  // Centre +- n (r_o + r_r + d + offset) = 0.4 + 0.3 + 0.2 + 0.1 = 1 m (homotopy/theory.md 6.2).
  const Roadmap map = keypoint_roadmap(ten_metres(), {standing({5.0, 0.5}, 0.4)}, {});
  ASSERT_EQ(map.vertices.size(), 4u);
  EXPECT_EQ(map.vertices.front(), Vector2(0.0, 0.0));
  EXPECT_EQ(map.vertices.back(), Vector2(10.0, 0.0));
  EXPECT_TRUE(has_vertex(map, {5.0, 1.5}));
  EXPECT_TRUE(has_vertex(map, {5.0, -0.5}));
}

TEST(Roadmap, ALongWallHasKeypointsAtBothEnds) {
  // A wall from (3, 1) to (7, 1): 0.6 m beside it at x = 3 and x = 7.
  Body wall = standing({5.0, 1.0}, 0.0);
  wall.parts[0].axis = {{3.0, 1.0}, {7.0, 1.0}};
  const Roadmap map = keypoint_roadmap(ten_metres(), {wall}, {});
  ASSERT_EQ(map.vertices.size(), 6u);
  for (const double x : {3.0, 7.0}) {
    EXPECT_TRUE(has_vertex(map, {x, 1.6}));
    EXPECT_TRUE(has_vertex(map, {x, 0.4}));
  }
}

TEST(Roadmap, AWallAslantHasThemBesideItsTips) {
  Body wall = standing({5.0, 0.0}, 0.0);
  wall.parts[0].axis = {{4.0, -2.0}, {6.0, 2.0}};
  const Roadmap map = keypoint_roadmap(ten_metres(), {wall}, {});
  ASSERT_EQ(map.vertices.size(), 4u);
  // Within 0.5 (0.3 + 0.1 + 0.001) m of a tip a point reaches out as far as the tip: only the tip itself
  // here.
  EXPECT_TRUE(has_vertex(map, {6.0, 2.6}));
  EXPECT_TRUE(has_vertex(map, {4.0, -2.6}));
}

TEST(Roadmap, ANarrowGapIsUsedDownToTheEdgeClearance) {
  // Between two discs 0.9 m is free, 0.8 needed; a keypoint at the wanted 0.6 m beside one would be 0.3 m
  // beside the other. One in the gap must be nearer.
  const Roadmap map =
      keypoint_roadmap(ten_metres(), {standing({5.0, 0.95}, 0.5), standing({5.0, -0.95}, 0.5)}, {});
  bool in_gap = false;
  for (const Vector2& v : map.vertices) in_gap = in_gap || (v.x() == 5.0 && std::abs(v.y()) <= 0.05 + 1e-9);
  EXPECT_TRUE(in_gap);
}

TEST(Roadmap, EdgesGoForwardAndKeepClear) {
  Random random(7);
  std::size_t edges = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Body> bodies;
    for (const Vector2& p : separated(random, 6, 1.2)) bodies.push_back(standing(p, 0.2));
    HomotopyOptions options;
    if (trial % 2 == 0) options.method = Vertices::roadmap;
    const Course course = ten_metres();
    const Roadmap map =
        trial % 2 == 0 ? random_roadmap(course, bodies, options) : keypoint_roadmap(course, bodies, options);
    for (std::size_t i = 0; i < map.vertices.size(); ++i) {
      for (const RoadmapEdge& e : map.edges[i]) {
        const Vector2 step = map.vertices[e.to] - map.vertices[i];
        EXPECT_GT(e.to, i);
        EXPECT_DOUBLE_EQ(e.length, step.norm());
        EXPECT_GT(step.x(), 0.45 * step.norm());
        // 0.2 + 0.3 + half or all of 0.2 between the centres.
        const double needed = trial % 2 == 0 ? 0.7 : 0.6;
        for (const Body& body : bodies) {
          for (int k = 0; k <= 50; ++k) {
            const Vector2 p = map.vertices[i] + (k / 50.0) * step;
            EXPECT_GT((p - body.representative).norm(), needed - 1e-6);
          }
        }
        ++edges;
      }
    }
  }
  EXPECT_GT(edges, 1000u);
}

TEST(Roadmap, RandomVerticesFollowTheSeedAndTheCourse) {
  HomotopyOptions options;
  options.method = Vertices::roadmap;
  const Roadmap map = random_roadmap(ten_metres(), {}, options);
  ASSERT_EQ(map.vertices.size(), 17u);  // 15, start and goal
  for (const Vector2& v : map.vertices) {
    EXPECT_TRUE(v.x() >= 0.0 && v.x() <= 10.0 && std::abs(v.y()) <= 3.0);
  }
  Course rotated = ten_metres();  // by 90 degrees
  rotated.goal = {0.0, 10.0};
  const Roadmap other = random_roadmap(rotated, {}, options);
  for (std::size_t k = 0; k < map.vertices.size(); ++k) {
    EXPECT_NEAR(other.vertices[k].x(), -map.vertices[k].y(), 1e-12);
    EXPECT_NEAR(other.vertices[k].y(), map.vertices[k].x(), 1e-12);
  }
  options.roadmap_graph_seed = 2;
  EXPECT_NE(random_roadmap(ten_metres(), {}, options).vertices, map.vertices);
}

}  // namespace
}  // namespace bw::homotopy
