#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "components/slam/branch_and_bound.hpp"
#include "components/slam/correlative_search.hpp"
#include "components/slam/max_grids.hpp"
#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

// Pieces of walls where chance wants them, within 8 x 8 m.
std::vector<Surface> any_walls(Random& random) {
  std::vector<Surface> surfaces;
  for (int wall = 0; wall < 8; ++wall) {
    const Pose2 X{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-3, 3)};
    const int n = 10 + static_cast<int>(random.bits() % 30);
    for (int k = 0; k < n; ++k) {
      const Vector2 p = X * Vector2{0.05 * k, 0.0};
      surfaces.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 1.0F, 0.0F, 1});
    }
  }
  return surfaces;
}

// Some of the walls as a scan would have them from `X`, with 2 cm of noise.
std::vector<SurfacePoint> some_seen_from(const Pose2& X, const std::vector<Surface>& surfaces, std::size_t n,
                                         Random& random) {
  std::vector<SurfacePoint> points;
  const Pose2 X_inverse = inverse(X);
  for (std::size_t k = 0; k < n; ++k) {
    const Surface& surface = surfaces[random.bits() % surfaces.size()];
    const Vector2 p = X_inverse * surface.point().position();
    points.push_back({static_cast<float>(p.x() + random.normal(0.0, 0.02)),
                      static_cast<float>(p.y() + random.normal(0.0, 0.02)), 1.0F, 0.0F});
  }
  return points;
}

int cell_at(double v, double edge) { return static_cast<int>(std::floor(v / edge)); }

// Every pose in steps of a cell and of a cell at 8 m, without a stride.
double best_of_all(const SurfaceMap& map, const std::vector<SurfacePoint>& points, const Pose2& start,
                   const SearchWindow& window) {
  const double step = map.resolution();
  const double turn = step / 8.0;
  const int nx = static_cast<int>(std::ceil(window.x / step));
  const int ny = static_cast<int>(std::ceil(window.y / step));
  const int nt = static_cast<int>(std::ceil(window.theta / turn));
  int best = 0;
  for (int t = -nt; t <= nt; ++t) {
    const Pose2 X{start.x, start.y, start.theta + t * turn};
    for (int y = -ny; y <= ny; ++y) {
      for (int x = -nx; x <= nx; ++x) {
        int sum = 0;
        for (const SurfacePoint& point : points) {
          const Vector2 p = X * point.position();
          sum += map.likelihood_of_cell(cell_at(p.x(), step) + x, cell_at(p.y(), step) + y);
        }
        best = std::max(best, sum);
      }
    }
  }
  return best / (255.0 * static_cast<double>(points.size()));
}

// Every third pose, then all around the best of them: the best of all poses, but for the 2 % of the score
// that being away from the start costs, and for a peak narrower than its 8 cm.
TEST(Correlate, FindsTheBestOfAllPosesUpToItsCostOfBeingAway) {
  int as_good = 0;
  constexpr int kSeeds = 60;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random random(seed);
    const std::vector<Surface> surfaces = any_walls(random);
    const SurfaceMap map(0.05, surfaces);
    const Pose2 start = test::random_pose(random, 1.0, 3.0);
    const Pose2 truth = start * test::random_pose(random, 0.25, 0.12);
    const std::vector<SurfacePoint> points = some_seen_from(truth, surfaces, 60, random);
    const SearchWindow window{0.4, 0.4, 0.15};
    const double best = best_of_all(map, points, start, window);
    const Correlation found = correlate(map, points, start, window);
    EXPECT_GE(found.score, best - 0.06) << "seed " << seed;
    EXPECT_LT(test::distance(found.X, truth), 0.1) << "seed " << seed;
    EXPECT_LT(std::abs(wrap_angle(found.X.theta - truth.theta)), 0.03) << "seed " << seed;
    as_good += found.score >= best - 0.02;
  }
  RecordProperty("as_good", as_good);
  EXPECT_GE(as_good, kSeeds * 9 / 10);
}

// A wall without ends fits anywhere along it: the start is taken.
TEST(Correlate, OfPosesThatFitAsWellTakesTheNearest) {
  StaticObstacles wall;
  wall.segments.push_back({{-30.0, 1.025}, {30.0, 1.025}});
  const Scan scan = test::Scanner(wall, 0.0, 1, {.range_max = 6.0}).scan({}, {});
  SurfaceMap map(0.05);
  for (double x = -3.0; x <= 3.0; x += 0.5) map.insert(scan.points, {x, 0.0, 0.0});
  const Correlation found = correlate(map, scan.points, {}, {0.5, 0.2, 0.1});
  EXPECT_EQ(found.X, Pose2{});
}

TEST(Correlate, WithoutPointsStaysAtTheStart) {
  const Pose2 start{1.0, 2.0, 0.5};
  const Correlation found = correlate(SurfaceMap(0.05), {}, start, {});
  EXPECT_EQ(found.X, start);
  EXPECT_EQ(found.score, 0.0);
}

