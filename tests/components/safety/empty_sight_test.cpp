// A sweep that hits nothing: an open place, or a laser whose light fails.
#include "components/safety/empty_sight.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

const Sweep kNothing = sweep_of({}, kInfinity);

bool believes(EmptySight& sight, const Sweep& sweep, const SweepOptions& options = {}) {
  const CheckedSweep checked = check_sweep(sweep.view(), options);
  EXPECT_EQ(checked.fault, SweepFault::none);
  return sight.believes(sweep.view(), checked);
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

}  // namespace
}  // namespace bw::safety
