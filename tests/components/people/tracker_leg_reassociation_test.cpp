// Whose leg is whose, on legs whose path is known.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "components/people/tracker/leg_reassociation.hpp"
#include "tests/components/people/tracker_sightings.hpp"

namespace bw::people {
namespace {

constexpr std::int64_t kSweep = 15;
using TrackedLegs = std::array<std::optional<ClusterTrack>, 2>;

PersonTrack person_at(const Vector2& position, const Vector2& velocity, const TrackedLegs& legs) {
  return {.walker = Walker(position + Vector2(0.1, 0.0), position - Vector2(0.1, 0.0), velocity, 1e-4, 0.01),
          .legs = legs};
}

// Legs 0.2 m apart, middles 0, 0.03, 0 m off their line: misfit 0.0141 m as in the test of Gait.
TEST(LegReassociation, DoubtIsWidestAndFourTimesTheMisfit) {
  const auto leg = [](double side, int sweeps) {
    std::vector<Sighting> seen{sighting(0, {0.0, side}), sighting(1, {0.1, 0.03 + side})};
    if (sweeps == 3) seen.push_back(sighting(2, {0.2, side}));
    return track_of(seen);
  };
  const auto doubt = doubt_of_legs(leg(0.1, 3), leg(-0.1, 3), {});
  ASSERT_TRUE(doubt);
  EXPECT_NEAR(*doubt, 0.2 + 4.0 * std::sqrt(0.0006 / 3.0), 1e-12);
  EXPECT_FALSE(doubt_of_legs(leg(0.1, 3), leg(-0.1, 2), {}));  // two common sightings, three are asked
}

// Only the last 5 sightings count: 0.6 m apart six sweeps ago, 0.2 m since.
TEST(LegReassociation, DoubtForgets) {
  const auto doubt = [](int wide_until) {
    const ClusterTrack b =
        track_of(0, 5, [=](double t) { return Vector2(0.0, t < 0.1 * wide_until + 0.05 ? 0.6 : 0.2); });
    return doubt_of_legs(standing({0.0, 0.0}, 5), b, {}).value();
  };
  EXPECT_NEAR(doubt(0), 0.2, 1e-12);
  EXPECT_GT(doubt(1), 0.6);
}

/// A goes up at x = 0.2 m, B down at x = -0.2 m, 1 m/s each, past each other at t = 1 s. Legs 0.2 m apart.
class Passing : public testing::Test {
 protected:
  static Vector2 middle(double up, double t) { return {0.2 * up, up * (t - 1.0)}; }
  static ClusterTrack leg(double up, double side) {
    return track_of(8, kSweep, [=](double t) { return Vector2(middle(up, t) + Vector2(side, 0.0)); });
  }
  static PersonTrack person(double up, const ClusterTrack& first, const ClusterTrack& second) {
    PersonTrack person = person_at(middle(up, 1.5), {0.0, up}, {first, second});
    person.settled = {0.6, middle(up, 0.6), {0.0, up}};
    return person;
  }
  static void expect_legs_of(double up, const std::array<ClusterTrack, 2>& legs) {
    EXPECT_NEAR(((legs[0].last().position + legs[1].last().position) / 2.0 - middle(up, 1.5)).norm(), 0.0,
                1e-12);
    EXPECT_NEAR((legs[0].last().position - legs[1].last().position).norm(), 0.2, 1e-12);
  }

