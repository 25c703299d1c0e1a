#include "components/local_planner/homotopy/explore.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "components/local_planner/homotopy/class_search.hpp"
#include "tests/components/local_planner/homotopy/scenes.hpp"

namespace bw::homotopy {
namespace {

constexpr double kClearance = 0.2;

PlanningProblem among(const std::vector<Vector2>& centres) {
  PlanningProblem problem;
  problem.plan = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}};
  for (const Vector2& c : centres) problem.obstacles.discs.push_back({c, 0.3});
  return problem;
}

HomotopyOptions with_classes(int count) {
  HomotopyOptions options;
  options.max_number_classes = count;
  return options;
}

std::multiset<std::string> labels(const Exploration& exploration) {
  std::multiset<std::string> result;
  for (const Path& path : exploration.paths) result.insert(path.label);
  return result;
}

TEST(Explore, FindsEveryCombinationOfSides) {
  // n obstacles one after the other, each passed left or right by paths that only go forward: 2^n classes.
  EXPECT_EQ(labels(explore(among({{5.0, 0.0}}), kClearance, {}, with_classes(20))),
            (std::multiset<std::string>{"L", "R"}));
  EXPECT_EQ(labels(explore(among({{3.5, 0.1}, {6.5, -0.1}}), kClearance, {}, with_classes(20))),
            (std::multiset<std::string>{"LL", "LR", "RL", "RR"}));
  EXPECT_EQ(
      explore(among({{2.5, 0.0}, {5.0, 0.1}, {7.5, 0.0}}), kClearance, {}, with_classes(20)).paths.size(),
      8u);
  // Side by side with room between: left of both, between, right of both.
  EXPECT_EQ(labels(explore(among({{5.0, -0.8}, {5.0, 0.8}}), kClearance, {}, with_classes(20))),
            (std::multiset<std::string>{"LL", "LR", "RR"}));
  // Too close to pass between: one body.
  EXPECT_EQ(explore(among({{5.0, -0.6}, {5.0, 0.6}}), kClearance, {}, with_classes(20)).paths.size(), 2u);
  EXPECT_EQ(labels(explore(among({}), kClearance, {}, {})), std::multiset<std::string>{"-"});
}

TEST(Explore, PassesBeforeAndBehindSomebodyWhoCrosses) {
  // Both at 1 m/s, they would meet at (4, -0.2) after 4 s: in front of the walker, who comes from the right,
  // is left of it. Seen from the walker the robot comes at 45 degrees: vertices sqrt(2) further out.
  PlanningProblem problem = among({});
  problem.movers = {mover_at({4.0, -4.2}, {0.0, 1.0})};
  problem.plan = {{0.0, 0.0, 0.0}, {4.0, 1.5, 0.0}, {10.0, 0.0, 0.0}};
  const Exploration exploration = explore(problem, kClearance, {}, {});
  ASSERT_EQ(exploration.paths.size(), 2u);
  EXPECT_EQ(exploration.paths[0].label, "L");
  EXPECT_EQ(exploration.paths[1].label, "R");
  ASSERT_EQ(exploration.paths[1].route.size(), 3u);
  const Vector2& met = exploration.bodies[0].representative;
  const Vector2& behind = exploration.paths[1].route[1].position;
  EXPECT_NEAR(behind.x(), 4.0, 1e-9);
  EXPECT_NEAR(met.y() - behind.y(), std::sqrt(2.0) * (0.3 + 0.3 + 0.2 + 0.1), 1e-6);
}

TEST(Explore, AWallAcrossTheStripLeavesOnlyThePlan) {
  PlanningProblem problem = among({});
  problem.obstacles.segments = {{{5.0, -40.0}, {5.0, 40.0}}};
  const Exploration exploration = explore(problem, kClearance, {}, {});
  ASSERT_EQ(exploration.paths.size(), 1u);
  EXPECT_TRUE(exploration.paths[0].is_plan);
}

TEST(Explore, ReturnsTheShortestOfEachClassAndTheShortestClasses) {
  // Against all paths of the graph: the shortest of each class, and of these the shortest ones.
  Random random(8);
  for (int trial = 0; trial < 60; ++trial) {
    const PlanningProblem problem = among(separated(random, 4, 1.6));
    const HomotopyOptions options = with_classes(4);
    const Exploration found = explore(problem, kClearance, {}, options);
    std::vector<std::pair<std::vector<double>, double>> best;  // winding and length by class
    const VisitPath collect = [&](const std::vector<Vector2>& points, double length) {
      const auto w = winding(route_at_speed(points, 1.0), found.bodies, found.course);
      for (auto& [known, shortest] : best) {
        if (!same_winding(known, w)) continue;
        shortest = std::min(shortest, length);
        return true;
      }
      best.emplace_back(w, length);
      return true;
    };
    const Roadmap map = keypoint_roadmap(found.course, found.bodies, options);
    ASSERT_LT(search_depth_first(map, 1000000, collect), 1000000);
    std::erase_if(best, [&](const auto& b) {
      return same_winding(b.first, found.paths[0].signature.winding);  // the plan has this class
    });
    std::sort(best.begin(), best.end(), [](const auto& l, const auto& r) { return l.second < r.second; });
    ASSERT_EQ(found.paths.size(), std::min<std::size_t>(4, best.size() + 1));
    EXPECT_TRUE(found.paths[0].is_plan);
    for (std::size_t k = 1; k < found.paths.size(); ++k) {
      EXPECT_NEAR(found.paths[k].length, best[k - 1].second, 1e-9);
    }
  }
}