// Level 0 is exp(-d^2 / (2 * 0.12^2)) within three cells of 0.1 m; level l the largest of 2^l x 2^l cells of
// it.
TEST(MaxGrids, EachLevelIsTheLargestOverItsSquares) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    const std::vector<Surface> surfaces = any_walls(random);
    const MaxGrids grids(surfaces);
    for (int i = -150; i < 100; ++i) {
      for (int j = -150; j < 100; ++j) {
        int expected = 0;
        for (const Surface& surface : surfaces) {
          const auto x = static_cast<double>(surface.x);
          const auto y = static_cast<double>(surface.y);
          if (std::abs(cell_at(x, 0.1) - i) > 3 || std::abs(cell_at(y, 0.1) - j) > 3) continue;
          const double squared = std::pow((i + 0.5) * 0.1 - x, 2) + std::pow((j + 0.5) * 0.1 - y, 2);
          expected = std::max(
              expected, static_cast<int>(std::lround(255.0 * std::exp(-squared / (2.0 * 0.12 * 0.12)))));
        }
        ASSERT_NEAR(grids.at(0, i, j), expected, 1) << i << ", " << j;
      }
    }
    for (int level = 1; level < MaxGrids::kLevels; ++level) {
      for (int n = 0; n < 2000; ++n) {
        const int i = static_cast<int>(random.bits() % 250) - 150;
        const int j = static_cast<int>(random.bits() % 250) - 150;
        int largest = 0;
        for (int dj = 0; dj < 1 << level; ++dj)
          for (int di = 0; di < 1 << level; ++di) largest = std::max(largest, grids.at(0, i + di, j + dj));
        ASSERT_EQ(grids.at(level, i, j), largest) << "level " << level << " at " << i << ", " << j;
      }
    }
  }
}

TEST(MaxGrids, OfNoWallsAreZero) {
  const MaxGrids grids(std::span<const Surface>{});
  EXPECT_EQ(grids.at(0, 0, 0), 0);
  EXPECT_EQ(grids.at(5, -3, 7), 0);
  EXPECT_EQ(grids.bytes(), 0U);
}

// As a file may have them: 10 km on either side would be 240 GB.
TEST(MaxGrids, HaveABound) {
  Random random(1);
  std::vector<Surface> surfaces = any_walls(random);
  const std::size_t bytes = MaxGrids(surfaces).bytes();
  surfaces.push_back({10'000.0F, 10'000.0F, 1.0F, 0.0F, 1});
  surfaces.push_back({-10'000.0F, -10'000.0F, 1.0F, 0.0F, 1});
  EXPECT_EQ(MaxGrids(surfaces).bytes(), bytes);
}

struct Tried {
  int best = 0;
  std::int64_t poses = 0;
};

Tried all_on_max_grids(const MaxGrids& grids, const std::vector<Vector2>& points, const Pose2& start,
                       const SearchWindow& window) {
  const int nx = static_cast<int>(std::ceil(window.x / 0.1));
  const int ny = static_cast<int>(std::ceil(window.y / 0.1));
  const int nt = static_cast<int>(std::ceil(window.theta / 0.01));
  Tried tried;
  for (int t = -nt; t <= nt; ++t) {
    const Pose2 X{start.x, start.y, wrap_angle(start.theta + t * 0.01)};
    for (int y = -ny; y <= ny; ++y) {
      for (int x = -nx; x <= nx; ++x) {
        int sum = 0;
        for (const Vector2& point : points) {
          const Vector2 p = X * point;
          sum += grids.at(0, cell_at(p.x(), 0.1) + x, cell_at(p.y(), 0.1) + y);
        }
        tried.best = std::max(tried.best, sum);
        ++tried.poses;
      }
    }
  }
  return tried;
}

std::vector<Vector2> positions(const std::vector<SurfacePoint>& points) {
  std::vector<Vector2> result;
  for (const SurfacePoint& point : points) result.push_back(point.position());
  return result;
}

// The bound is the largest over a square, so that no pose with more is left out: the same score to the last
// bit.
TEST(BranchAndBound, FindsTheScoreOfAllPosesAtAFractionOfThem) {
  std::int64_t visited = 0;
  std::int64_t all = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const std::vector<Surface> surfaces = any_walls(random);
    const MaxGrids grids(surfaces);
    const Pose2 start = test::random_pose(random, 1.0, 3.0);
    const Pose2 truth = start * test::random_pose(random, 1.0, 0.09);
    const std::vector<Vector2> points = positions(some_seen_from(truth, surfaces, 40, random));
    const SearchWindow window{1.0 + random.uniform(0.0, 1.0), 1.0 + random.uniform(0.0, 1.0), 0.1};
    const Tried tried = all_on_max_grids(grids, points, start, window);
    const auto found = branch_and_bound(grids, points, start, window, 0.1, visited);
    all += tried.poses;
    ASSERT_TRUE(found) << "seed " << seed;
    ASSERT_EQ(found->score, tried.best / (255.0 * 40.0)) << "seed " << seed;
    int sum = 0;
    for (const Vector2& point : points) {
      const Vector2 p = Pose2{start.x, start.y, found->X.theta} * point;
      sum += grids.at(0, cell_at(p.x(), 0.1) + static_cast<int>(std::lround((found->X.x - start.x) / 0.1)),
                      cell_at(p.y(), 0.1) + static_cast<int>(std::lround((found->X.y - start.y) / 0.1)));
    }
    EXPECT_EQ(sum, tried.best) << "the pose is the one with that score, seed " << seed;
  }
  RecordProperty("visited_percent", static_cast<int>(100 * visited / all));
  EXPECT_LT(visited, all / 20) << visited << " of " << all;
}

TEST(BranchAndBound, FindsNothingWhereNothingScoresMore) {
  Random random(3);
  const std::vector<Surface> surfaces = any_walls(random);
  const MaxGrids grids(surfaces);
  const std::vector<Vector2> points = positions(some_seen_from({}, surfaces, 40, random));
  const SearchWindow window{0.5, 0.5, 0.1};
  const double best = all_on_max_grids(grids, points, {}, window).best / (255.0 * 40.0);
  std::int64_t visited = 0;
  EXPECT_TRUE(branch_and_bound(grids, points, {}, window, best - 0.001, visited));
  EXPECT_FALSE(branch_and_bound(grids, points, {}, window, best + 0.001, visited));
  EXPECT_FALSE(branch_and_bound(grids, {}, {}, window, 0.0, visited));
}

}  // namespace
}  // namespace bw::slam
