// A laser that is covered while the robot drives, and one that sees little because the place is wide. Closed
// loop: room -> sweeps at 10 Hz
// -> CollisionMonitor -> a robot that speeds up with 1 m/s^2 and brakes with 2.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/safety/collision_monitor.hpp"
#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

/// A square room around the origin; the robot drives along +x at y = 0.
class Room {
 public:
  Room(double half, double range_max, double x) : half_(half), range_max_(range_max), x_(x) {}

  /// [m] from the rim of the robot to the wall ahead
  double gap() const { return half_ - x_ - Robot{}.radius; }
  double speed() const { return v_; }
  double x() const { return x_; }
  /// From now on beams from `from` to `to` [rad] read +inf.
  void cover(double from, double to) {
    from_ = from;
    to_ = to;
  }
  Verdict step(double wanted) {
    now_ = now_ + Duration::milliseconds(20);
    monitor_.odometry(now_, {x_, 0.0, 0.0}, {v_, 0.0});
    if (cycle_++ % 5 == 0) sweep();
    const Verdict verdict = monitor_.judge(now_, {wanted, 0.0});
    v_ += std::clamp(verdict.allowed.v - v_, -2.0 * 0.02, 1.0 * 0.02);
    x_ += v_ * 0.02;
    return verdict;
  }

 private:
  void sweep() {
    Sweep sweep{{.angle_min = -std::numbers::pi,
                 .angle_increment = std::numbers::pi / 360.0,
                 .range_min = 0.05,
                 .range_max = range_max_},
                std::vector<float>(720, kInfinity)};
    for (int i = 0; i < 720; ++i) {
      const double bearing = sweep.angle_min + i * sweep.angle_increment;
      const Vector2 beam = direction(bearing);
      const double range = std::min((half_ - std::copysign(x_, x_ * beam.x())) / std::abs(beam.x()),
                                    half_ / std::abs(beam.y()));
      const bool is_covered = bearing >= from_ && bearing < to_;
      if (range < range_max_ && !is_covered)
        sweep.ranges[static_cast<std::size_t>(i)] = static_cast<float>(range + 0.005 * random_.normal());
    }
    sweep.time = now_;
    monitor_.sweep(now_, sweep.view());
  }

  double half_, range_max_, x_;
  double v_ = 0.0;
  double from_ = 0.0, to_ = 0.0;
  int cycle_ = 0;
  Time now_ = Time::seconds(10.0);
  Random random_{5};
  CollisionMonitor monitor_{Robot{}, {}};
};

// The front third at once, 3.3 m before a wall. From 1 m/s with 2 m/s^2 it is down to creep_speed within 0.5
// s and a sweep.
TEST(CoveredLaser, TheFrontThirdIsCreptInto) {
  Room room(6.0, 20.0, -1.0);
  while (room.gap() > 3.3) room.step(1.0);
  EXPECT_NEAR(room.speed(), 1.0, 1e-9);
  room.cover(-std::numbers::pi / 3.0, std::numbers::pi / 3.0);
  double t = 0.0;
  for (; t < 60.0 && room.gap() > 0.0; t += 0.02) {
    const Verdict verdict = room.step(1.0);
    if (t > 0.65) {
      ASSERT_LE(room.speed(), 0.1 + 1e-9) << t;
      ASSERT_EQ(verdict.cause, kSight) << t;
    }
  }
  EXPECT_GT(t, 25.0);  // (3.3 m - 0.35 m of braking) / 0.1 m/s
}

// A hand that slides over the front third within 0.3, 3 and 10 s.
TEST(CoveredLaser, AHandThatSlidesOverTheFrontThirdIsCreptInto) {
  for (const double seconds : {0.3, 3.0, 10.0}) {
    Room room(8.0, 20.0, -7.0);
    while (room.speed() < 1.0) room.step(1.0);
    const double third = 2.0 * std::numbers::pi / 3.0;
    for (double t = 0.0; t < 150.0 && room.gap() > 0.0; t += 0.02) {
      room.cover(-0.5 * third, -0.5 * third + third * std::min(1.0, t / seconds));
      room.step(1.0);
    }
    EXPECT_LE(room.speed(), 0.1 + 1e-9) << seconds;
  }
}

// 30 x 30 m and a laser of 12 m: ahead nothing is seen most of the way, and nothing vanished.
TEST(CoveredLaser, ABareHallIsDrivenAtFullSpeed) {
  Room room(15.0, 12.0, -14.0);
  double t = 0.0;
  for (; t < 60.0 && room.gap() > 0.7; t += 0.02) {
    const Verdict verdict = room.step(1.0);
    if (t > 1.5) {
      ASSERT_EQ(verdict.cause, "") << "at " << room.x();
      ASSERT_NEAR(room.speed(), 1.0, 1e-9) << "at " << room.x();
    }
  }
  EXPECT_NEAR(t, 28.0 + 0.5, 0.5);  // 28 m at 1 m/s, and 0.5 s more to reach it
}

}  // namespace
}  // namespace bw::safety
