// The likelihood field against brute force, and the end points of beams against geometry by hand.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/files/map_file.hpp"
#include "components/localization/laser/beam_ends.hpp"
#include "components/localization/laser/likelihood_field.hpp"
#include "components/model/random.hpp"

namespace bw::localization {
namespace {

struct Cell {
  int column;
  int row;
};

std::vector<Cell> obstacles(const OccupancyGrid& map) {
  std::vector<Cell> cells;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) >= 65) cells.push_back({column, row});
    }
  }
  return cells;
}

// Distance between centres [m], every obstacle looked at.
double brute_force(const OccupancyGrid& map, const std::vector<Cell>& occupied, int column, int row) {
  std::int64_t squared = std::numeric_limits<std::int64_t>::max();
  for (const Cell& cell : occupied) {
    const std::int64_t dx = cell.column - column;
    const std::int64_t dy = cell.row - row;
    squared = std::min(squared, dx * dx + dy * dy);
  }
  return std::sqrt(static_cast<double>(squared)) * map.resolution;
}

void expect_cell(const OccupancyGrid& map, const std::vector<Cell>& occupied, const LikelihoodField& field,
                 int column, int row) {
  const LikelihoodFieldOptions& o = field.options();
  const Vector2 p = map.center(column, row);
  const double d = std::min(brute_force(map, occupied, column, row), o.kLaserLikelihoodMaxDist);
  ASSERT_NEAR(field.distance(p.x(), p.y()), d, 1e-6) << column << " " << row;
  const bool inside = map.contains(column, row);
  const bool known = inside && map.at(column, row) >= 0;
  ASSERT_EQ(field.known(p.x(), p.y()), known) << column << " " << row;
  double likelihood =
      o.z_hit * std::exp(-d * d / (2.0 * o.sigma_hit * o.sigma_hit)) + o.z_rand / o.kLaserMaxRange;
  if (!known) likelihood = std::max(likelihood, 1.0 / o.kLaserMaxRange);
  ASSERT_NEAR(field.log_likelihood(p.x(), p.y()), std::log(likelihood), 1e-5) << column << " " << row;
}

OccupancyGrid random_grid(Random& random) {
  OccupancyGrid map;
  map.resolution = random.uniform(0.02, 0.2);
  map.origin = {random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0)};
  map.width = 1 + static_cast<int>(random.uniform(0.0, 40.0));
  map.height = 1 + static_cast<int>(random.uniform(0.0, 40.0));
  const double occupied = random.uniform(0.0, 0.1);
  const double unknown = random.uniform(0.0, 0.5);
  for (int i = 0; i < map.width * map.height; ++i) {
    const double u = random.uniform();
    map.cells.push_back(u < occupied             ? OccupancyGrid::kOccupied
                        : u < occupied + unknown ? OccupancyGrid::kUnknown
                                                 : OccupancyGrid::kFree);
  }
  return map;
}

TEST(LikelihoodField, EqualsBruteForceOnRandomGridsAndTheirSurroundings) {
  Random random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const OccupancyGrid map = random_grid(random);
    const std::vector<Cell> occupied = obstacles(map);
    if (occupied.empty()) continue;
    LikelihoodFieldOptions options;
    options.sigma_hit = random.uniform(0.05, 0.3);
    const LikelihoodField field(map, options);
    const int border = std::min(5, static_cast<int>(3.0 * options.sigma_hit / map.resolution));
    for (int row = -border; row < map.height + border; ++row) {
      for (int column = -border; column < map.width + border; ++column) {
        expect_cell(map, occupied, field, column, row);
      }
    }
  }
}

class RealMap : public testing::TestWithParam<const char*> {};

TEST_P(RealMap, FieldEqualsBruteForce) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set: recorded maps are not at hand";
  const OccupancyGrid map = load_map(std::filesystem::path(shared) / "data" / GetParam());
  const std::vector<Cell> occupied = obstacles(map);
  const LikelihoodField field(map, {});
  // A full check costs cells times obstacles; beyond 2e9 a random sample of the cells.
  const double work = static_cast<double>(map.cells.size()) * static_cast<double>(occupied.size());
  const double share = std::min(1.0, 2e9 / work);
  Random random(2);
  int checked = 0;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (share < 1.0 && random.uniform() >= share) continue;
      expect_cell(map, occupied, field, column, row);
      ++checked;
    }
  }
  RecordProperty("cells", checked);
  EXPECT_GE(checked, 10000);
}
INSTANTIATE_TEST_SUITE_P(Maps, RealMap,
                         testing::Values("map_tb3_sandbox/tb3_sandbox.yaml",
                                         "map_small_house/small_house.yaml", "map_warehouse/warehouse.yaml"));

