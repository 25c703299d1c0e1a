// Figures beside the truth by poses and maps whose errors are known; a drive twice round a square of
// corridors.
#include "components/lab/bench/slam/truth_score.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/lab/bench/slam/bench_slam.hpp"
#include "components/lab/bench/slam/map_score.hpp"

namespace bw::slam {
namespace {

// Corners of a square; of the estimated ones two that face each other lie 0.1 m farther out, the others 0.1 m
// farther in, and all are turned and moved. No turn and no shift takes that away: 0.1 m.
TEST(TrajectoryError, IsWhatTurnAndShiftLeave) {
  const std::vector<Pose2> truth = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const Pose2 X{5.0, -2.0, 1.2};
  std::vector<Pose2> estimated;
  for (std::size_t k = 0; k < 4; ++k) {
    const double size = k % 2 == 0 ? 1.1 : 0.9;
    estimated.push_back(X * Pose2{size * truth[k].x, size * truth[k].y, 0.0});
  }
  const TrajectoryError error = trajectory_error(estimated, truth);
  EXPECT_NEAR(error.rms, 0.1, 1e-12);
  EXPECT_NEAR(error.largest, 0.1, 1e-12);
  EXPECT_EQ(trajectory_error({}, {}).rms, 0.0);
}

OccupancyGrid wall_at(int column) {
  OccupancyGrid grid;
  grid.resolution = 0.1;
  grid.width = 20;
  grid.height = 10;
  grid.cells.assign(200, OccupancyGrid::kFree);
  for (int row = 0; row < 10; ++row) grid.cells[grid.index(column, row)] = OccupancyGrid::kOccupied;
  return grid;
}

// One cell off is right, two are not; what is drawn beside it halves the precision and not the recall: F1 of
// 1/2 and 1 is 2/3.
TEST(MapScore, ForgivesOneCell) {
  EXPECT_EQ(score_map(wall_at(5), wall_at(6), {}).f1(), 1.0);
  EXPECT_EQ(score_map(wall_at(5), wall_at(7), {}).f1(), 0.0);
  OccupancyGrid both = wall_at(5);
  for (int row = 0; row < 10; ++row) both.cells[both.index(15, row)] = OccupancyGrid::kOccupied;
  const MapScore score = score_map(both, wall_at(5), {});
  EXPECT_EQ(score.precision(), 0.5);
  EXPECT_EQ(score.recall(), 1.0);
  EXPECT_NEAR(score.f1(), 2.0 / 3.0, 1e-12);
  EXPECT_EQ(score_map(wall_at(5), wall_at(7), {0.2, 0.0, 0.0}).f1(), 1.0) << "frames that lie 0.2 m apart";
}

// 0.2 m off at a deviation of 0.1 m: a squared distance of 4, within the quantile; 0.3 m: 9, beyond. Mean 6.5
// over 3. The first scan is what the others are relative to.
TEST(Consistency, IsTheMeanSquaredDistanceOverThree) {
  SlamReplay replayed{SlamOptions{}};
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
  replayed.scans = {{.told = {}}, {.told = {1.2, 0, 0}}, {.told = {2, 0.3, 0}}};
  for (ReplayedScan& scan : replayed.scans) scan.covariance = covariance;
  const double quarter = 0.5 * std::numbers::pi;
  const std::vector<Pose2> truth = {{7, 7, quarter}, {7, 8, quarter}, {7, 9, quarter}};
  const Consistency result = consistency(replayed, truth);
  EXPECT_NEAR(result.anees, 6.5 / 3.0, 1e-9);
  EXPECT_NEAR(result.share_in_95, 0.5, 1e-12);
}

void add_box(std::vector<Segment>& walls, const Vector2& low, const Vector2& high) {
  const Vector2 right{high.x(), low.y()};
  const Vector2 left{low.x(), high.y()};
  for (const auto& [a, b] : {std::pair{low, right}, {right, high}, {high, left}, {left, low}})
    walls.push_back({a, b});
}

/// Corridors 2 m wide about a block, with cupboards, twice round: 64 m.
buildings::Building corridors() {
  buildings::Building building;
  building.name = "square";
  add_box(building.walls, {-6, -5}, {6, 5});
  add_box(building.walls, {-4, -3}, {4, 3});
  add_box(building.walls, {1, -5}, {2.2, -4.7});
  add_box(building.walls, {-6, 1}, {-5.7, 1.8});
  add_box(building.walls, {5.6, -1}, {6, -0.2});
  add_box(building.walls, {-2, 4.6}, {-1, 5});
  building.route = {{-3, -4}, {5, -4}, {5, 4},  {-5, 4},  {-5, -4},
                    {5, -4},  {5, 4},  {-5, 4}, {-5, -4}, {-3, -4}};
  return building;
}

class RoundTheSquare : public ::testing::Test {
 protected:
  static buildings::BuildingDriveOptions options() {
    buildings::BuildingDriveOptions options;
    options.wheels = buildings::calibrated_wheels_of(options.base);
    return options;
  }
};

// The second round is a revisit wherever it is more than 20 m on, half of the drive less its last 10 s, each
// second.
TEST_F(RoundTheSquare, IsDrivenWithoutAFault) {
  const SlamDrive drive = drive_slam(corridors(), options(), {});
  EXPECT_NEAR(drive.way, 70.0, 8.0) << "corners are rounded";
  EXPECT_LT(drive.trajectory.rms, 0.03);
  EXPECT_GT(drive.map.f1(), 0.97);
  EXPECT_GT(drive.map_at_truth.f1(), 0.97);
  EXPECT_GT(drive.loops.loops, 5U);
  EXPECT_EQ(drive.loops.wrong, 0U);
  EXPECT_EQ(drive.loops.gross, 0U);
  EXPECT_GT(drive.revisits, 40U);
  EXPECT_EQ(drive.missed, 0U);
  EXPECT_LT(drive.consistency.anees, 3.0);
}

// A truth that jumps by 2 m half way makes liars of all loops from one half to the other, and of each revisit
// of the first half; loops within a half stay right.
TEST_F(RoundTheSquare, BesideAFalseTruthIsWrong) {
  const buildings::Building building = corridors();
  const RecordedDrive drive = buildings::drive_through(building, options());
  RecordedDrive moved = drive;
  for (std::size_t i = moved.truth.size() / 2; i < moved.truth.size(); ++i)
    moved.truth[i].position.x() += 2.0;
  const TruthOfScans right(drive);
  const TruthOfScans wrong(moved);
  const buildings::WallIndex no_walls({{{100, 100}, {101, 100}}});
  Revisits revisits(wrong, no_walls);
  const SlamReplay replayed =
      replay(drive, {}, {.after_scan = [&](const SlamReplay& r) { revisits.look(r); }});
  EXPECT_EQ(loop_faults(replayed.slam, right).wrong, 0U);
  const LoopFaults faults = loop_faults(replayed.slam, wrong);
  EXPECT_GT(faults.gross, 0U);
  EXPECT_LT(faults.gross, faults.loops);
  EXPECT_EQ(faults.gross, faults.wrong);
  EXPECT_EQ(faults.gross_kept, faults.gross) << "the graph believes them";
  EXPECT_GT(revisits.count(), 0U);
  EXPECT_GT(revisits.missed(), 0.9 * static_cast<double>(revisits.count()))
      << "first and second visit in one half: right";
}

}  // namespace
}  // namespace bw::slam
