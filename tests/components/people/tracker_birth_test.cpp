// When one cluster alone, or two that stand on background, are a person.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "components/people/tracker/birth.hpp"
#include "components/people/tracker/walking.hpp"
#include "tests/components/people/tracker_sightings.hpp"

namespace bw::people {
namespace {

/// Along x; `score` of each sighting.
std::vector<Sighting> leg(const std::vector<double>& positions, double score = 0.9) {
  std::vector<Sighting> sightings;
  for (const double x : positions)
    sightings.push_back(sighting(static_cast<std::int64_t>(sightings.size()), {x, 0.0}, score));
  return sightings;
}

/// Six sightings, 0.79 m: the third step is `leap` [m], the others share the rest.
std::vector<double> positions_with(double leap) {
  const double step = (0.79 - leap) / 4.0;
  return {0.0, step, 2.0 * step, 2.0 * step + leap, 3.0 * step + leap, 4.0 * step + leap};
}

// 6 sightings, 0.79 m straight on. Cut from chair to chair by a step of 0.75 m, it is nobody; a leg does up
// to 0.35 m. Without that its doubt is 1 - 0.9.
TEST(Birth, WhatLeapsFromChairToChairIsNobody) {
  EXPECT_FALSE(birth_of_single(track_of(leg(positions_with(0.75))), {}));
  EXPECT_FALSE(birth_of_single(track_of(leg(positions_with(0.36))), {}));
  for (const double step : {0.158, 0.34}) {
    const auto birth = birth_of_single(track_of(leg(positions_with(step))), {});
    ASSERT_TRUE(birth) << step;
    EXPECT_EQ(birth->kind, BirthKind::walking_single);
    EXPECT_NEAR(birth->doubt, 0.1, 1e-12);
    EXPECT_NEAR(birth->distance, 0.79, 1e-12);
  }
}

// 0.7 of the sweeps must show it in the last 1.15 s: of 7 after the first sighting 2 may be missed, of 8 as
// well (6 of 8 are 0.75), not 3. What was missed before does not count.
TEST(Birth, WhatIsSeenNowAndThenIsNobody) {
  const auto seen_in = [](const std::vector<std::int64_t>& sweeps) {
    std::vector<Sighting> sightings;
    for (const std::int64_t sweep : sweeps)
      sightings.push_back(sighting(sweep, {0.08 * static_cast<double>(sweep), 0.0}));
    return birth_of_single(track_of(sightings), {}).has_value();
  };
  EXPECT_TRUE(seen_in({0, 1, 3, 4, 6, 7}));
  EXPECT_FALSE(seen_in({0, 1, 3, 4, 6, 8}));
  EXPECT_FALSE(seen_in({0, 2, 3, 5, 6, 8}));
  EXPECT_TRUE(seen_in({0, 3, 4, 5, 6, 7, 8}));
  EXPECT_TRUE(seen_in({0, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST(Birth, WhatDoesNotWalkLikeALegIsNobody) {
  const auto born = [](const std::vector<Sighting>& seen) { return birth_of_single(track_of(seen), {}); };
  const auto walked = [](double distance) {
    return std::vector<double>{0.0, 0.2 * distance, 0.4 * distance, 0.6 * distance, 0.8 * distance, distance};
  };
  EXPECT_TRUE(born(leg(walked(0.51))));
  EXPECT_FALSE(born(leg(walked(0.49))));  // 0.5 m are asked
  EXPECT_TRUE(born(leg(walked(0.8), 0.61)));
  EXPECT_FALSE(born(leg(walked(0.8), 0.59)));                             // a mean score of 0.6
  EXPECT_FALSE(born(leg({0.0, 0.2, 0.4, 0.6, 0.8})));                     // 0.4 s where 0.45 are asked
  EXPECT_TRUE(born(leg({0.0, 0.3, 0.25, 0.5, 0.45, 0.6, 0.8, 1.0})));     // 1.0 m by a path of 1.2 m
  EXPECT_FALSE(born(leg({0.0, 0.3, 0.15, 0.45, 0.3, 0.6, 0.45, 0.75})));  // 0.75 m by a path of 1.65 m
  std::vector<Sighting> cut = leg(walked(0.8));
  for (std::size_t k = 0; k < 3; ++k) cut[k].occluded = true;
  EXPECT_TRUE(born(cut));  // cut off on a side in half of the sweeps at most
  cut[3].occluded = true;
  EXPECT_FALSE(born(cut));
}

// Legs 0.2 m apart that do not move: 0.3 s that score 0.7 in the open, 0.7 s that score 0.8 where something
// has long stood. Their doubt is 0.2 - 0.5 * score.
TEST(Birth, LegsOnBackgroundMustLookMoreLikeLegs) {
  const auto doubt = [](int count, double score, bool on_static) {
    const auto leg = [&](double y) {
      std::vector<Sighting> seen;
      for (int k = 0; k < count; ++k) {
        seen.push_back(sighting(k, {1.0, y}, score));
        seen.back().on_static = on_static;
      }
      return track_of(seen);
    };
    const auto birth = birth_of_pair(leg(0.1), leg(-0.1), {});
    return birth && birth->kind == BirthKind::standing_pair ? std::optional(birth->doubt) : std::nullopt;
  };
  EXPECT_TRUE(doubt(4, 0.71, false));
  EXPECT_FALSE(doubt(3, 0.71, false));
  EXPECT_FALSE(doubt(4, 0.69, false));
  EXPECT_FALSE(doubt(7, 0.81, true));
  EXPECT_FALSE(doubt(8, 0.79, true));
  ASSERT_TRUE(doubt(8, 0.81, true));
  EXPECT_NEAR(*doubt(8, 0.81, true), 0.2 - 0.5 * 0.81, 1e-12);
}

// Two legs side by side, seen five times: they stay, unless both of them go and their middle goes 0.1 m,
// straight on.
TEST(Birth, LegsStayUnlessBothGo) {
  const auto stay = [](double left, double right, double aside = 0.0) {
    const auto leg = [&](double y, double step) {
      std::vector<Sighting> seen;
      for (int k = 0; k < 5; ++k)
        seen.push_back(sighting(k, {1.0 + step * k, y + (k % 2 == 0 ? aside : -aside)}));
      return track_of(seen);
    };
    return stays(leg(0.1, left), leg(-0.1, right), {});
  };
  EXPECT_TRUE(stay(0.0, 0.0));
  EXPECT_TRUE(stay(0.02, 0.02));      // 0.08 m
  EXPECT_FALSE(stay(0.03, 0.03));     // 0.12 m
  EXPECT_TRUE(stay(0.1, 0.0));        // one alone, 0.4 m: their middle 0.2 m
  EXPECT_FALSE(stay(0.1, 0.02));      // 0.24 m, of which each goes more than a quarter
  EXPECT_TRUE(stay(0.1, 0.1, 0.09));  // beside a straight path by more than 0.08 m
}

// At any rate of sweeps legs that walk at 1.2 m/s are a pair that walks once their middle has gone 0.2 m and
// both have been seen for 0.2 s, at 5 per second for 0.4 s: three sightings at least show whether they go straight.
TEST(Birth, CountsSecondsNotSweeps) {
  const auto born_after = [](double rate) {
    const auto position = [](double t, double side) {
      return Vector2(1.2 * t + 0.18 * side * std::sin(5.4 * t), 0.12 * side);
    };
    const auto seen = [&](std::int64_t sweep, double side) {
      const double t = static_cast<double>(sweep) / rate;
      return Sighting{
          .sweep = sweep, .time = t, .position = position(t, side), .variance = 1e-4, .leg_score = 0.9};
    };
    ClusterTrack left(seen(0, 1.0));
    ClusterTrack right(seen(0, -1.0));
    for (std::int64_t sweep = 1; sweep < 100; ++sweep) {
      left.correct(seen(sweep, 1.0));
      right.correct(seen(sweep, -1.0));
      const auto birth = birth_of_pair(left, right, {});
      if (birth && birth->kind == BirthKind::walking_pair) return static_cast<double>(sweep) / rate;
    }
    return 1e9;
  };
  for (const double rate : {10.0, 20.0, 40.0}) EXPECT_LE(born_after(rate), 0.25) << rate;
  EXPECT_NEAR(born_after(5.0), 0.4, 1e-9);
}

}  // namespace
}  // namespace bw::people
