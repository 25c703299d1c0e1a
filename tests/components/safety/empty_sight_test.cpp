// A sweep that hits nothing: an open place, or a laser whose light fails.
#include "components/safety/empty_sight.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

const Sweep kNothing = sweep_of({}, kInfinity);

bool believes(EmptySight& sight, const Sweep& sweep, const SweepOptions& options = {}) {
  CheckedSweep checked = check_sweep(sweep.view(), options);
  EXPECT_EQ(checked.fault, SweepFault::none);
  return sight.believes(sweep.view(), {}, checked);
}

/// How many beams are dark once `sweep` follows on what the sight has seen, with the robot at X_OB.
std::ptrdiff_t dark(EmptySight& sight, const Sweep& sweep, const Pose2& X_OB = {}) {
  CheckedSweep checked = check_sweep(sweep.view(), {});
  EXPECT_TRUE(sight.believes(sweep.view(), X_OB, checked));
  return std::count(checked.dark.begin(), checked.dark.end(), true);
}

/// A wall all round, `degrees` of it right ahead without returns.
Sweep covered(double degrees, float background = 3.3F) {
  Sweep sweep = sweep_of({}, background);
  const int half = static_cast<int>(std::lround(0.5 * degrees / 270.0 * 719.0));
  for (int i = 360 - half; i < 360 + half; ++i) sweep.ranges[static_cast<std::size_t>(i)] = kInfinity;
  return sweep;
}

/// Whether an empty sweep is believed right after one among `discs`.
bool believes_after(const std::vector<Disc>& discs, const SweepOptions& options = {}) {
  EmptySight sight(options);
  EXPECT_TRUE(believes(sight, sweep_of(discs, kInfinity), options));
  return believes(sight, kNothing, options);
}

TEST(EmptySight, AnOpenPlaceIsBelievedFromTheStartOn) {
  EmptySight sight({});
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(believes(sight, kNothing));
  EXPECT_FALSE(sight.has_seen());
}

TEST(EmptySight, WallsDoNotVanish) {
  EmptySight sight({});
  EXPECT_TRUE(believes(sight, sweep_of({}, 8.0F)));
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(believes(sight, kNothing));  // however often it is said
  EXPECT_TRUE(believes(sight, sweep_of({}, 8.0F)));
  EXPECT_TRUE(sight.has_seen());
}

// Two legs of 0.14 m: at 2 m 2 * 2 * asin(0.07 / 2) / 0.376 degrees = 21 beams, at 6 m 7.
TEST(EmptySight, NorDoesSomebodyNearButSomebodyFarMay) {
  EXPECT_FALSE(believes_after({{{2.0, 0.1}, 0.07}, {{2.0, -0.1}, 0.07}}));
  EXPECT_TRUE(believes_after({{{6.0, 0.1}, 0.07}, {{6.0, -0.1}, 0.07}}));
}

// The field ends at 135 degrees to either side, the range at 20 m.
TEST(EmptySight, ThingsLeaveByTheEdgesOfTheFieldAndTheEndOfTheRange) {
  const auto at_angle = [](double degrees) {
    return std::vector<Disc>{{2.0 * direction(degrees * std::numbers::pi / 180.0), 0.3}};
  };
  EXPECT_TRUE(believes_after(at_angle(-130.0)));
  EXPECT_FALSE(believes_after(at_angle(-90.0)));
  EXPECT_TRUE(believes_after({{{22.0, 0.0}, 2.5}}));   // its rim at 19.5 m
  EXPECT_FALSE(believes_after({{{18.0, 0.0}, 2.5}}));  // at 15.5 m
}

