// Labels and tracks made by hand: every figure is counted beside them.
#include "components/people/score/stretch_score.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/people/score/gospa.hpp"
#include "components/people/score/sweep_view.hpp"

namespace bw::people {
namespace {

using testing::ElementsAre;

TrackedPerson track(std::uint32_t id, const Vector2& position, double confidence = 1.0) {
  TrackedPerson person;
  person.id = id;
  person.position = position;
  person.confidence = confidence;
  person.covariance.diagonal() << 0.01, 0.01, 0.1, 0.1;
  return person;
}

TEST(LabelledPaths, LeadStraightFromLabelToLabelAndNoFarther) {
  const std::vector<LabelledInstant> labels{
      {1.0, {{.id = 3, .position = {0.0, 1.0}}}},
      {1.5, {{.id = 3, .position = {1.0, 1.0}, .counted = false, .unoccluded = false}}},
      {4.0, {{.id = 3, .position = {9.0, 1.0}}}}};
  const LabelledPaths paths(labels, 1.0);
  const auto between = paths.at(1.25, 3);
  ASSERT_TRUE(between);
  EXPECT_NEAR(between->position.x(), 0.5, 1e-12);
  EXPECT_NEAR(between->velocity.x(), 2.0, 1e-12);  // 1 m in 0.5 s
  EXPECT_FALSE(between->counted);                  // hidden at one of the two labels
  EXPECT_TRUE(paths.at(1.0, 3)->counted);
  EXPECT_NEAR(paths.at(1.0, 3)->velocity.x(), 2.0, 1e-12);
  EXPECT_FALSE(paths.at(0.9, 3));
  EXPECT_FALSE(paths.at(2.0, 3));  // 2.5 s without a label
  EXPECT_EQ(paths.at(4.0, 3)->position.x(), 9.0);
  EXPECT_EQ(paths.at(4.0, 3)->velocity.x(), 0.0);  // nobody tells
  EXPECT_FALSE(paths.at(4.1, 3));
  EXPECT_FALSE(paths.at(1.0, 4));
}

/// Somebody stands at the origin for 4.5 s, labelled every 0.5 s: 10 positions.
class StandingPerson : public testing::Test {
 protected:
  StandingPerson() {
    for (int i = 0; i < 10; ++i) labels_.push_back({0.5 * i, {{.id = 1, .position = {0.0, 0.0}}}});
  }
  std::vector<LabelledInstant> labels_;
};

// 0.3^2 + 0.4^2 of who is found; half of 0.75^2 for each who is missed or false, also for a pair farther apart.
TEST(Gospa, IsTheSumOverFoundMissedAndFalse) {
  Gospa gospa;
  const double one = 0.75 * 0.75 / 2.0;
  EXPECT_EQ(gospa({}, {}), 0.0);
  EXPECT_NEAR(gospa({{0.0, 0.0}}, {}), std::sqrt(one), 1e-12);
  EXPECT_NEAR(gospa({}, {{0.0, 0.0}, {1.0, 0.0}}), std::sqrt(2.0 * one), 1e-12);
  EXPECT_NEAR(gospa({{0.0, 0.0}}, {{0.8, 0.0}}), 0.75, 1e-12);
  EXPECT_NEAR(gospa({{0.0, 0.0}, {3.0, 0.0}}, {{8.0, 8.0}, {3.0, 0.4}, {0.3, 0.0}}),
              std::sqrt(0.09 + 0.16 + one), 1e-12);
  // Not the nearest first: 0.1 m and then nobody, but 0.3 m each.
  EXPECT_NEAR(gospa({{0.0, 0.0}, {0.4, 0.0}}, {{0.3, 0.0}, {-0.3, 0.0}}), std::sqrt(0.09 + 0.01), 1e-12);
}

TEST_F(StandingPerson, IsScoredByHand) {
  std::vector<TrackedSweep> sweeps;
  for (int i = 0; i <= 45; ++i) {
    const double t = 0.1 * i;
    TrackedSweep sweep{t, {}};
    if (i >= 3) sweep.people.push_back(track(i < 24 ? 7 : 8, {0.1, 0.0}, i < 10 ? 0.3 : 0.9));
    if (i >= 29 && i <= 32) sweep.people.push_back(track(9, {5.0, 0.0}));
    if (i >= 40) sweep.people.push_back(track(10, {8.0, 8.0}, 0.2));
    sweeps.push_back(sweep);
  }
  const StretchScore score = score_stretch(labels_, sweeps, {});
  const Score& s = score.clear_mot;
  EXPECT_EQ(score.instants, 10);
  EXPECT_EQ(s.people, 10);
  EXPECT_EQ(s.matched, 8);          // all but those at 0 and 0.5 s
  EXPECT_EQ(s.false_positives, 1);  // track 9 at 3.0 s
  EXPECT_EQ(s.switches, 1);         // 7 becomes 8 before 2.5 s
  EXPECT_NEAR(s.mota(), 1.0 - (2 + 1 + 1) / 10.0, 1e-12);
  EXPECT_NEAR(s.motp(), 0.1, 1e-12);
  EXPECT_NEAR(s.person_minutes(), 4.5 / 60.0, 1e-12);
  // Together with 7 at 3 instants and with 8 at 5, of 10 of the person and 9 of tracks.
  EXPECT_EQ(s.identified, 5);
  EXPECT_NEAR(s.idf1(), 2.0 * 5.0 / (10.0 + 9.0), 1e-12);
  // Missed twice, 0.1 m off at 8 instants, with a false track at one of them.
  const double one = 0.75 * 0.75 / 2.0;
  EXPECT_NEAR(s.mean_gospa(), (2.0 * std::sqrt(one) + 7.0 * 0.1 + std::sqrt(0.01 + one)) / 10.0, 1e-12);
  EXPECT_EQ(score.possible_at_misses, 1);  // at 0.5 s
  EXPECT_EQ(score.possible_elsewhere, 2);  // track 10 at 4.0 and 4.5 s
  EXPECT_EQ(score.tracks_per_person(), 2.0);
  ASSERT_EQ(s.confirmation.size(), 1U);
  EXPECT_NEAR(s.confirmation[0], 1.0, 1e-9);  // sweep by sweep, not label by label
  EXPECT_THAT(s.walkers_confirmation, ElementsAre());

  ASSERT_EQ(score.errors.size(), 4U);
  EXPECT_EQ(score.errors[0].kind, TrackError::miss);
  EXPECT_FALSE(score.errors[0].is_possible);
  EXPECT_EQ(score.errors[1].time, 0.5);
  EXPECT_TRUE(score.errors[1].is_possible);
  EXPECT_EQ(score.errors[2].kind, TrackError::other_identity);
  EXPECT_EQ(score.errors[2].time, 2.5);
  EXPECT_EQ(score.errors[3].kind, TrackError::false_track);
  EXPECT_EQ(score.errors[3].id, 9U);
}

TEST_F(StandingPerson, IsMissedWhereNoSweepIsNear) {
  const std::vector<TrackedSweep> sweeps{{2.2, {track(1, {0.0, 0.0})}}};
  const StretchScore score = score_stretch(labels_, sweeps, {.sweep_distance = 0.25});
  EXPECT_EQ(score.clear_mot.matched, 1);  // at 2.0 s; 2.5 s is 0.3 s off
}

TEST_F(StandingPerson, IsHiddenAndNotCounted) {
  labels_[4].people[0].counted = labels_[4].people[0].unoccluded = false;
  const StretchScore score = score_stretch(labels_, {{2.0, {track(5, {0.0, 0.0})}}}, {});
  EXPECT_EQ(score.clear_mot.people, 9);
  EXPECT_EQ(score.clear_mot.matched, 0);
  EXPECT_EQ(score.clear_mot.false_positives, 0);  // a track on somebody hidden is not false
}

TEST_F(StandingPerson, JudgesTracksWithinTheArea) {
  for (LabelledInstant& instant : labels_) instant.judged = Disc{{0.0, 0.0}, 4.0};
  std::vector<TrackedSweep> sweeps;
  for (const LabelledInstant& instant : labels_)
    sweeps.push_back({instant.time, {track(1, {0.0, 0.0}), track(2, {3.0, 0.0}), track(3, {4.1, 0.0})}});
  EXPECT_EQ(score_stretch(labels_, sweeps, {}).clear_mot.false_positives, 10);
}

TEST(Predictions, AreComparedWithWhereTheWayLed) {
  std::vector<LabelledInstant> labels;
  for (int i = 0; i <= 8; ++i) labels.push_back({0.5 * i, {{.id = 2, .position = {0.5 * i, 0.0}}}});
  TrackedPerson walker = track(4, {0.0, 0.0});
  walker.predictions = {{0.8, {0.8, 0.1}, 0.01 * Eigen::Matrix2d::Identity()},
                        {1.6, {1.6, 0.3}, 0.01 * Eigen::Matrix2d::Identity()}};
  const std::vector<TrackedSweep> sweeps{{0.0, {walker}}};
  const StretchScore exact = score_stretch(labels, sweeps, {});
  ASSERT_EQ(exact.horizons.size(), 2U);
  EXPECT_EQ(exact.horizons[0].count, 1);
  EXPECT_NEAR(exact.horizons[0].mean_error(), 0.1, 1e-9);
  EXPECT_EQ(exact.horizons[0].inside, 1);  // 0.1^2 / 0.01 = 1 is below 5.99
  EXPECT_NEAR(exact.horizons[1].mean_error(), 0.3, 1e-9);
  EXPECT_EQ(exact.horizons[1].inside, 0);  // 0.3^2 / 0.01 = 9 is not
  const StretchScore labelled = score_stretch(labels, sweeps, {.label_deviation = 0.2});
  EXPECT_EQ(labelled.horizons[1].inside, 1);  // 0.3^2 / (0.01 + 0.04) = 1.8 is
  const StretchScore between = score_stretch(labels, sweeps, {.horizon_step = 1.2});
  ASSERT_EQ(between.horizons.size(), 1U);
  EXPECT_NEAR(between.horizons[0].mean_error(), 0.2, 1e-9);  // halfway from one prediction to the next
}

TEST(Stretches, AddUp) {
  StretchScore a;
  a.instants = 3;
  a.tracks = {{1, {4, 5}}};
  a.horizons = {{.ahead = 0.8, .count = 1, .distance = 0.2, .inside = 1}};
  StretchScore b;
  b.instants = 4;
  b.tracks = {{1, {4}}, {2, {}}};
  b.horizons = {{.ahead = 0.8, .count = 3, .distance = 0.2, .inside = 0}, {.ahead = 1.6, .count = 1}};
  a.add(b);
  EXPECT_EQ(a.instants, 7);
  EXPECT_EQ(a.tracks_per_person(), 1.0);  // 2, 1 and none of three people
  ASSERT_EQ(a.horizons.size(), 2U);
  EXPECT_NEAR(a.horizons[0].mean_error(), 0.1, 1e-12);
  EXPECT_EQ(a.horizons[0].share_inside(), 0.25);
}

// A wall 3 m ahead; one stands 2 m ahead, one right behind, one behind the wall, one behind the scanner, one
// far off.
TEST(SweepView, TellsWhoShows) {
  constexpr double kStep = std::numbers::pi / 180.0;
  std::vector<float> ranges;
  for (int i = -90; i <= 90; ++i) {
    const double angle = i * kStep;
    double range = 3.0 / std::max(std::cos(angle), 1e-3);
    if (std::abs(i) <= 5) range = 1.95;
    ranges.push_back(range < 10.0 ? static_cast<float>(range) : INFINITY);
  }
  const LaserSweep sweep{.angle_min = -std::numbers::pi / 2.0,
                         .angle_increment = kStep,
                         .range_min = 0.1,
                         .range_max = 10.0,
                         .ranges = ranges};
  std::vector<TruePerson> people{{.id = 1, .position = {2.0, 0.0}},
                                 {.id = 2, .position = {2.5, 0.0}},
                                 {.id = 3, .position = {4.0, 3.0}},
                                 {.id = 4, .position = {-1.0, 0.0}},
                                 {.id = 5, .position = {2.0, 9.0}}};
  look_for(sweep, 6.0, people);
  EXPECT_TRUE(people[0].counted && people[0].unoccluded);
  EXPECT_TRUE(people[1].counted && !people[1].unoccluded);  // hidden by the first
  EXPECT_FALSE(people[2].counted);
  EXPECT_FALSE(people[3].counted);
  EXPECT_FALSE(people[4].counted);
}

}  // namespace
}  // namespace bw::people