  const std::array<ClusterTrack, 2> a_{leg(1.0, 0.1), leg(1.0, -0.1)};
  const std::array<ClusterTrack, 2> b_{leg(-1.0, 0.1), leg(-1.0, -0.1)};
};

// Each holds one leg of each. As they are, legs end 1.0 m up and down from each other; given back, the doubt
// is 0.2 m each. Whatever order legs and people come in, each gets those that came from where they were.
TEST_F(Passing, ExchangedLegsAreGivenBack) {
  for (int order = 0; order < 16; ++order) {
    const auto pick = [&](int bit) { return static_cast<std::size_t>((order >> bit) & 1); };
    const ClusterTrack& own = a_[pick(0)];
    const ClusterTrack& foreign = b_[pick(1)];
    const ClusterTrack& given = a_[1 - pick(0)];
    const ClusterTrack& rest = b_[1 - pick(1)];
    const PersonTrack a = pick(2) == 0 ? person(1.0, own, foreign) : person(1.0, foreign, own);
    const PersonTrack b = pick(3) == 0 ? person(-1.0, rest, given) : person(-1.0, given, rest);
    for (const bool a_first : {true, false}) {
      const auto pairs =
          a_first ? reassociate_legs({&a, &b}, {}, kSweep, {}) : reassociate_legs({&b, &a}, {}, kSweep, {});
      ASSERT_TRUE(pairs) << "order " << order;
      ASSERT_EQ(pairs->legs.size(), 2U);
      expect_legs_of(1.0, pairs->legs[a_first ? 0 : 1]);
      expect_legs_of(-1.0, pairs->legs[a_first ? 1 : 0]);
      EXPECT_TRUE(pairs->left.empty());
      EXPECT_TRUE(pairs->taken.empty());
    }
  }
}

TEST_F(Passing, OwnLegsStay) {
  const PersonTrack a = person(1.0, a_[0], a_[1]);
  const PersonTrack b = person(-1.0, b_[0], b_[1]);
  EXPECT_FALSE(reassociate_legs({&a, &b}, {}, kSweep, {}));
}

// A holds a leg of B's, and A's other leg is nobody's; B is not asked. A gets it, B's leg is nobody's then.
TEST_F(Passing, WhatIsLeftAndWhatIsTakenIsTold) {
  const PersonTrack a = person(1.0, a_[0], b_[1]);
  const std::vector<ClusterTrack> clusters{standing({3.0, 3.0}, kSweep), a_[1]};
  const auto pairs = reassociate_legs({&a}, clusters, kSweep, {});
  ASSERT_TRUE(pairs);
  ASSERT_EQ(pairs->legs.size(), 1U);
  expect_legs_of(1.0, pairs->legs[0]);
  ASSERT_EQ(pairs->left.size(), 1U);
  EXPECT_EQ(pairs->left[0].last().position, b_[1].last().position);
  EXPECT_EQ(pairs->taken, std::vector<int>{1});
}

// Somebody stands on legs `wide` apart, another cluster 0.15 m from one of them. It is taken when that is
// less doubtful by 0.25 m: from 0.40 m on.
TEST(LegReassociation, ChangesNothingWithoutMargin) {
  const ClusterTrack leg = standing({0.0, 0.0}, kSweep);
  const std::vector<ClusterTrack> clusters{standing({-0.15, 0.0}, kSweep)};
  for (const double wide : {0.39, 0.41}) {
    const ClusterTrack other = standing({wide, 0.0}, kSweep);
    const PersonTrack person = person_at({wide / 2.0, 0.0}, {0.0, 0.0}, {leg, other});
    const auto pairs = reassociate_legs({&person}, clusters, kSweep, {});
    EXPECT_EQ(pairs.has_value(), wide > 0.4);
    if (!pairs) continue;
    ASSERT_EQ(pairs->left.size(), 1U);
    EXPECT_EQ(pairs->left[0].last().position, Vector2(wide, 0.0));
    EXPECT_EQ(pairs->taken, std::vector<int>{0});
  }
}

// Of somebody one leg is known, at the origin: doubt 0.8 m. Another is taken for the second if that leaves
// less than 0.8 - 0.25 = 0.55 m, if it is within 0.7 m of them, scores 0.4, and was seen in this sweep.
TEST(LegReassociation, AnUnrelatedClusterBecomesTheOtherLegOfTheOneLegged) {
  const Vector2 far(3.0, 3.0);
  struct Case {
    const char* what;
    double position;
    double middle;
    double score;
    std::int64_t seen;
    bool taken;
  };
  for (const Case& c : {Case{"a leg", 0.2, 0.1, 0.9, kSweep, true},
                        Case{"just near enough to the leg", 0.54, 0.2, 0.9, kSweep, true},
                        Case{"too far from the leg", 0.56, 0.2, 0.9, kSweep, false},
                        Case{"just near enough to them", 0.4, -0.29, 0.9, kSweep, true},
                        Case{"too far from them", 0.4, -0.31, 0.9, kSweep, false},
                        Case{"just enough like a leg", 0.2, 0.1, 0.41, kSweep, true},
                        Case{"like a chair's", 0.2, 0.1, 0.39, kSweep, false},
                        Case{"not seen now", 0.2, 0.1, 0.9, kSweep - 1, false}}) {
    const PersonTrack person =
        person_at({c.middle, 0.0}, {0.0, 0.0}, {standing({0.0, 0.0}, kSweep), std::nullopt});
    const std::vector<ClusterTrack> clusters{standing(far, kSweep),
                                             standing({c.position, 0.0}, c.seen, c.score)};
    const auto pairs = reassociate_legs({&person}, clusters, kSweep, {});
    ASSERT_EQ(pairs.has_value(), c.taken) << c.what;
    if (!pairs) continue;
    EXPECT_EQ(pairs->taken, std::vector<int>{1}) << c.what;
    EXPECT_TRUE(pairs->left.empty()) << c.what;
    EXPECT_NEAR((pairs->legs[0][0].last().position - pairs->legs[0][1].last().position).norm(), c.position,
                1e-12);
  }
}

// Two clusters that are nobody's make no new person here, however alike: each pair keeps a leg of theirs.
TEST(LegReassociation, UnrelatedClustersAloneAreNotTheirLegs) {
  const ClusterTrack leg = standing({0.0, 0.0}, kSweep);
  const PersonTrack person = person_at({0.0, 0.0}, {0.0, 0.0}, {leg, std::nullopt});
  const std::vector<ClusterTrack> clusters{standing({0.58, 0.0}, kSweep), standing({0.68, 0.0}, kSweep)};
  EXPECT_FALSE(reassociate_legs({&person}, clusters, kSweep, {}));
}

}  // namespace
}  // namespace bw::people
