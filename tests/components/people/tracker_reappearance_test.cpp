// Whether somebody who appears was lost, against the arithmetic of the options' defaults: slack 0.5 m, speed
// 1.5 m/s, deviation 0.4 m/s, remembered 6 s, absent 0.25 s.
#include <gtest/gtest.h>

#include "components/people/tracker/reappearance.hpp"
#include "tests/components/people/tracker_sightings.hpp"
#include "tests/components/people/tracker_stage.hpp"

namespace bw::people {
namespace {

const PastState kLost{10.0, {0.0, 0.0}, {1.0, 0.0}};  // along x at 1 m/s when last seen

// In 2 s people get 0.5 + 1.5 * 2 = 3.5 m far, in none 0.5 m.
TEST(Reappearance, NobodyIsFasterThanPeople) {
  for (const Vector2& way : {Vector2(1.0, 0.0), Vector2(-1.0, 0.0), Vector2(0.6, 0.8)}) {
    EXPECT_TRUE(doubt_of_return(kLost, 3.49 * way, 12.0, {}));
    EXPECT_FALSE(doubt_of_return(kLost, 3.51 * way, 12.0, {}));
    EXPECT_TRUE(doubt_of_return(kLost, 0.49 * way, 9.5, {}));
    EXPECT_FALSE(doubt_of_return(kLost, 0.51 * way, 9.5, {}));
  }
}

TEST(Reappearance, ForgottenAfterSixSeconds) {
  EXPECT_TRUE(doubt_of_return(kLost, {0.0, 0.0}, 15.99, {}));
  EXPECT_FALSE(doubt_of_return(kLost, {0.0, 0.0}, 16.01, {}));
}

// After 2 s at 1 m/s: no doubt from 2 m back to 2 m on; beyond and aside 0.5 + 0.4 * 2 = 1.3 m count one.
TEST(Reappearance, DoubtCountsFromWhereTheyWouldBe) {
  const auto doubt = [](double x, double y) { return doubt_of_return(kLost, {x, y}, 12.0, {}).value(); };
  for (const double x : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    EXPECT_NEAR(doubt(x, 0.0), 0.0, 1e-12) << x;
    EXPECT_NEAR(doubt(x, -0.65), 0.5, 1e-12) << x;
  }
  EXPECT_NEAR(doubt(3.3, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(doubt(-2.65, 0.0), 0.5, 1e-12);
}

// Who stood: from their place only.
TEST(Reappearance, WhoStoodIsExpectedThere) {
  const PastState stood{10.0, {1.0, 1.0}, {0.0, 0.0}};
  EXPECT_NEAR(doubt_of_return(stood, {2.3, 1.0}, 12.0, {}).value(), 1.0, 1e-12);
}

PersonTrack seen_at(std::uint32_t id, double time, const Vector2& place) {
  return {.id = id, .walker = Walker(place, place, {0.0, 0.0}, 1e-4, 1.0), .sure = {time, place, {0.0, 0.0}}};
}

std::vector<std::uint32_t> ids(const std::vector<PersonTrack>& people) {
  std::vector<std::uint32_t> ids;
  for (const PersonTrack& person : people) ids.push_back(person.id);
  return ids;
}

// First seen at 2.0 s at the origin. Doubts 1.0 / 0.9 (id 3) and 0.6 / 0.9 (id 4): 4 is taken, then 3, then
// nobody.
TEST(Reappearance, TheMostLikelyIsTaken) {
  std::vector<PersonTrack> people;
  std::vector<PersonTrack> lost{seen_at(3, 1.0, {1.0, 0.0}), seen_at(4, 1.0, {0.0, 0.6}),
                                seen_at(5, 1.0, {2.1, 0.0})};  // who would have to do 2.1 m in 1 s
  const Sighting first = sighting(20, {0.0, 0.0});
  const auto take = [&] { return take_returned(people, lost, first, 2.2, {}); };
  auto taken = take();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->id, 4U);
  EXPECT_EQ(ids(lost), (std::vector<std::uint32_t>{3, 5}));
  taken = take();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->id, 3U);
  EXPECT_FALSE(take());
  EXPECT_EQ(ids(lost), std::vector<std::uint32_t>{5});
}

// At 2.2 s id 1 was seen for sure 0.2 s ago (< 0.25 s) and stays, though nearest; id 2 was not for 0.3 s, and
// is nearer than id 3, who was let go.
TEST(Reappearance, WhoIsSeenForSureIsNotTaken) {
  std::vector<PersonTrack> people{seen_at(1, 2.0, {0.0, 0.0}), seen_at(2, 1.9, {0.2, 0.0})};
  std::vector<PersonTrack> lost{seen_at(3, 1.9, {0.4, 0.0})};
  const Sighting first = sighting(20, {0.0, 0.0});
  const auto taken = take_returned(people, lost, first, 2.2, {});
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->id, 2U);
  EXPECT_EQ(ids(people), std::vector<std::uint32_t>{1});
  EXPECT_EQ(ids(lost), std::vector<std::uint32_t>{3});
}

// 1 m/s along y until 1.4 s at y = -0.6 m, then 1.5 s behind a pillar: turns half way and comes out at
// y = -0.6 m, away from where the filter expects them (y = 0.9 m).
TEST(Tracker, WhoTurnsRoundBehindAPillarKeepsTheirId) {
  Stage stage;
  Tracker tracker({});
  const auto sweep = [&](int k, double walked) {
    stage.begin(0.1 * k);
    stage.hide({3.0, 0.5}, 1.2, 1.5);  // y = -0.7 m to 1.7 m
    if (k < 15 || k >= 30) stage.walker(walked, 1.0, -2.0);
    tracker.update(stage.set());
  };
  for (int k = 0; k < 40; ++k) sweep(k, 0.1 * (k < 22 ? k : 44 - k));
  ASSERT_EQ(tracker.people().size(), 1U);
  EXPECT_EQ(tracker.people()[0].id, 1U);
  EXPECT_NEAR(tracker.people()[0].position.y(), -1.5, 0.1);
  EXPECT_NEAR(tracker.people()[0].velocity.y(), -1.0, 0.2);
}

// Last seen at 1.4 s, let go 1 s later. Who walks up at the same place 5 s after is the same, 7 s after (more
// than 6 s) somebody new.
TEST(Tracker, WhoComesBackLateIsNew) {
  for (const int sweeps : {50, 70}) {
    Stage stage;
    Tracker tracker({});
    walk(stage, tracker, 0, 15);
    ASSERT_EQ(tracker.people().size(), 1U);
    for (int k = 15; k < 15 + sweeps; ++k) {
      stage.begin(0.1 * k);
      tracker.update(stage.set());
    }
    ASSERT_TRUE(tracker.people().empty());
    for (int k = 15 + sweeps; k < 25 + sweeps; ++k) {
      stage.begin(0.1 * k);
      stage.walker(0.1 * (k - sweeps), 1.0, -2.0);
      tracker.update(stage.set());
    }
    ASSERT_EQ(tracker.people().size(), 1U);
    EXPECT_EQ(tracker.people()[0].id, sweeps == 50 ? 1U : 2U);
  }
}

}  // namespace
}  // namespace bw::people