TEST(EmptySight, ALaserThatLooksAllAroundHasNoEdges) {
  EmptySight sight({});
  Sweep sweep = sweep_of({}, 3.0F);
  sweep.angle_min = -std::numbers::pi;
  sweep.angle_increment = 2.0 * std::numbers::pi / 720.0;
  sweep.angle_max = std::numbers::pi - sweep.angle_increment;
  for (std::size_t i = 30; i < 720; ++i)
    sweep.ranges[i] = kInfinity;  // a wall right behind, 15 degrees of it
  EXPECT_TRUE(believes(sight, sweep));
  std::fill(sweep.ranges.begin(), sweep.ranges.end(), kInfinity);
  EXPECT_FALSE(believes(sight, sweep));
}

TEST(EmptySight, WhoSaysThatThePlaceIsOpenIsBelieved) {
  EmptySight sight({});
  EXPECT_TRUE(believes(sight, sweep_of({}, 8.0F)));
  EXPECT_FALSE(believes(sight, kNothing));
  sight.forget();
  EXPECT_TRUE(believes(sight, kNothing));

  SweepOptions open_floor;
  open_floor.min_returns = 0;
  EXPECT_TRUE(believes_after({{{2.0, 0.0}, 1.0}}, open_floor));
}

// The front third is covered: 120 degrees, 320 beams of 0.3755 degrees. What lies 0.3 rad from what is still
// hit may be somebody who walked; the points of the 85.6 degrees between vanished, and all beams within 0.3
// rad of one of these are dark.
TEST(EmptySight, ACoveredThirdIsDarkUntilSomethingIsHitThereAgain) {
  EmptySight sight({});
  EXPECT_EQ(dark(sight, sweep_of({}, 3.3F)), 0);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(dark(sight, covered(120.0)), 320);
  EXPECT_EQ(dark(sight, sweep_of({}, 3.3F)), 0);
  for (int i = 0; i < 3; ++i) dark(sight, covered(120.0));
  sight.forget();
  EXPECT_EQ(dark(sight, covered(120.0)), 0) << "somebody said that the place is open";
}

/// At 10 Hz, `seconds` after the beginning.
Sweep at(double seconds, Sweep sweep) {
  sweep.time = Time::seconds(seconds);
  return sweep;
}

// A hand slides over the laser: 0.2 rad/s, 0.02 rad from sweep to sweep, from one side to 120 degrees. Beams
// that stood are missed once five are gone, three beams wide of the last hit: after half a second. Something
// is hit again where it is taken away.
TEST(EmptySight, AHandThatSlidesOverTheLaserIsDarkHoweverSlow) {
  for (const double rate : {0.02, 0.2, 1.0}) {  // [rad/s]
    EmptySight sight({});
    int step = 0;
    for (; step < 10; ++step) EXPECT_EQ(dark(sight, at(0.1 * step, sweep_of({}, 3.3F))), 0);
    const double seconds = 2.0 / rate;
    const int begin = step;
    for (; step < begin + static_cast<int>(10.0 * seconds); ++step) {
      Sweep sweep = sweep_of({}, 3.3F);
      const double angle = rate * 0.1 * (step - begin);
      const auto beams = static_cast<std::ptrdiff_t>(angle / sweep.angle_increment);
      std::fill_n(sweep.ranges.begin() + 100, beams, kInfinity);
      const std::ptrdiff_t seen_dark = dark(sight, at(0.1 * step, sweep));
      if (beams > 10) {
        ASSERT_GE(seen_dark, beams - 2) << rate << " rad/s, " << angle << " rad";
      }
    }
    EXPECT_EQ(dark(sight, at(0.1 * step, sweep_of({}, 3.3F))), 0);
  }
}

/// Along y = 0 and past straight walls that end, while odometry errs: it measures v (1 + scale), and rotates
/// by `drift` [rad/s] and `slip` of what the robot rotates, on an arc in closed form.
struct Drive {
  std::vector<double> walls;  // [m] their y; each from x = -8 to 2
  double x = 0.0;             // [m] at the start
  double v = 0.0;             // [m/s]
  double omega = 0.0;         // [rad/s]
  double drift = 0.01;
  double slip = 0.0;
  double scale = 0.0;

