// A robot that drives through a simulated building and makes a map of it, or stands somewhere in it.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "components/lab/bench/buildings/building_drive.hpp"
#include "components/lab/bench/buildings/wall_index.hpp"
#include "components/model/random.hpp"
#include "components/slam/slam.hpp"

namespace bw::slam::test {

struct BuildingDrive {
  std::vector<Scan> scans;
  std::vector<Pose2> X_OB;
  std::vector<Pose2> X_WB;  ///< where it really was, in the building
};

/// Wheels of a calibrated Kobuki, 360 beams to 12 m with 1 cm of noise, five times a second.
inline BuildingDrive drive_in(const buildings::Building& building, std::uint64_t seed, double seconds,
                              const SlamOptions& options = {}) {
  buildings::BuildingDriveOptions how;
  how.seed = seed;
  how.wheels = buildings::calibrated_wheels_of(how.base);
  how.scanner.period = Duration::milliseconds(200);
  how.longest = Duration::seconds(seconds);
  const RecordedDrive recorded = buildings::drive_through(building, how);
  const auto every =
      static_cast<std::size_t>(how.scanner.period.nanoseconds / buildings::kOdometryPeriod.nanoseconds);
  BuildingDrive drive;
  for (std::size_t k = 0; k < recorded.scans.size(); ++k) {
    const ScanSample& sample = recorded.scans[k];
    LaserSweep sweep{.time = sample.time,
                     .X_FL = {},
                     .angle_min = static_cast<double>(sample.geometry.angle_min),
                     .angle_increment = static_cast<double>(sample.geometry.angle_increment),
                     .range_min = static_cast<double>(sample.geometry.range_min),
                     .range_max = static_cast<double>(sample.geometry.range_max),
                     .ranges = sample.ranges};
    drive.scans.push_back(scan_of(sweep, options));
    const ReferencePose& truth = recorded.truth[k * every];
    drive.X_OB.push_back(recorded.odometry[k * every].X_OB);
    drive.X_WB.push_back({truth.position.x(), truth.position.y(), *truth.heading});
  }
  return drive;
}

/// The same scanner, standing at X_WB.
inline Scan scan_at(const buildings::WallIndex& walls, const Pose2& X_WB, Random& random,
                    const SlamOptions& options = {}) {
  constexpr int kBeams = 360;
  constexpr double kFarthest = 12.0;
  LaserSweep sweep{.angle_min = -std::numbers::pi,
                   .angle_increment = 2.0 * std::numbers::pi / kBeams,
                   .range_min = 0.1,
                   .range_max = kFarthest};
  std::vector<float> ranges;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = X_WB.theta + sweep.angle_min + i * sweep.angle_increment;
    const double hit = walls.ray_hit(X_WB.position(), direction(angle), kFarthest);
    ranges.push_back(hit >= kFarthest ? std::numeric_limits<float>::infinity()
                                      : static_cast<float>(hit + random.normal(0.0, 0.01)));
  }
  sweep.ranges = ranges;
  return scan_of(sweep, options);
}

/// Scans `first` to `last` of a drive, with all work on loops done after each; X_MB as it is told.
inline std::vector<Pose2> map_along(Slam& slam, const BuildingDrive& drive, std::size_t first,
                                    std::size_t last) {
  std::vector<Pose2> told;
  for (std::size_t k = first; k < last; ++k) {
    const Tracked tracked = slam.add(drive.scans[k], drive.X_OB[k]);
    while (slam.advance()) {
    }
    told.push_back(slam.pose(tracked.placement));
  }
  return told;
}

}  // namespace bw::slam::test
