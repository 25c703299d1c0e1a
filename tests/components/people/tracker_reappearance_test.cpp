// Whether somebody who appears was lost, by where the guesses are.
#include <gtest/gtest.h>

#include "components/people/tracker/reappearance.hpp"
#include "tests/components/people/tracker_sightings.hpp"
#include "tests/components/people/tracker_stage.hpp"

namespace bw::people {
namespace {

/// Who was seen last at `position`, and is hidden since this moment.
PersonTrack hidden_at(std::uint32_t id, const Vector2& position, const Vector2& velocity = {0.0, 0.0}) {
  Random random(id);
  PersonTrack person{.id = id, .walker = Walker(position, position, velocity, 1e-4, 1.0)};
  person.hidden.emplace(position, velocity, random, HiddenOptions{});
  return person;
}

PersonTrack seen_at(std::uint32_t id, const Vector2& position) {
  return {.id = id, .walker = Walker(position, position, {0.0, 0.0}, 1e-4, 1.0)};
}

std::vector<std::uint32_t> ids(const std::vector<PersonTrack>& people) {
  std::vector<std::uint32_t> ids;
  for (const PersonTrack& person : people) ids.push_back(person.id);
  return ids;
}

const Sighting kFirst = sighting(20, {0.0, 0.0});  // at 2.0 s at the origin

std::uint32_t id_of(const std::optional<PersonTrack>& person) { return person ? person->id : 0; }

// The nearer first, then the other; who was 4 m away is not taken for them.
TEST(Reappearance, TheMostLikelyIsTaken) {
  std::vector<PersonTrack> people;
  std::vector<PersonTrack> lost{hidden_at(3, {0.8, 0.0}), hidden_at(4, {0.0, 0.4}), hidden_at(5, {4.0, 0.0})};
  const auto take = [&] { return take_returned(people, lost, kFirst, Vector2(0.0, 0.0), 2.0, {}); };
  EXPECT_EQ(id_of(take()), 4U);
  EXPECT_EQ(ids(lost), (std::vector<std::uint32_t>{3, 5}));
  EXPECT_EQ(id_of(take()), 3U);
  EXPECT_EQ(id_of(take()), 0U);
  EXPECT_EQ(ids(lost), std::vector<std::uint32_t>{5});
}

// Of two at the same position: who was going that way. Nothing known of the velocity: either.
TEST(Reappearance, TheWayTheyGoTells) {
  std::vector<PersonTrack> people;
  const std::vector<PersonTrack> two{hidden_at(3, {0.1, 0.0}, {1.0, 0.0}),
                                     hidden_at(4, {0.1, 0.0}, {-1.0, 0.0})};
  for (const double sense : {1.0, -1.0}) {
    std::vector<PersonTrack> lost = two;
    EXPECT_EQ(id_of(take_returned(people, lost, kFirst, Vector2(sense, 0.0), 2.0, {})),
              sense > 0.0 ? 3U : 4U);
  }
  std::vector<PersonTrack> lost = two;
  EXPECT_NE(id_of(take_returned(people, lost, kFirst, std::nullopt, 2.0, {})), 0U);
}

// First seen 1 s ago at the origin, where who is at x = 1 m now at 1 m/s was then.
TEST(Reappearance, GuessesAreComparedWithThen) {
  std::vector<PersonTrack> people;
  std::vector<PersonTrack> lost{hidden_at(3, {0.0, 0.0}, {1.0, 0.0}), hidden_at(4, {1.0, 0.0}, {1.0, 0.0})};
  EXPECT_EQ(id_of(take_returned(people, lost, kFirst, Vector2(1.0, 0.0), 3.0, {})), 4U);
}

// Id 1 is seen for sure and stays, though nearest; id 2 is hidden, and nearer than id 3, who was let go.
TEST(Reappearance, WhoIsSeenForSureIsNotTaken) {
  std::vector<PersonTrack> people{seen_at(1, {0.0, 0.0}), hidden_at(2, {0.2, 0.0})};
  std::vector<PersonTrack> lost{hidden_at(3, {0.6, 0.0})};
  EXPECT_EQ(id_of(take_returned(people, lost, kFirst, Vector2(0.0, 0.0), 2.0, {})), 2U);
  EXPECT_EQ(ids(people), std::vector<std::uint32_t>{1});
  EXPECT_EQ(ids(lost), std::vector<std::uint32_t>{3});
}

// Many newcomers: somebody new is likelier than somebody 0.8 m away.
TEST(Reappearance, NewcomersMayBeLikelier) {
  std::vector<PersonTrack> people;
  std::vector<PersonTrack> lost{hidden_at(3, {0.8, 0.0})};
  HiddenOptions options;
  options.newcomers = 0.5;
  EXPECT_EQ(id_of(take_returned(people, lost, kFirst, Vector2(0.0, 0.0), 2.0, options)), 0U);
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

// Last seen at 1.4 s, let go 1 s later. Who walks on 2 s after, where they would be by then, is the same; who walks
// there 25 s after (more than 20 s) is somebody new.
TEST(Tracker, WhoComesBackLateIsNew) {
  for (const int sweeps : {20, 250}) {
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
      stage.walker(0.1 * (k - sweeps) + 2.0, 1.0, -2.0);
      tracker.update(stage.set());
    }
    ASSERT_EQ(tracker.people().size(), 1U);
    EXPECT_EQ(tracker.people()[0].id, sweeps == 20 ? 1U : 2U);
  }
}

}  // namespace
}  // namespace bw::people
