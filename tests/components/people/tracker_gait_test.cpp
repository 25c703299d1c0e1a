// How two clusters went along together, against closed forms, and what is remembered of a leg.
#include <cmath>

#include <gtest/gtest.h>

#include "components/people/tracker/gait.hpp"
#include "components/people/tracker/person_track.hpp"
#include "tests/components/people/tracker_sightings.hpp"

namespace bw::people {
namespace {

// Sweeps 0 to 5 and 2 to 7 without 4: common are 5, 3, 2, the last first.
TEST(Gait, CommonSightingsAreOfTheSameSweeps) {
  const ClusterTrack a = track_of(0, 5, [](double t) { return Vector2(t, 0.0); });
  std::vector<Sighting> others;
  for (const int sweep : {2, 3, 5, 6, 7}) others.push_back(sighting(sweep, {0.1 * sweep, 0.3}));
  const ClusterTrack b = track_of(others);
  for (const CommonSightings& common : {CommonSightings(a, b), CommonSightings(b, a)}) {
    ASSERT_EQ(common.count, 3);
    const double times[] = {0.5, 0.3, 0.2};
    for (int k = 0; k < 3; ++k) {
      EXPECT_DOUBLE_EQ(common.time(k), times[k]);
      EXPECT_NEAR(common.separation(k), 0.3, 1e-12);
      EXPECT_NEAR((common.middle(k) - Vector2(times[k], 0.15)).norm(), 0.0, 1e-12);
    }
  }
}

// Legs 0.2 m apart, at (1 + 1.2 t, 2 - 0.5 t -+ 0.1): velocity (1.2, -0.5), no misfit. The last 4 of sweeps
// 0 to 5 begin at t = 0.2 s, at (1.24, 1.9).
TEST(Gait, StraightWayIsFoundExactly) {
  const auto leg = [](double side) {
    return track_of(0, 5, [=](double t) { return Vector2(1.0 + 1.2 * t, 2.0 - 0.5 * t + side); });
  };
  const ClusterTrack a = leg(0.1);
  const ClusterTrack b = leg(-0.1);
  const Gait gait = gait_of(CommonSightings(a, b), 4);
  EXPECT_NEAR(gait.widest, 0.2, 1e-12);
  EXPECT_NEAR(gait.misfit, 0.0, 1e-12);
  EXPECT_NEAR((gait.velocity - Vector2(1.2, -0.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(gait.since, 0.2, 1e-12);
  EXPECT_NEAR((gait.start - Vector2(1.24, 1.9)).norm(), 0.0, 1e-12);
}

// Legs that swing against each other by s leave their middle straight: 0.24 m across, swing of 0.18 m at its
// end is 2 * 0.18 m along, so the widest is sqrt(0.24^2 + 0.36^2) m.
TEST(Gait, SwingWidensButLeavesTheMiddle) {
  const auto leg = [](double sign) {
    return track_of(0, 4, [=](double t) {
      const double swing = std::abs(t - 0.2) < 0.01 ? 0.18 : 0.05;
      return Vector2(t + sign * swing, sign * 0.12);
    });
  };
  const ClusterTrack a = leg(1.0);
  const ClusterTrack b = leg(-1.0);
  const Gait gait = gait_of(CommonSightings(a, b), 5);
  EXPECT_NEAR(gait.widest, std::hypot(0.24, 0.36), 1e-12);
  EXPECT_NEAR(gait.misfit, 0.0, 1e-12);
}

// Middles (0, 0), (0.1, 0.03), (0.2, 0) at 0, 0.1, 0.2 s: the straight path is y = 0.01 m at (1, 0) m/s, off
// by -0.01, 0.02, -0.01 m: sqrt(0.0006 / 3) = 0.0141 m. It starts at (0, 0.01).
TEST(Gait, MisfitIsTheMiddlesRootMeanSquare) {
  const auto leg = [](double side) {
    return track_of({sighting(0, {0.0, side}), sighting(1, {0.1, 0.03 + side}), sighting(2, {0.2, side})});
  };
  const ClusterTrack a = leg(0.1);
  const ClusterTrack b = leg(-0.1);
  const Gait gait = gait_of(CommonSightings(a, b), 3);
  EXPECT_NEAR(gait.misfit, std::sqrt(0.0006 / 3.0), 1e-12);
  EXPECT_NEAR((gait.velocity - Vector2(1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((gait.start - Vector2(0.0, 0.01)).norm(), 0.0, 1e-12);
}

TEST(Gait, OneCommonSightingHasNoVelocity) {
  const ClusterTrack a = track_of({sighting(0, {0.0, 0.0}), sighting(1, {0.3, 0.0})});
  const ClusterTrack b(sighting(1, {0.3, 0.2}));
  const Gait gait = gait_of(CommonSightings(a, b), 5);
  EXPECT_EQ(gait.velocity, Vector2(0.0, 0.0));
  EXPECT_EQ(gait.misfit, 0.0);
  EXPECT_NEAR((gait.start - Vector2(0.3, 0.1)).norm(), 0.0, 1e-12);
}

PersonTrack somebody() { return {.walker = Walker({0.0, 0.1}, {0.0, -0.1}, {0.0, 0.0}, 1e-4, 1.0)}; }

// A leg does not do 0.45 m from one sweep to the next, nor is it known after more than 3 sweeps.
TEST(PersonTrack, LegTooFarOrTooLateIsAnother) {
  struct Case {
    double step;
    int sweeps;
    int remembered;
  };
  for (const auto& [step, sweeps, remembered] :
       {Case{0.44, 1, 2}, Case{0.46, 1, 1}, Case{0.1, 3, 2}, Case{0.1, 4, 1}}) {
    PersonTrack person = somebody();
    person.remember_leg(1, sighting(10, {0.0, 0.0}));
    person.remember_leg(1, sighting(10 + sweeps, {step, 0.0}));
    ASSERT_TRUE(person.legs[1] && !person.legs[0]);
    EXPECT_EQ(person.legs[1]->remembered(), remembered) << step << " m, " << sweeps << " sweeps";
    EXPECT_EQ(person.legs[1]->last().sweep, 10 + sweeps);
  }
}

TEST(PersonTrack, BothLegsAreSeenWhenThisSweepShowedThem) {
  PersonTrack person = somebody();
  EXPECT_FALSE(person.both_legs_seen(10));
  person.remember_leg(0, sighting(10, {0.0, 0.1}));
  EXPECT_FALSE(person.both_legs_seen(10));
  person.remember_leg(1, sighting(10, {0.0, -0.1}));
  EXPECT_TRUE(person.both_legs_seen(10));
  person.remember_leg(0, sighting(11, {0.0, 0.1}));
  EXPECT_FALSE(person.both_legs_seen(11));
}

}  // namespace
}  // namespace bw::people