TEST(Explore, BothSearchesAndSignaturesFindTheSameClassesWithoutACap) {
  Random random(9);
  for (int trial = 0; trial < 40; ++trial) {
    const PlanningProblem problem = among(separated(random, 3, 1.8));
    HomotopyOptions options = with_classes(20);
    options.max_expansions = 1000000;
    const auto expected = labels(explore(problem, kClearance, {}, options));
    options.search = SearchOrder::depth_first;
    EXPECT_EQ(labels(explore(problem, kClearance, {}, options)), expected);
    options.signature = ClassMeasure::h_signature;
    EXPECT_EQ(labels(explore(problem, kClearance, {}, options)), expected);
    options.search = SearchOrder::best_first;
    EXPECT_EQ(labels(explore(problem, kClearance, {}, options)), expected);
  }
}

TEST(Explore, DoesNotReturnClassesInUse) {
  const PlanningProblem problem = among({{3.5, 0.1}, {6.5, -0.1}});
  const Exploration all = explore(problem, kClearance, {}, with_classes(4));
  ASSERT_EQ(all.paths.size(), 4u);
  // Bands of the last cycle: they start and end a little aside of the paths of this one.
  std::vector<Route> kept;
  for (const std::size_t k : {0u, 2u}) {
    Route route = all.paths[k].route;
    for (RoutePoint& p : route) p.position += Vector2(0.02, 0.03);
    kept.push_back(std::move(route));
  }
  const Exploration rest = explore(problem, kClearance, kept, with_classes(4));
  EXPECT_EQ(rest.in_use_labels, (std::vector<std::string>{all.paths[0].label, all.paths[2].label}));
  std::multiset<std::string> expected{all.paths[1].label, all.paths[3].label};
  EXPECT_EQ(labels(rest), expected);
  EXPECT_EQ(explore(problem, kClearance, kept, with_classes(3)).paths.size(), 1u);
  EXPECT_TRUE(explore(problem, kClearance, kept, with_classes(2)).paths.empty());
  // Two bands of one class take one place.
  EXPECT_EQ(explore(problem, kClearance, {kept[0], kept[0]}, with_classes(2)).paths.size(), 1u);
}

TEST(Explore, ThePlanComesFirstAndFromTheRobotOn) {
  // The plan passes right of the disc, a detour; the robot has its first leg behind it.
  PlanningProblem problem = among({{5.0, 0.0}});
  problem.plan = {{-2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {5.0, -2.5, 0.0}, {10.0, 0.0, 0.0}};
  problem.pose = {2.0, -0.5, 0.0};
  const Exploration exploration = explore(problem, kClearance, {}, {});
  ASSERT_EQ(exploration.paths.size(), 2u);
  EXPECT_TRUE(exploration.paths[0].is_plan);
  EXPECT_EQ(exploration.paths[0].label, "R");
  ASSERT_EQ(exploration.paths[0].route.size(), 3u);
  EXPECT_EQ(exploration.paths[0].route[1].position, Vector2(5.0, -2.5));
  EXPECT_EQ(exploration.paths[1].label, "L");
}

// Every symmetry that planning must commute with, on random scenes with movers.
struct RandomScene {
  explicit RandomScene(std::uint64_t seed) : problem(among({})) {
    Random random(seed);
    for (const Vector2& p : separated(random, 6, 1.1)) problem.obstacles.discs.push_back({p, 0.25});
    for (int k = 0; k < 40; ++k) {
      problem.obstacles.points.push_back({random.uniform(0, 10), random.uniform(-3, 3)});
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      problem.movers.push_back(mover_at({random.uniform(1, 9), random.uniform(-3, 3)},
                                        {random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6)}));
      problem.movers.back().id = k;
    }
    problem.footprint.radius = 0.1;
  }
  PlanningProblem problem;
};

TEST(Explore, DoesNotDependOnTheOrderOfObstacles) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    PlanningProblem problem = RandomScene(seed).problem;
    const Exploration before = explore(problem, 0.1, {}, {});
    std::reverse(problem.obstacles.points.begin(), problem.obstacles.points.end());
    std::reverse(problem.obstacles.discs.begin(), problem.obstacles.discs.end());
    std::reverse(problem.movers.begin(), problem.movers.end());
    const Exploration after = explore(problem, 0.1, {}, {});
    ASSERT_EQ(before.paths.size(), after.paths.size());
    EXPECT_EQ(before.expansions, after.expansions);
    for (std::size_t k = 0; k < before.paths.size(); ++k) {
      EXPECT_EQ(before.paths[k].label, after.paths[k].label);
      EXPECT_EQ(before.paths[k].length, after.paths[k].length);
      EXPECT_EQ(before.paths[k].signature.winding, after.paths[k].signature.winding);
    }
  }
}

