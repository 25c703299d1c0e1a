// What an emulated base touches and what its beams hit.
#include "components/emulators/surroundings.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace bw::emulators {
namespace {

/// A wall along x = 1, and a robot of 0.2 m radius that stands 5 mm from it, rotated by `heading`.
ContactReading at_the_wall(double heading, double gap = 0.01) {
  const StaticScene scene({.points = {}, .discs = {}, .segments = {{{1.0, -5.0}, {1.0, 5.0}}}}, std::nullopt);
  return touched({0.795, 0.0, heading}, 0.2, gap, scene, {});
}

TEST(Surroundings, PressTheBumperOnTheSideOfTheWall) {
  const double degree = std::numbers::pi / 180.0;
  EXPECT_EQ(at_the_wall(0.0), (ContactReading{.bumper_centre = true}));
  EXPECT_EQ(at_the_wall(-60.0 * degree), (ContactReading{.bumper_left = true}));
  EXPECT_EQ(at_the_wall(60.0 * degree), (ContactReading{.bumper_right = true}));
  EXPECT_EQ(at_the_wall(-30.0 * degree), (ContactReading{.bumper_left = true, .bumper_centre = true}));
  EXPECT_EQ(at_the_wall(180.0 * degree), ContactReading{});  // no bumper behind
  EXPECT_EQ(at_the_wall(0.0, 0.004), ContactReading{});
}

TEST(Surroundings, PeoplePressToo) {
  const StaticScene nothing({}, std::nullopt);
  EXPECT_EQ(touched({}, 0.2, 0.01, nothing, {{{0.0, 0.4}, 0.195}}), (ContactReading{.bumper_left = true}));
  EXPECT_EQ(touched({}, 0.2, 0.01, nothing, {{{0.0, 0.4}, 0.18}}), ContactReading{});
}

TEST(Surroundings, ABeamTellsTheNearestThingAcrossIt) {
  const StaticScene scene(
      {.points = {}, .discs = {{{2.0, 0.0}, 0.5}}, .segments = {{{3.0, -1.0}, {3.0, 1.0}}}}, std::nullopt);
  const Beam ahead{.X_base_sensor = {0.1, 0.0, 0.0}, .half_angle = 0.1, .reach = 2.95};
  EXPECT_NEAR(range_of(ahead, {}, scene, {}), 1.4, 1e-9);                   // the disc, before the wall
  EXPECT_NEAR(range_of(ahead, {}, scene, {{{1.0, 0.0}, 0.3}}), 0.6, 1e-9);  // a person before both
  EXPECT_NEAR(range_of(ahead, {0.0, 0.75, 0.0}, scene, {}), 2.9, 1e-9);     // past the disc, to the wall
  EXPECT_TRUE(std::isinf(range_of(ahead, {-2.0, 0.75, 0.0}, scene, {})));   // out of reach
}

}  // namespace
}  // namespace bw::emulators
