// A robot with erring encoders drives through a simulated world and feeds a local grid; the truth stays at
// hand.
#pragma once

#include <functional>
#include <vector>

#include "components/mapping/costmap/local_grid.hpp"
#include "components/model/differential_drive.hpp"
#include "components/robot_base/encoder_odometry.hpp"
#include "components/world/world.hpp"

namespace bw::test {

class CostmapDrive {
 public:
  /// Encoders err as `world` says.
  CostmapDrive(const WorldOptions& world, const costmap::GridOptions& grid, std::uint64_t seed)
      : options_(world),
        world_(options_, robot_, {}, seed),
        odometry_(robot_, {}),
        legs_(options_.people.legs),
        grid_(grid) {}

  const Robot& robot() const { return robot_; }
  const World& world() const { return world_; }
  const costmap::LocalGrid& grid() const { return grid_; }
  const LaserScan& scan() const { return scan_; }
  const Pose2& X_OB() const { return X_OB_; }  ///< by odometry, at the last sweep
  double time() const { return world_.time().to_seconds(); }
  /// From odom to where things truly are now, seen from the robot.
  Pose2 X_MO() const { return world_.pose() * inverse(X_OB_); }
  std::vector<Disc> legs() const { return legs_.discs(world_.people()); }  ///< in map

  /// Goes on to the next sweep and takes it in. With `track`, people's true positions are handed in as discs.
  void next_sweep(const Twist2& twist, bool track) {
    const WheelSpeeds wheels = to_wheel_speeds(twist, robot_.wheel_separation);
    for (bool done = false; !done;) {
      world_.command({wheels.left / robot_.wheel_radius, wheels.right / robot_.wheel_radius});
      const WorldSample sample = world_.step();
      legs_.step(world_.physics_step().to_seconds(), world_.people());
      const Time now{sample.time.nanoseconds};
      if (sample.ticks) odometry_.add(now, {now, sample.ticks->left, sample.ticks->right});
      if (!sample.scan) continue;
      X_OB_ = odometry_.state().X_OB;
      std::vector<Disc> people;
      if (track) {
        for (const Person& p : world_.people()) people.push_back({inverse(X_MO()) * p.position, p.radius});
      }
      scan_ = *sample.scan;
      fault_ = grid_.add(view(now), X_OB_, robot_.outline(), people);
      done = true;
    }
  }
  SweepFault fault() const { return fault_; }

  LaserSweep view(Time now) const {
    return {.time = now,
            .X_FL = X_OB_,
            .angle_min = scan_.angle_min,
            .angle_increment = scan_.angle_increment,
            .range_min = options_.laser.range_min,
            .range_max = options_.laser.range_max,
            .ranges = scan_.ranges};
  }

 private:
  Robot robot_;
  WorldOptions options_;
  World world_;
  EncoderOdometry odometry_;
  Legs legs_;
  costmap::LocalGrid grid_;
  LaserScan scan_;
  Pose2 X_OB_;
  SweepFault fault_ = SweepFault::none;
};

}  // namespace bw::test
