// The tracker with several sensors: two lasers of half a view each, and a camera that tells of whole people.
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "tests/components/people/tracker_stage.hpp"

namespace bw::people {
namespace {

constexpr int kFront = 0;
constexpr int kRear = 1;

/// Two lasers at the origin: the front one sees y < 0, the rear one y > 0. Somebody goes along x = 3 m.
class TwoLasers {
 public:
  void sweep(int source, double t, double y, double speed) {
    stage_.begin(t);
    DetectionSet& set = stage_.set();
    set.source = source;
    if ((y < 0.0) == (source == kFront)) legs(t, y, speed);
    const auto middle = set.free_ranges.begin() + 360;  // towards +x
    if (source == kFront) set.free_ranges.erase(middle, set.free_ranges.end());
    if (source == kRear) set.free_ranges.erase(set.free_ranges.begin(), middle);
    set.angle_min = source == kFront ? -std::numbers::pi : 0.0;
    tracker.update(set);
    set.angle_min = -std::numbers::pi;
  }

  Tracker tracker{TrackerOptions{}};

 private:
  void legs(double t, double y, double speed) {
    const double swing = 0.18 * speed / 1.3 * std::sin(2.0 * std::numbers::pi * speed * t / 1.4);
    stage_.add({3.12, y + swing}, 0.9);
    stage_.add({2.88, y - swing}, 0.9);
  }
  Stage stage_;
};

// As the front laser alone: a walker at 1.2 m/s is a person within 0.5 s (TracksWalker of one laser); the
// other's sweeps change nothing.
TEST(TrackerSensors, WhoIsSeenByTheRearLaserAloneIsAPersonAsSoon) {
  TwoLasers lasers;
  double confirmed = -1.0;
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.1 * k;
    lasers.sweep(kFront, t, 0.5 + 1.2 * t, 1.2);
    lasers.sweep(kRear, t + 0.05, 0.5 + 1.2 * (t + 0.05), 1.2);
    if (confirmed < 0.0 && !lasers.tracker.people().empty()) confirmed = t + 0.05;
  }
  ASSERT_EQ(lasers.tracker.people().size(), 1U);
  EXPECT_GE(confirmed, 0.2);
  EXPECT_LE(confirmed, 0.55);
  EXPECT_NEAR(lasers.tracker.people()[0].position.y(), 0.5 + 1.2 * 2.05, 0.05);
  EXPECT_NEAR(lasers.tracker.people()[0].velocity.y(), 1.2, 0.15);
}

// From y = -2 to 2 m at 1 m/s: seen by the front laser until 2 s, by the rear one after; interleaved sweeps,
// and sweeps of one time.
TEST(TrackerSensors, WhoPassesFromFrontToRearStaysTheSame) {
  for (const double apart : {0.05, 0.013, 0.0}) {
    TwoLasers lasers;
    for (int k = 0; k <= 40; ++k) {
      const double t = 0.1 * k;
      lasers.sweep(kFront, t, -2.0 + t, 1.0);
      lasers.sweep(kRear, t + apart, -2.0 + t + apart, 1.0);
      if (k < 5) continue;
      ASSERT_EQ(lasers.tracker.people().size(), 1U) << apart << " " << t;
    }
    EXPECT_EQ(lasers.tracker.people()[0].id, 1U) << apart;
    EXPECT_NEAR(lasers.tracker.people()[0].position.y(), 2.0, 0.08) << apart;
    EXPECT_NEAR(lasers.tracker.people()[0].velocity.y(), 1.0, 0.15) << apart;
  }
}

// The rear laser looks elsewhere: its sweeps do not make anybody absent, however many come.
TEST(TrackerSensors, OutOfALasersViewIsNotAbsent) {
  TwoLasers lasers;
  for (int k = 0; k <= 10; ++k) lasers.sweep(kFront, 0.1 * k, -1.0, 0.0);
  ASSERT_EQ(lasers.tracker.people().size(), 1U);
  for (int k = 0; k < 8; ++k) lasers.sweep(kRear, 1.1 + 0.1 * k, -1.0, 0.0);
  ASSERT_EQ(lasers.tracker.people().size(), 1U);
  EXPECT_NEAR(lasers.tracker.people()[0].position.y(), -1.0, 0.05);
}

// A sweep that comes after a later one of another laser, or twice, changes nothing.
TEST(TrackerSensors, SweepsOutOfOrderAreLeftOut) {
  TwoLasers lasers;
  for (int k = 0; k <= 10; ++k) lasers.sweep(kFront, 0.1 * k, -1.0, 0.0);
  const Vector2 before = lasers.tracker.people().at(0).position;
  lasers.sweep(kRear, 0.97, 1.0, 0.0);
  lasers.sweep(kFront, 1.0, -1.3, 0.0);
  EXPECT_EQ(lasers.tracker.people().at(0).position, before);
  EXPECT_EQ(lasers.tracker.cluster_count(), 0U);
}

HeardSet told(double t, const Vector2& position, double reliability) {
  return {Time::seconds(t), {{.position = position, .reliability = reliability}}};
}

// b1 = trust r, b2 = 1 - (1 - b1 exp(-dt / memory)) (1 - trust r), ... : confirmed by reliability and
// repetition.
TEST(TrackerSensors, ACameraAloneMakesAPossiblePersonAndRepetitionAPerson) {
  for (const double reliability : {0.9, 0.4}) {
    Tracker tracker({});
    double belief = 0.0;
    int confirmed = -1;
    for (int k = 0; k < 12; ++k) {
      belief = 1.0 - (1.0 - belief * std::exp(-0.1 / 2.0)) * (1.0 - 0.4 * reliability);
      const auto& people = tracker.hear(told(100.0 + 0.1 * k, {2.0, 0.1 * k}, reliability));
      ASSERT_EQ(people.size(), 1U);
      EXPECT_EQ(people[0].id, 1U);
      EXPECT_NEAR(people[0].confidence, belief, 1e-9);
      if (confirmed < 0 && people[0].confidence >= kConfirmed) confirmed = k;
    }
    EXPECT_EQ(confirmed, reliability > 0.5 ? 1 : 4);
    EXPECT_NEAR(tracker.people()[0].position.y(), 1.1, 0.2);
    EXPECT_NEAR(tracker.people()[0].velocity.y(), 1.0, 0.4);
  }
}

// Below half a second of silence a person still, gone when the belief has sunk to 0.2: 2 s ln(0.89 / 0.2) =
// 3.0 s.
TEST(TrackerSensors, WhomNobodyTellsOfAnyMoreFades) {
  Tracker tracker({});
  for (int k = 0; k < 20; ++k) tracker.hear(told(100.0 + 0.1 * k, {2.0, 0.0}, 0.9));
  EXPECT_GT(tracker.people().at(0).confidence, 0.8);
  double confirmed_until = 0.0;
  double there_until = 0.0;
  Stage stage;
  for (int k = 1; k < 50; ++k) {  // a laser that looks the other way
    stage.begin(101.9 + 0.1 * k);
    stage.set().free_ranges.clear();
    const auto& people = tracker.update(stage.set());
    if (!people.empty()) there_until = 0.1 * k;
    if (!people.empty() && people[0].confidence >= kConfirmed) confirmed_until = 0.1 * k;
  }
  EXPECT_NEAR(confirmed_until, 2.0 * std::log(0.85 / 0.5), 0.15);
  EXPECT_LE(there_until, 2.0 * std::log(0.85 / 0.2) + 0.15);
  EXPECT_GE(there_until, 1.0);
}

// The laser follows a walker; a camera tells of them with errors of 0.2 m, 0.15 s late. One person, where the
// laser says.
TEST(TrackerSensors, CameraAndLaserDoNotDouble) {
  Stage stage;
  Tracker tracker({});
  Random random(3);
  for (int k = 0; k <= 60; ++k) {
    const double t = 0.1 * k;
    stage.begin(t);
    stage.walker(t, 1.0, -3.0);
    tracker.update(stage.set());
    const Vector2 there(3.0 + random.normal(0.0, 0.2), -3.0 + (t - 0.15) + random.normal(0.0, 0.2));
    if (k >= 2) tracker.hear(told(t - 0.15, there, 0.8));
    ASSERT_LE(tracker.people().size(), 1U) << t;
    if (k < 10) continue;
    EXPECT_NEAR(tracker.people().at(0).position.y(), -3.0 + t, 0.06) << t;
    EXPECT_NEAR(tracker.people().at(0).position.x(), 3.0, 0.06) << t;
  }
  EXPECT_EQ(tracker.people()[0].id, 1U);
  EXPECT_GT(tracker.people()[0].confidence, 0.9);
}

// Legs that the laser takes for furniture (score 0.35): nobody. A camera tells of somebody there, 0.15 m
// beside: a person, with the laser's position, after two messages.
TEST(TrackerSensors, ACameraMakesAPersonOfWhatOnlyStands) {
  Stage stage;
  Tracker tracker({});
  for (int k = 0; k <= 30; ++k) {
    stage.begin(0.1 * k);
    stage.add({3.1, 1.0}, 0.35);
    stage.add({2.9, 1.0}, 0.35);
    tracker.update(stage.set());
    for (const TrackedPerson& person : tracker.people()) EXPECT_LT(person.confidence, kConfirmed);
  }
  for (int k = 31; k <= 40; ++k) {
    stage.begin(0.1 * k);
    stage.add({3.1, 1.0}, 0.35);
    stage.add({2.9, 1.0}, 0.35);
    tracker.update(stage.set());
    tracker.hear(told(0.1 * k, {3.15, 1.0}, 0.9));
  }
  ASSERT_EQ(tracker.people().size(), 1U);
  EXPECT_GE(tracker.people()[0].confidence, kConfirmed);
  EXPECT_NEAR(tracker.people()[0].position.x(), 3.0, 0.03);
}

// Told of where a laser sees nothing for longer than death.unseen: possible, not confirmed; gone when nobody
// tells any more.
TEST(TrackerSensors, WhereTheLaserSeesNothingNobodyIsConfirmed) {
  Stage stage;
  Tracker tracker({});
  for (int k = 0; k <= 40; ++k) {
    stage.begin(0.1 * k);
    tracker.update(stage.set());
    tracker.hear(told(0.1 * k, {3.0, 1.0}, 1.0));
    ASSERT_EQ(tracker.people().size(), 1U);
    if (k <= 12) continue;
    EXPECT_LT(tracker.people()[0].confidence, 0.46);
  }
  EXPECT_EQ(tracker.people()[0].id, 1U);
  for (int k = 41; k <= 52; ++k) {
    stage.begin(0.1 * k);
    tracker.update(stage.set());
  }
  EXPECT_TRUE(tracker.people().empty());
}

// Told of for 2 s, then their legs walk into the laser's view: the same person, once.
TEST(TrackerSensors, WhoWasToldOfIsTheSameWhenALaserSeesThem) {
  Stage stage;
  Tracker tracker({});
  for (int k = 0; k <= 50; ++k) {
    const double t = 0.1 * k;
    stage.begin(t);
    if (k < 20) stage.set().free_ranges.clear();
    if (k >= 20) stage.walker(t, 1.0, -3.0);
    tracker.update(stage.set());
    tracker.hear(told(t, {3.0, -3.0 + t}, 0.9));
    ASSERT_EQ(tracker.people().size(), 1U) << t;
    EXPECT_EQ(tracker.people()[0].id, 1U) << t;
  }
  EXPECT_NEAR(tracker.people()[0].position.y(), 2.0, 0.05);
}

TEST(TrackerSensors, WhatIsNoPersonIsNotBelieved) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Tracker tracker({});
  HeardSet set{Time::seconds(10.0), {}};
  set.people.push_back({.position = {kNan, 1.0}});
  set.people.push_back({.position = {1.0, 1.0}, .velocity = {kNan, 0.0}});
  set.people.push_back({.position = {2.0, 1.0}, .reliability = kNan});
  set.people.push_back({.position = {3.0, 1.0}, .reliability = -0.1});
  set.people.push_back({.position = {4.0, 1.0}, .reliability = 1.1});
  EXPECT_TRUE(tracker.hear(set).empty());
  set.people.push_back({.position = {5.0, 1.0}, .reliability = 0.5});
  set.people.push_back({.position = {5.2, 1.0}, .reliability = 0.9});  // the same, told twice
  set.time = Time::seconds(10.1);
  ASSERT_EQ(tracker.hear(set).size(), 1U);
  EXPECT_NEAR(tracker.people()[0].position.x(), 5.2, 1e-6);
  EXPECT_TRUE(tracker.hear({Time::seconds(3.0), {{.position = {8.0, 0.0}}}}).size() == 1U);  // of long ago
}

}  // namespace
}  // namespace bw::people
