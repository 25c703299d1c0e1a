// What speaks for and against a person, term by term.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "components/people/tracker/evidence/existence.hpp"
#include "components/people/tracker/evidence/foot_shifts.hpp"
#include "components/people/tracker/evidence/past_sweeps.hpp"
#include "components/people/tracker/evidence/row_of_posts.hpp"
#include "components/people/tracker/tracker.hpp"
#include "tests/components/people/tracker_stage.hpp"

namespace bw::people {
namespace {

constexpr FootShifts::Memory kOfLeg{.gap = 0.5, .bearing_change = 0.1};
constexpr FootShifts::Memory kOfPair{.gap = 1e9, .bearing_change = 4.0};

// One side, score 0.9: n ln 9 / (n + 2), but at most 20 are remembered. A score of 0.5 says nothing.
TEST(Evidence, LooksOfOneSideAreAveraged) {
  Appearance appearance;
  EXPECT_EQ(appearance.log_odds(), 0.0);
  for (int n = 1; n <= 20; ++n) {
    appearance.add(0.9, 0.1);
    EXPECT_NEAR(appearance.log_odds(), n * std::log(9.0) / (n + 2), 1e-5);
  }
  for (int n = 0; n < 500; ++n) appearance.add(0.9, 0.1);
  EXPECT_NEAR(appearance.log_odds(), 20.0 * std::log(9.0) / 22.0, 1e-4);
  for (int n = 0; n < 500; ++n) appearance.add(0.5, 0.1);
  EXPECT_NEAR(appearance.log_odds(), 0.0, 1e-4);
}

// The same leg for 0.2 s at any rate: 3 ln 9 / 5 after the first sighting and two tenths of a second.
TEST(Evidence, LooksCountSecondsNotSweeps) {
  for (const int rate : {5, 10, 20, 40}) {
    Appearance appearance;
    appearance.add(0.9, 0.1);
    for (int k = 0; k < rate / 5; ++k) appearance.add(0.9, 0.1, 1.0 / rate);
    EXPECT_NEAR(appearance.log_odds(), 3.0 * std::log(9.0) / 5.0, 1e-5) << rate;
  }
}

// Three sightings from one side and three from across: the second half counts half. 3 ln 9 / 5 = 1.318.
TEST(Evidence, AnotherSideTellsMore) {
  Appearance same;
  Appearance two_sides;
  Appearance unlike;
  for (int n = 0; n < 3; ++n) {
    same.add(0.9, 0.1);
    two_sides.add(0.9, 0.1);
    two_sides.add(0.9, 0.1 + std::numbers::pi);
    unlike.add(0.9, 0.1);
    unlike.add(0.1, 0.1 + std::numbers::pi);
  }
  EXPECT_NEAR(two_sides.log_odds(), 1.5 * same.log_odds(), 1e-5);
  EXPECT_NEAR(unlike.log_odds(), 0.5 * same.log_odds(), 1e-5);
  for (int side = 0; side < 8; ++side)
    for (int n = 0; n < 9; ++n) two_sides.add(1.0, 0.8 * side);
  EXPECT_EQ(two_sides.log_odds(), Appearance::kMax);
}

TEST(Evidence, WayWalkedCountsAfterASlip) {
  EXPECT_EQ(Walked{0.15}.log_odds(), 0.0);
  EXPECT_NEAR(Walked{0.35}.log_odds(), 2.0, 1e-12);
  EXPECT_EQ(Walked{5.0}.log_odds(), Walked::kMax);
}

/// Log odds after a leg stood at 0 for `before` s, at `shift` m for `after` s, and back again, ten sweeps a
/// second.
double foot_shifts_of(double before, double shift, double after, bool whole = true,
                      double bearing_rate = 0.0) {
  FootShifts foot_shifts;
  double t = 0.0;
  const auto stand = [&](double x, double seconds) {
    for (const double end = t + seconds - 1e-9; t < end; t += 0.1)
      foot_shifts.add(t, {x, 1.0}, whole, bearing_rate * t, kOfLeg);
  };
  stand(0.0, before);
  stand(shift, after);
  stand(0.0, before);
  return foot_shifts.log_odds();
}

// A foot that is set aside by 0.1 m and back after 2 s shifts twice; 0.03 m is within what a standing disc
// errs,
// 0.3 m is another thing, 0.3 s are none, and what is half hidden or seen from another side shows nothing.
TEST(Evidence, WhoStandsShiftsAFoot) {
  EXPECT_EQ(foot_shifts_of(2.0, 0.0, 2.0), 0.0);
  EXPECT_EQ(foot_shifts_of(2.0, 0.1, 2.0), 2.0 * FootShifts::kEach);
  EXPECT_EQ(foot_shifts_of(2.0, 0.03, 2.0), 0.0);
  EXPECT_EQ(foot_shifts_of(2.0, 0.3, 2.0), 0.0);
  EXPECT_EQ(foot_shifts_of(2.0, 0.1, 0.3), 0.0);
  EXPECT_EQ(foot_shifts_of(2.0, 0.1, 2.0, false), 0.0);
  EXPECT_EQ(foot_shifts_of(2.0, 0.1, 2.0, true, 0.2), 0.0);
  FootShifts noisy;
  Random random(5);
  for (int k = 0; k < 6000; ++k)
    noisy.add(0.1 * k, {random.normal(0.0, 0.012), random.normal(0.0, 0.012)}, true, 0.0, kOfLeg);
  EXPECT_EQ(noisy.log_odds(), 0.0);
}

// The path between two legs is compared with how it was before they were out of view for 10 s and seen from
// another side; the position of a single leg is not. Stray sightings before and after do not make a time for
// which it stood.
TEST(Evidence, ThePairThatStoodIsRemembered) {
  const auto shifts = [](const FootShifts::Memory& memory, double shift, int before) {
    FootShifts foot_shifts;
    for (int k = 0; k < before; ++k) foot_shifts.add(0.1 * k, {0.24, 0.0}, true, 0.0, memory);
    for (int k = 0; k < 5; ++k) foot_shifts.add(12.0 + 0.1 * k, {0.24, shift}, true, 1.5, memory);
    return foot_shifts.log_odds();
  };
  EXPECT_EQ(shifts(kOfPair, 0.1, 11), FootShifts::kEach);
  EXPECT_EQ(shifts(kOfPair, 0.03, 11), 0.0);
  EXPECT_EQ(shifts(kOfPair, 0.1, 10), 0.0);  // stood for 0.9 s
  EXPECT_EQ(shifts(kOfLeg, 0.1, 11), 0.0);
  FootShifts stray;
  for (int k = 0; k < 11; ++k) stray.add(0.1 * k, {0.24, 0.0}, true, 0.0, kOfPair);
  for (int k = 1; k < 10; ++k) stray.add(1.0 + 1.0 * k, {0.24, 0.1}, true, 0.0, kOfPair);
  EXPECT_EQ(stray.log_odds(), 0.0);
}

// A chair 0.4 m wide: its fourth leg hidden or seen. Posts every 0.5 m. Two pairs of legs that stand about
// are none.
TEST(Evidence, FurnitureStandsInPatterns) {
  const Post post{{1.0, 1.0}, 0.04};
  const auto at = [](double x, double y, double width = 0.04) { return Post{{x, y}, width}; };
  EXPECT_EQ(row_of_posts(post, std::vector{at(1.4, 1.0), at(1.0, 1.4)}).log_odds, RowOfPosts::kCorner);
  EXPECT_EQ(row_of_posts(post, std::vector{at(1.4, 1.0), at(1.0, 1.4), at(1.4, 1.4)}).log_odds,
            RowOfPosts::kRectangle);
  EXPECT_EQ(row_of_posts(post, std::vector{at(1.5, 1.0), at(2.0, 1.0)}).log_odds, RowOfPosts::kRow);
  EXPECT_EQ(row_of_posts(post, std::vector{at(1.5, 1.0), at(0.5, 1.0)}).log_odds, RowOfPosts::kRow);
  EXPECT_EQ(row_of_posts(post, std::vector{at(1.4, 1.0, 0.12), at(1.0, 1.4, 0.12)}).log_odds, 0.0);
  EXPECT_EQ(row_of_posts(post, std::vector{at(1.24, 1.0), at(1.0, 1.24)}).log_odds, 0.0);
  EXPECT_EQ(row_of_posts(post, std::vector{at(1.4, 1.0), at(1.3, 1.4)}).log_odds, 0.0);
}

TEST(Evidence, ConfidenceIsTheLogisticOfTheSum) {
  Existence existence{.prior = Existence::kTwoLegs};
  EXPECT_NEAR(existence.confidence(), 1.0 / (1.0 + std::exp(-Existence::kTwoLegs)), 1e-12);
  existence.walked.distance = 0.35;
  existence.foot_shifts = FootShifts::kEach;
  existence.row = RowOfPosts::kRow;
  existence.clutter = -1.0;
  existence.alone = Existence::kAlone;
  EXPECT_NEAR(existence.log_odds(), Existence::kTwoLegs + 2.0 + 4.0 - 2.0 - 1.0 + Existence::kAlone, 1e-12);
}

// A distance of 0.65 m is worth 5, of 1 m at most 7; where things stood all the time less than a metre is
// worth nothing.
TEST(Evidence, AWayWalkedWhereThingsStoodIsNone) {
  Existence existence{.prior = Existence::kTwoLegs};
  existence.walked.distance = 0.65;
  EXPECT_NEAR(existence.log_odds(), Existence::kTwoLegs + 5.0, 1e-12);
  existence.in_place = true;
  EXPECT_NEAR(existence.log_odds(), Existence::kTwoLegs, 1e-12);
  existence.walked.distance = Walked::kFree;
  EXPECT_NEAR(existence.log_odds(), Existence::kTwoLegs + Walked::kMax, 1e-12);
}

// More things that look like legs come into view: who was confirmed stays so, who was not is doubted. Plain
// doubt, beyond what was kept, ends it, and then it is as for anybody.
TEST(Evidence, WhoWasConfirmedIsNotGivenUpForADoubt) {
  Existence existence{.prior = 0.5};
  existence.keep_belief();
  existence.clutter = -2.0;
  EXPECT_GE(existence.log_odds(), 0.0);
  Existence new_one{.prior = 0.5, .clutter = -2.0};
  new_one.keep_belief();
  EXPECT_LT(new_one.log_odds(), 0.0);
  existence.clutter = -0.6 - Existence::kKept;
  existence.keep_belief();
  existence.clutter = -2.0;
  EXPECT_NEAR(existence.log_odds(), -1.5, 1e-12);
}

// Of two that only stand among furniture 0.8 less is kept; who has shifted a foot keeps all.
TEST(Evidence, WhoNeverMovedAmongFurnitureKeepsLess) {
  Existence existence{.prior = Existence::kTwoLegs};
  existence.came = 2.0;
  existence.furnished = 1.0;
  existence.keep_belief();
  EXPECT_NEAR(existence.kept, Existence::kKept - Existence::kLostAmongFurniture, 1e-12);
  existence.furnished = 0.5;
  existence.keep_belief();
  EXPECT_NEAR(existence.kept, Existence::kKept - 0.5 * Existence::kLostAmongFurniture, 1e-12);
  existence.foot_shifts = FootShifts::kEach;
  existence.keep_belief();
  EXPECT_EQ(existence.kept, Existence::kKept);
}

// Score 0.9 for ever: looks of 20 ln 9 / 22 = 1.997. Of a pair that walks what is beyond 1 counts twice until
// it has walked a metre; of one that stands nothing is.
TEST(Evidence, LooksOfWalkersSayMoreUntilTheyHaveWalked) {
  Existence walker{.prior = Existence::kWalker};
  for (int k = 0; k < 500; ++k) walker.appearance.add(0.9, 0.1);
  const double looks = 20.0 * std::log(9.0) / 22.0;
  EXPECT_NEAR(walker.log_odds(), Existence::kWalker + looks + (looks - 1.0), 1e-4);
  walker.walked.distance = Walked::kFree;
  EXPECT_NEAR(walker.log_odds(), Existence::kWalker + looks + Walked::kMax, 1e-4);
  Existence standing{.prior = Existence::kTwoLegs, .appearance = walker.appearance};
  EXPECT_NEAR(standing.log_odds(), Existence::kTwoLegs + looks, 1e-4);
}

// Somebody walks 2 m and stops. Where they stand is no background, as the detector keeps it free: they stay.
// If what is seen there stood before, it is furniture that they walked up to.
TEST(Evidence, WhatStoodBeforeIsNotWhoWalkedUpToIt) {
  for (const bool stood_before : {false, true}) {
    Stage stage;
    Tracker tracker({});
    walk(stage, tracker, 0, 20);
    ASSERT_EQ(tracker.people().size(), 1U);
    for (int k = 20; k < 50; ++k) {
      stage.begin(0.1 * k);
      stage.walker(0.0, 0.0, 0.0);
      for (Detection& leg : stage.set().detections) leg.on_static = stood_before;
      tracker.update(stage.set());
    }
    const bool confirmed = !tracker.people().empty() && tracker.people()[0].confidence >= kConfirmed;
    EXPECT_EQ(confirmed, !stood_before);
    // Let go after 14 (1 - exp(-t / 1 s)) > 13, 2.6 s: who stands there, if anybody, is somebody else.
    const bool known =
        std::ranges::any_of(tracker.people(), [](const TrackedPerson& p) { return p.id == 1; });
    EXPECT_EQ(known, !stood_before);
  }
}

// A beam every half degree: at 3 m they are 0.026 m apart, 5 or 6 pass within 0.08 m of a position. Two
// sweeps 0.3 s apart that see nothing there show it empty, whatever stands there later; what always stood
// there shows from 2 s on; what something hides, what is nearer than 0.3 m or farther than 0.04 m / 0.0087
// rad = 4.6 m is unknown.
TEST(Evidence, KnowsWhatWasAtAPlaceBefore) {
  using Past = PastSweeps::Past;
  Stage stage;
  PastSweeps past;
  const auto look = [&](double t, std::optional<double> range) {
    stage.begin(t);
    if (range) stage.hide({3.0, 0.0}, 0.3, *range);
    past.add(stage.set(), t);
  };
  look(0.0, std::nullopt);
  look(0.1, std::nullopt);  // too soon to be kept
  EXPECT_EQ(past.at({3.0, 0.0}, 0.1), Past::unknown);
  look(0.3, std::nullopt);
  for (int k = 2; k < 100; ++k) look(0.3 * k, 2.95);
  EXPECT_EQ(past.at({3.0, 0.0}, 30.0), Past::empty);
  EXPECT_EQ(past.at({4.7, 0.0}, 30.0), Past::unknown);
  EXPECT_EQ(past.at({0.2, 0.0}, 30.0), Past::unknown);
  for (int k = 100; k < 250; ++k) look(0.3 * k, 2.95);  // 150 sweeps are kept
  EXPECT_EQ(past.at({3.0, 0.0}, 75.0), Past::occupied);
  past.reset();
  for (int k = 0; k < 7; ++k) look(0.3 * k, 2.95);
  EXPECT_EQ(past.at({3.0, 0.0}, 1.8), Past::unknown);
  EXPECT_EQ(past.at({3.0, 0.0}, 2.4), Past::occupied);
  past.reset();  // seen, missed for a while, seen again: it was there, or something as thin
  for (int k = 0; k < 30; ++k) look(0.3 * k, k == 20 || k == 21 ? std::nullopt : std::optional(2.95));
  EXPECT_EQ(past.at({3.0, 0.0}, 9.0), Past::unknown);
  past.reset();
  for (int k = 0; k < 100; ++k) look(0.3 * k, 2.0);
  EXPECT_EQ(past.at({3.0, 0.0}, 30.0), Past::unknown);
}

// Two legs stand where nothing was for a second: somebody has come, and is confirmed although twelve posts
// about look like legs. If something hid the position until then, they are doubted.
TEST(Evidence, WhoStandsWhereNothingWasHasCome) {
  for (const bool came : {true, false}) {
    Stage stage;
    Tracker tracker({});
    for (int k = 0; k < 60; ++k) {
      stage.begin(0.1 * k);
      for (int post = 0; post < 12; ++post) stage.add({-3.0, 0.7 * post - 4.0}, 0.9);
      if (k < 12 && !came) stage.hide({3.0, 0.0}, 0.5, 1.5);
      if (k >= 12) {
        stage.add({3.0, 0.12}, 0.9);
        stage.add({3.0, -0.12}, 0.9);
      }
      tracker.update(stage.set());
    }
    const auto confirmed = std::ranges::count_if(tracker.people(), [](const TrackedPerson& person) {
      return person.confidence >= kConfirmed && person.position.x() > 0.0;
    });
    EXPECT_EQ(confirmed, came ? 1 : 0);
  }
}

// -0.1 for each second in view, at most -2.
TEST(Evidence, TwoThatNeverMoveAreDoubted) {
  Stage stage;
  Tracker tracker({});
  double before = 1.0;
  for (int k = 0; k < 250; ++k) {
    stage.begin(0.1 * k);
    stage.add({3.0, 0.12}, 0.75);
    stage.add({3.0, -0.12}, 0.75);
    const auto& people = tracker.update(stage.set());
    if (k != 50 && k != 249) continue;
    ASSERT_EQ(people.size(), 1U);
    EXPECT_LT(people[0].confidence, before);
    before = people[0].confidence;
  }
}

// One leg stands still: a possible person within 2 s, never a confirmed one. It is set aside and back:
// confirmed, with the same id.
void expect_one_leg_is_somebody_when_it_shifts(bool becomes_background) {
  Stage stage;
  Tracker tracker({});
  for (int k = 0; k < 300; ++k) {
    stage.begin(0.1 * k);
    stage.add({3.0, k < 200 || k >= 230 ? 0.0 : 0.1}, 0.8);
    stage.set().detections.back().on_static = becomes_background && k >= 25;
    const auto& people = tracker.update(stage.set());
    if (k < 20) continue;
    ASSERT_EQ(people.size(), 1U) << k;
    EXPECT_EQ(people[0].id, 1U);
    if (k >= 200) continue;
    EXPECT_EQ(people[0].velocity.norm(), 0.0);
    EXPECT_LT(people[0].confidence, kConfirmed) << k;
  }
  EXPECT_GE(tracker.people()[0].confidence, kConfirmed);
}

TEST(Evidence, OneLegThatStandsIsPossibleUntilItShifts) { expect_one_leg_is_somebody_when_it_shifts(false); }

// What stands for 2.5 s is background: a leg that shifts there in view of a laser that stands is one no less.
TEST(Evidence, OneLegThatBecameBackgroundShifts) { expect_one_leg_is_somebody_when_it_shifts(true); }

// Two legs of which something hides an edge of the second lean by 0.06 m, both at once, among posts, and the
// laser stands: confirmed.
// They do not lean, or lean by 0.03 m, which is within what a standing disc errs: not.
TEST(Evidence, TwoLegsThatLeanAreSomebody) {
  for (const double lean : {0.0, 0.03, 0.06}) {
    Stage stage;
    Tracker tracker({});
    for (int k = 0; k < 80; ++k) {
      stage.begin(0.1 * k);
      stage.add({3.0, 0.12 + (k < 50 ? 0.0 : lean)}, 0.95);
      stage.add({3.0, -0.12 + (k < 50 ? 0.0 : lean)}, 0.95);
      stage.set().detections.back().occluded = true;
      for (int post = 2; post < 5; ++post) stage.add({-1.0 * post, 2.0}, 0.9);
      tracker.update(stage.set());
    }
    const auto person = std::ranges::find_if(tracker.people(), [](const TrackedPerson& p) {
      return (p.position - Vector2(3.0, 0.0)).norm() < 0.2;
    });
    ASSERT_NE(person, tracker.people().end());
    EXPECT_EQ(person->confidence >= kConfirmed, lean > 0.05) << lean;
  }
}

// Who walked and stands is a person, and who is hidden for half a second no less.
TEST(Evidence, WhoWalkedStaysAPerson) {
  Stage stage;
  Tracker tracker({});
  walk(stage, tracker, 0, 15);
  ASSERT_EQ(tracker.people().size(), 1U);
  const double walking = tracker.people()[0].confidence;
  EXPECT_GE(walking, 0.99);
  for (int k = 15; k < 20; ++k) {
    stage.begin(0.1 * k);
    stage.hide({3.0, -2.0 + 0.1 * k}, 0.8, 1.5);
    ASSERT_EQ(tracker.update(stage.set()).size(), 1U);
    EXPECT_NEAR(tracker.people()[0].confidence, walking, 0.02);  // few guesses have gone 0.75 m astray
  }
  for (int k = 20; k < 300; ++k) {
    stage.begin(0.1 * k);
    stage.walker(0.0, 0.0, 0.0, 0.6);
    tracker.update(stage.set());
  }
  ASSERT_EQ(tracker.people().size(), 1U);
  EXPECT_EQ(tracker.people()[0].id, 1U);
  EXPECT_GE(tracker.people()[0].confidence, 0.99);
}

}  // namespace
}  // namespace bw::people