// Applies `change` to every vector of the problem; free vectors are told by the flag.
template <class Change>
PlanningProblem changed(PlanningProblem problem, Change&& change) {
  const auto pose = [&](Pose2& p) {
    const Vector2 moved = change(p.position(), false);
    p = {moved.x(), moved.y(), 0.0};
  };
  pose(problem.pose);
  for (Pose2& p : problem.plan) pose(p);
  for (Vector2& p : problem.obstacles.points) p = change(p, false);
  for (Disc& d : problem.obstacles.discs) d.center = change(d.center, false);
  for (Mover& m : problem.movers) {
    m.position = change(m.position, false);
    m.velocity = change(m.velocity, true);
  }
  return problem;
}

TEST(Explore, CommutesWithMirroringTurningAndShifting) {
  const Pose2 frame{3.0, -7.0, 2.3};
  std::size_t paths = 0;
  for (std::uint64_t seed = 100; seed < 160; ++seed) {
    const PlanningProblem problem = RandomScene(seed).problem;
    const Exploration base = explore(problem, 0.1, {}, {});
    const Exploration moved = explore(
        changed(problem,
                [&](const Vector2& v, bool free) -> Vector2 { return free ? rotate(frame, v) : frame * v; }),
        0.1, {}, {});
    const Exploration mirrored =
        explore(changed(problem, [](const Vector2& v, bool) { return Vector2(v.x(), -v.y()); }), 0.1, {}, {});
    ASSERT_EQ(base.paths.size(), moved.paths.size());
    ASSERT_EQ(base.paths.size(), mirrored.paths.size());
    for (std::size_t k = 0; k < base.paths.size(); ++k) {
      EXPECT_EQ(base.paths[k].label, moved.paths[k].label);
      EXPECT_NEAR(base.paths[k].length, moved.paths[k].length, 1e-9);
      std::string swapped = base.paths[k].label;
      for (char& c : swapped) c = c == 'L' ? 'R' : c == 'R' ? 'L' : c;
      EXPECT_EQ(swapped, mirrored.paths[k].label) << "seed " << seed;
      EXPECT_NEAR(base.paths[k].length, mirrored.paths[k].length, 1e-9);
      for (std::size_t b = 0; b < base.bodies.size(); ++b) {
        EXPECT_NEAR(base.paths[k].signature.winding[b], moved.paths[k].signature.winding[b], 1e-6);
        EXPECT_NEAR(base.paths[k].signature.winding[b], -mirrored.paths[k].signature.winding[b], 1e-6);
      }
      ++paths;
    }
  }
  EXPECT_GT(paths, 150u);
}

TEST(Explore, IsBoundedAmongAThousandPoints) {
  Random random(10);
  for (const double spread : {3.0, 0.3}) {
    for (const double radius : {0.0, 0.3}) {
      for (const SearchOrder search : {SearchOrder::best_first, SearchOrder::depth_first}) {
        PlanningProblem problem = among({});
        problem.footprint.radius = radius;
        for (int k = 0; k < 1000; ++k) {
          problem.obstacles.points.push_back({random.uniform(0, 10), random.uniform(-spread, spread)});
        }
        HomotopyOptions options = with_classes(20);
        options.max_expansions = 300;
        options.search = search;
        const Exploration exploration = explore(problem, 0.05, {}, options);
        EXPECT_LE(exploration.expansions, 300);
        EXPECT_LE(exploration.bodies.size(), 20u);
        ASSERT_FALSE(exploration.paths.empty());
        for (const Path& path : exploration.paths) {
          EXPECT_TRUE(std::isfinite(path.length));
          for (const double w : path.signature.winding) EXPECT_TRUE(std::isfinite(w));
        }
      }
    }
  }
}

TEST(Explore, DegenerateProblemsGiveThePlan) {
  PlanningProblem at_goal = among({{0.0, 0.0}, {0.5, 0.0}});
  at_goal.plan = {{0.0, 0.0, 0.0}};
  EXPECT_EQ(explore(at_goal, kClearance, {}, {}).paths.size(), 1u);
  const PlanningProblem in_obstacle = among({{0.1, 0.0}, {9.9, 0.0}, {5.0, 0.0}});
  EXPECT_GE(explore(in_obstacle, kClearance, {}, {}).paths.size(), 2u);
  HomotopyOptions none;
  none.max_bodies = 0;
  EXPECT_EQ(explore(in_obstacle, kClearance, {}, none).paths.size(), 1u);
}

}  // namespace
}  // namespace bw::homotopy
