// Who hit whom, and which contacts a drive had: closed cases.
#include "components/evaluation/contact_diary.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr double kPi = std::numbers::pi;

/// Of a robot at the origin that looks along x, and somebody at 0.6 m in direction `bearing`.
WhoHit who(double v, double bearing, const Vector2& velocity) {
  return who_hit_whom({}, {v, 0.0}, 0.6 * direction(bearing), velocity).who;
}

TEST(WhoHitWhom, ByWhoClosesInMore) {
  EXPECT_EQ(who(0.1, 0.0, {-1.0, 0.0}), WhoHit::robot_standing);  // no faster than 0.1 m/s
  EXPECT_EQ(who(0.11, 0.0, {-1.0, 0.0}), WhoHit::person_ahead);
  EXPECT_EQ(who(0.8, 0.0, {0.0, 0.0}), WhoHit::robot_closing);
  EXPECT_EQ(who(0.8, 0.0, {-0.8, 0.0}), WhoHit::robot_closing);  // as much as they do
  EXPECT_EQ(who(0.8, 0.0, {-0.9, 0.0}), WhoHit::person_ahead);
  EXPECT_EQ(who(0.8, 0.0, {0.5, 0.0}), WhoHit::robot_closing);  // from behind somebody slower
  EXPECT_EQ(who(0.5, kPi, {1.0, 0.0}), WhoHit::person_behind);  // somebody faster, from behind
  EXPECT_EQ(who(0.8, kPi / 2.0, {0.0, -1.0}), WhoHit::person_side);
  EXPECT_EQ(who(0.8, -kPi / 2.0, {0.0, 1.0}), WhoHit::person_side);
}

TEST(WhoHitWhom, SectorsAreFromTheDirectionOfTravel) {
  const auto from = [](double degrees, double v) {
    const double bearing = degrees * kPi / 180.0;
    return who(v, bearing, -2.0 * direction(bearing));
  };
  EXPECT_EQ(from(44.9, 0.5), WhoHit::person_ahead);
  EXPECT_EQ(from(45.1, 0.5), WhoHit::person_side);
  EXPECT_EQ(from(-134.9, 0.5), WhoHit::person_side);
  EXPECT_EQ(from(-135.1, 0.5), WhoHit::person_behind);
  // Backward: what is behind the robot lies ahead.
  EXPECT_EQ(from(180.0, -0.2), WhoHit::person_ahead);
  EXPECT_EQ(from(0.0, -0.2), WhoHit::person_behind);
}

// At 60 degrees: robot 0.8 cos 60 = 0.4; the person comes at 1 m/s along -y: 1 sin 60 = 0.866.
TEST(WhoHitWhom, SpeedsAreThoseAlongTheLineOfCentres) {
  const Closing closing =
      who_hit_whom({1.0, 2.0, 0.0}, {0.8, 0.3}, Vector2(1.0, 2.0) + 0.6 * direction(kPi / 3.0), {0.0, -1.0});
  EXPECT_NEAR(closing.robot, 0.4, 1e-12);
  EXPECT_NEAR(closing.person, std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(closing.bearing, kPi / 3.0, 1e-12);
}

const Footprint kRobot{0.3, {}};

/// A robot at the origin with speed `v`, and somebody (if `x` is finite) at (x, 0) who walks along -x.
TruthSample look(double v, double x, std::uint32_t id = 7) {
  TruthSample sample;
  sample.twist = {v, 0.0};
  if (std::isfinite(x)) sample.people.push_back({id, {x, 0.0}, {-1.0, 0.0}, 0.3});
  return sample;
}

constexpr double kNobody = std::numeric_limits<double>::infinity();

TEST(ContactDiary, AContactLastsUntilTheyAreTwoCentimetresApart) {
  ContactDiary diary;
  diary.add(0.0, look(0.0, 0.70), kRobot);
  diary.add(0.1, look(0.0, 0.60), kRobot);
  diary.add(0.2, look(0.0, 0.61), kRobot);
  diary.add(0.3, look(0.5, 0.59), kRobot);  // the same one, and now the robot moves
  diary.add(0.4, look(0.0, 0.63), kRobot);
  diary.add(0.5, look(0.0, 0.60), kRobot);
  ASSERT_EQ(diary.contacts().size(), 2U);
  const ContactRecord& first = diary.contacts()[0];
  EXPECT_EQ(first.person, 7U);
  EXPECT_DOUBLE_EQ(first.time, 0.1);
  EXPECT_DOUBLE_EQ(first.end, 0.3);
  EXPECT_TRUE(first.at_speed);
  EXPECT_EQ(first.closing.who, WhoHit::robot_standing);
  EXPECT_EQ(first.there_since, 0.0);
  EXPECT_FALSE(first.begins_mid_floor);
  EXPECT_FALSE(diary.contacts()[1].at_speed);
}

TEST(ContactDiary, RecordingsThatBeginOrEndInMidFloorAreKnown) {
  const auto contact_of = [](double appears, double touches, double goes) {
    ContactDiary diary;
    for (int k = 0; k <= 50; ++k) {
      const double t = 0.1 * k;
      const bool is_there = t >= appears - 1e-9 && t < goes - 1e-9;
      diary.add(t, look(0.5, is_there ? (t >= touches - 1e-9 ? 0.5 : 2.0) : kNobody), kRobot);
    }
    EXPECT_EQ(diary.contacts().size(), 1U);
    return diary.contacts().at(0);
  };
  EXPECT_FALSE(contact_of(0.0, 0.4, 9.0).begins_mid_floor);  // there since the drive began
  EXPECT_TRUE(contact_of(1.0, 1.9, 9.0).begins_mid_floor);
  EXPECT_FALSE(contact_of(1.0, 2.1, 9.0).begins_mid_floor);
  EXPECT_NEAR(contact_of(1.0, 2.1, 9.0).there_since, 1.0, 1e-9);
  EXPECT_TRUE(contact_of(0.0, 2.0, 2.5).ends_mid_floor);
  EXPECT_FALSE(contact_of(0.0, 2.0, 3.5).ends_mid_floor);
  EXPECT_FALSE(contact_of(0.0, 4.5, 9.0).ends_mid_floor);  // the drive ends, not the recording
}

}  // namespace
}  // namespace bw