  Pose2 truth(double t) const { return arc(v, omega, t, x); }
  Pose2 odometry(double t) const { return arc(v * (1.0 + scale), omega * (1.0 + slip) + drift, t, 0.0); }
  /// Beams from `from` to `to` [rad, laser] are covered.
  Sweep sweep(double t, Random& random, double from = 0.0, double to = 0.0) const {
    const Pose2 X_WB = truth(t);
    Sweep sweep = sweep_of({}, kInfinity);
    for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
      const double angle = sweep.angle_min + sweep.angle_increment * static_cast<double>(i);
      const Vector2 beam = direction(angle + X_WB.theta);
      for (const double y : walls) {
        const double range = (y - X_WB.y) / beam.y();
        const double end = X_WB.x + range * beam.x();
        if (range > 0.0 && range < sweep.range_max && end > -8.0 && end < 2.0)
          sweep.ranges[i] = static_cast<float>(range + 0.01 * random.normal());
      }
      if (angle >= from && angle < to) sweep.ranges[i] = kInfinity;
    }
    return at(t, sweep);
  }

 private:
  static Pose2 arc(double v, double omega, double t, double x) {
    const double theta = omega * t;
    if (omega == 0.0) return {x + v * t, 0.0, 0.0};
    return {x + v / omega * std::sin(theta), v / omega * (1.0 - std::cos(theta)), theta};
  }
};

// Odometry of wheels that differ by 0.4 % rotates by 0.01 rad/s at 1 m/s, 0.08 rad in 8 s: twelve beams, all
// of which look past the end of the wall at what stood there. No cover: what is left of the wall has turned
// as well. Towards the end, away from it, at rest, and on the spot with wheels that slip by 5 %.
TEST(EmptySight, AWallsEndIsNotDarkThoughOdometryTurnsAway) {
  const std::vector<double> hall = {-3.0, 3.0};
  for (const Drive& drive :
       {Drive{hall, -6.0, 1.0}, Drive{hall, -6.0, 1.0, 0.0, -0.01}, Drive{{3.0}, -6.0, 1.0, 0.0, -0.01},
        Drive{{3.0}, -6.0, 1.0}, Drive{hall, -1.5}, Drive{{3.0}, -1.5}, Drive{hall, -1.5, 0.0, 0.0, -0.01},
        Drive{hall, 1.0, -0.5}, Drive{hall, 1.0, -0.5, 0.0, -0.01}, Drive{hall, -1.5, 0.0, 0.5, 0.0, 0.05},
        Drive{{3.0}, -1.5, 0.0, 0.5, 0.0, -0.05}}) {
    EmptySight sight({});
    Random random{7};
    int i = 0;
    while (i < 80 && dark(sight, drive.sweep(0.1 * i, random), drive.odometry(0.1 * i)) == 0) ++i;
    EXPECT_EQ(i, 80) << drive.walls.size() << " walls, v " << drive.v << ", omega " << drive.omega
                     << ", drift " << drive.drift;
  }
}

// From (1, 0) back to (-3.5, 0): places that were beams of 3.2 m are seen from 6.3 m, several in one beam. Then
// odometry turns by 0.022 rad at once, 3.4 beams: of the wall's end one or two beams look past it by more
// than two, and five would be a thing.
TEST(EmptySight, WhatIsLostCountsByBeamsHoweverManyPointsAreOfOne) {
  for (const double turn : {0.022, -0.022}) {
    const Drive drive{{-3.0, 3.0}, 1.0, -0.5, 0.0, 0.0};
    EmptySight sight({});
    Random random{7};
    for (int i = 0; i < 92; ++i) {
      const Pose2 X_OB = drive.odometry(0.1 * i) * Pose2{0.0, 0.0, i < 90 ? 0.0 : turn};
      ASSERT_EQ(dark(sight, drive.sweep(0.1 * i, random), X_OB), 0) << i << ", " << turn;
    }
  }
}