TEST(LikelihoodField, FarOutsideAndNoNumberSayWhatTheUnknownSays) {
  OccupancyGrid map{.resolution = 0.1, .width = 3, .height = 1, .cells = {0, 100, 0}};
  const LikelihoodField field(map, {});
  const double nothing = std::log(1.0 / field.options().kLaserMaxRange);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {-1e300, -50.0, 50.0, 1e300, infinity, -infinity, nan}) {
    EXPECT_NEAR(field.log_likelihood(x, 0.05), nothing, 1e-6) << x;
    EXPECT_NEAR(field.log_likelihood(0.05, x), nothing, 1e-6) << x;
    EXPECT_FALSE(field.known(x, x)) << x;
  }
}

TEST(LikelihoodField, AMapWithoutObstaclesOrCellsIsFarFromEverything) {
  OccupancyGrid map{.resolution = 0.1, .width = 2, .height = 2, .cells = {0, 0, 0, 0}};
  const LikelihoodField field(map, {});
  EXPECT_DOUBLE_EQ(field.distance(0.1, 0.1), field.options().kLaserLikelihoodMaxDist);
  const LikelihoodField none;
  EXPECT_FALSE(none.known(0.0, 0.0));
}

TEST(LikelihoodField, RefusesWhatIsNoGrid) {
  OccupancyGrid map{.resolution = 0.1, .width = 2, .height = 2, .cells = {0, 0, 0}};
  EXPECT_THROW(LikelihoodField(map, {}), std::runtime_error);
  map.cells.push_back(0);
  map.resolution = 0.0;
  EXPECT_THROW(LikelihoodField(map, {}), std::runtime_error);
  map.resolution = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(LikelihoodField(map, {}), std::runtime_error);
  map.resolution = 0.1;
  map.origin.x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(LikelihoodField(map, {}), std::runtime_error);
}

TEST(BeamEnds, AreWhereGeometryPutsThem) {
  // Three beams right, ahead and left of a scanner 0.2 m ahead of the base, rotated by a quarter.
  const std::vector<float> ranges{1.0F, 2.0F, 3.0F};
  const LaserSweep sweep{.X_FL = {0.2, 0.0, std::numbers::pi / 2},
                         .angle_min = -std::numbers::pi / 2,
                         .angle_increment = std::numbers::pi / 2,
                         .range_min = 0.1,
                         .range_max = 10.0,
                         .ranges = ranges};
  const BeamEnds ends = beam_ends(sweep, 60);
  ASSERT_EQ(ends.size(), 3U);
  EXPECT_NEAR(ends.x[0], 1.2F, 1e-6F);
  EXPECT_NEAR(ends.y[0], 0.0F, 1e-6F);
  EXPECT_NEAR(ends.x[1], 0.2F, 1e-6F);
  EXPECT_NEAR(ends.y[1], 2.0F, 1e-6F);
  EXPECT_NEAR(ends.x[2], -2.8F, 1e-6F);
  EXPECT_NEAR(ends.y[2], 0.0F, 1e-6F);
}

TEST(BeamEnds, NoReturnIsNoEndAndItsNeighbourStandsInForIt) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<float> ranges{
      kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN(), 10.0F, 0.05F, -1.0F, 4.0F, 0.0F};
  const LaserSweep sweep{.angle_increment = 0.1, .range_min = 0.1, .range_max = 10.0, .ranges = ranges};
  EXPECT_EQ(beam_ends(sweep, 60).size(), 1U);   // only 4 m is a return
  const BeamEnds halves = beam_ends(sweep, 2);  // beams 0 to 3: none; 4 to 7: the sixth
  ASSERT_EQ(halves.size(), 1U);
  EXPECT_NEAR(halves.x[0], 4.0F * std::cos(0.6F), 1e-5F);
  EXPECT_EQ(beam_ends(sweep, 0).size(), 0U);
  EXPECT_EQ(beam_ends({}, 60).size(), 0U);
}

TEST(BeamEnds, ZeroIsNoEndWhateverRangeMinIs) {
  const std::vector<float> ranges{0.0F, 2.0F};
  EXPECT_EQ(beam_ends({.angle_increment = 0.1, .range_max = 10.0, .ranges = ranges}, 60).size(), 1U);
}

TEST(BeamEnds, OneOutOfEachPartAndNeverMoreThanAsked) {
  const std::vector<float> ranges(720, 1.0F);
  const LaserSweep sweep{
      .angle_increment = 2.0 * std::numbers::pi / 720, .range_max = 10.0, .ranges = ranges};
  const BeamEnds ends = beam_ends(sweep, 60);
  ASSERT_EQ(ends.size(), 60U);
  for (std::size_t i = 0; i < ends.size(); ++i) {  // 12 beams of half a degree each, from the seventh on
    const double angle = (6.0 + 12.0 * static_cast<double>(i)) * std::numbers::pi / 360.0;
    EXPECT_NEAR(ends.x[i], std::cos(angle), 1e-5);
    EXPECT_NEAR(ends.y[i], std::sin(angle), 1e-5);
  }
}

}  // namespace
}  // namespace bw::localization
