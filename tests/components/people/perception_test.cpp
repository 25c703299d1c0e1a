// Detector and tracker together against the truth of simulated rooms. The short version guards what was
// reached; the long one prints the figures (perception_rooms.hpp names the variables):
//
//   BANDWAGON_PEOPLE_MINUTES=5 BANDWAGON_PEOPLE_SEED=<first> test_people_perception --gtest_filter=Perception.<test>
//
// Parameters were chosen on other seeds (README of the tracker); change the ones here when choosing anew.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/components/people/perception_rooms.hpp"
#include "tests/shortfall.hpp"

namespace bw::people::test {
namespace {

/// What is reached, with some room for the few seconds of every day.
struct Kept {
  double recall, precision, mota, velocity, median, late, seen_switches, switches;
};

void expect_figures(const Score& score, const Kept& kept) {
  bw::test::expect_at_least("recall, unoccluded, within 6 m", 0.95, kept.recall, score.recall());
  bw::test::expect_at_least("precision", 0.99, kept.precision, score.precision());
  bw::test::expect_at_least("MOTA", 0.93, kept.mota, score.mota());
  bw::test::expect_at_most("velocity [m/s]", 0.13, kept.velocity, score.velocity_rmse());
  bw::test::expect_at_most("walkers confirmed, median [s]", 0.3, kept.median,
                           score.walkers_confirmation_quantile(0.5));
  bw::test::expect_at_most("walkers confirmed, 95 % [s]", 0.5, kept.late,
                           score.walkers_confirmation_quantile(0.95));
  bw::test::expect_at_most("identity switches in view per 10 person-minutes", 1.0, kept.seen_switches,
                           score.seen_switches_per_ten_minutes());
  bw::test::expect_at_most("identity switches per 10 person-minutes", 8.0, kept.switches,
                           score.switches_per_ten_minutes());
}

TEST(Perception, FollowsPeopleAroundAStandingAndADrivingRobot) {
  const RoomsRecord rooms = run_rooms(first_seed(801), seconds_each(30.0));
  expect_figures(rooms.score, {0.92, 0.98, 0.91, 0.14, 0.4, 1.0, 3.0, 18.0});
  EXPECT_LE(rooms.score.motp(), 0.10);
}

TEST(Perception, FollowsPeopleAmongFurniture) {
  const RoomsRecord rooms = run_full_rooms(first_seed(851), seconds_each(10.0), true);
  expect_figures(rooms.score, {0.76, 0.86, 0.66, 0.18, 0.4, 1.3, 5.0, 20.0});
}

// Nobody is there: whoever is confirmed is false. Asked: one in ten minutes.
TEST(Perception, TakesFurnitureForNobody) {
  const RoomsRecord rooms = run_full_rooms(first_seed(851), seconds_each(15.0), false);
  bw::test::expect_at_most("false people per 10 minutes", 1.0, 12.0, rooms.false_people_per_ten_minutes());
}

}  // namespace
}  // namespace bw::people::test