// A cover slides over the same wall, from its end on or from the middle, at 0.01 rad/s, as fast as odometry
// turns, with it or against it. Five beams that stood are gone, and two beside a hit on either side: nine;
// noise costs three more. After twelve beams, 4.5 degrees, all of it is dark.
TEST(EmptySight, ACoverOfAWallIsDarkThoughOdometryTurnsAsFast) {
  for (const double drift : {0.01, -0.01}) {
    for (const bool is_end : {true, false}) {
      const Drive drive{{-3.0, 3.0}, -1.5, 0.0, 0.0, drift};
      const double end = std::atan2(3.0, 3.5);  // of the wall, from (-1.5, 0) to (2, 3)
      EmptySight sight({});
      Random random{7};
      int i = 0;
      for (; i < 20; ++i) EXPECT_EQ(dark(sight, drive.sweep(0.1 * i, random), drive.odometry(0.1 * i)), 0);
      for (int k = 0; k < 200; ++k, ++i) {
        const double grown = 0.01 * 0.1 * k;
        const double from = is_end ? end : end + 0.4;
        const Sweep sweep = drive.sweep(0.1 * i, random, from, from + grown);
        const std::ptrdiff_t seen_dark = dark(sight, sweep, drive.odometry(0.1 * i));
        const double beams = grown / sweep.angle_increment;
        if (beams > 12.0) {
          ASSERT_GE(seen_dark, beams - 2.0) << is_end << " " << drift << " " << grown;
        }
      }
    }
  }
}

// Who stood for 3 s in an open place and walks away, aside or farther off, has not vanished.
TEST(EmptySight, WhoStoodAndWalksAwayInAnOpenPlaceHasNotVanished) {
  for (const Vector2& speed : {Vector2(0.0, 1.3), Vector2(1.3, 0.0), Vector2(0.9, -0.9), Vector2(0.0, 0.4)}) {
    EmptySight sight({});
    for (int i = 0; i < 80; ++i) {
      const double walked = std::max(0.0, 0.1 * i - 3.0);
      const Vector2 p = Vector2(1.5, 0.0) + walked * speed;
      EXPECT_EQ(
          dark(sight, at(0.1 * i, sweep_of({{p, 0.07}, {p + Vector2(0.0, 0.3), 0.07}, {{-3.0, 0.5}, 0.4}},
                                           kInfinity))),
          0)
          << i << " towards " << speed.transpose();
    }
  }
}

TEST(EmptySight, AnOpenDoorSeenFromTheStartIsNotDark) {
  EmptySight sight({});
  for (int i = 0; i < 5; ++i) EXPECT_EQ(dark(sight, covered(60.0)), 0);
}

// A robot that rotates by 0.2 rad from sweep to sweep sees the same third empty from the start on, elsewhere
// in its field.
TEST(EmptySight, WhatTheRobotTurnsAwayFromHasNotVanished) {
  EmptySight sight({});
  for (int i = 0; i < 12; ++i) {
    Sweep sweep = sweep_of({}, 3.3F);
    for (std::size_t k = 0; k < 720; ++k) {
      const double bearing =
          wrap_angle(sweep.angle_min + sweep.angle_increment * static_cast<double>(k) + 0.2 * i);
      if (std::abs(bearing) < 1.0) sweep.ranges[k] = kInfinity;
    }
    EXPECT_EQ(dark(sight, sweep, {0.0, 0.0, 0.2 * i}), 0) << i;
  }
}

// In an open place nothing is behind who walks: 1.5 m/s past the robot, 0.8 m before it, and out of the
// range.
TEST(EmptySight, WhoWalksPastInAnOpenPlaceHasNotVanished) {
  EmptySight sight({});
  for (int i = 0; i < 60; ++i) {
    const double y = -4.0 + 0.15 * i;
    EXPECT_EQ(
        dark(sight, sweep_of({{{0.8, y}, 0.07}, {{0.8, y + 0.3}, 0.07}, {{-3.0, 0.5}, 0.4}}, kInfinity)), 0)
        << i;
  }
}

}  // namespace
}  // namespace bw::safety
