// The filter of headings inside the tracker: what it is told of legs, and that people are the same with it.
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/people/tracker/heading_track.hpp"
#include "components/people/tracker/tracker.hpp"

namespace bw::people {
namespace {

Detection at(const Vector2& position, double variance, double leg_score = 0.9, double body_score = 0.0) {
  Detection d;
  d.position = position;
  d.covariance = variance * Eigen::Matrix2d::Identity();
  d.width = 0.12;
  d.points = 8;
  d.leg_score = leg_score;
  d.body_score = body_score;
  return d;
}

HeadingOptions exact() {
  HeadingOptions options;
  options.position_noise = 0.02;
  return options;
}

const Walker kWalker({1.2, 0.1}, {0.8, -0.1}, {1.0, 0.0}, 1e-3, 0.1);  // middle (1, 0), legs at +-(0.2, 0.1)

// (R1 + R2) / 4 = (0.0004 + 0.0008) / 4 = 0.0003, and 0.02^2 = 0.0004.
TEST(SeenMiddle, OfTwoLegsIsHalfWay) {
  const Detection first = at({1.3, 0.2}, 4e-4);
  const Detection second = at({0.9, -0.1}, 8e-4);
  const auto middle = seen_middle({&first, &second}, kWalker, exact());
  ASSERT_TRUE(middle);
  EXPECT_LE((middle->position - Vector2(1.1, 0.05)).norm(), 1e-12);
  EXPECT_LE((middle->covariance - 7e-4 * Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

// Either leg: its position less the swing of +-(0.2, 0.1); the variance of the swing is 0.001 / 2 when both
// legs have just been seen with 0.001 each.
TEST(SeenMiddle, OfOneLegIsASwingAway) {
  const Detection first = at({1.3, 0.2}, 4e-4);
  const auto of_first = seen_middle({&first, nullptr}, kWalker, exact());
  ASSERT_TRUE(of_first);
  EXPECT_LE((of_first->position - Vector2(1.1, 0.1)).norm(), 1e-12);
  EXPECT_LE((of_first->covariance - (4e-4 + 5e-4 + 4e-4) * Eigen::Matrix2d::Identity()).norm(), 1e-12);
  const Detection second = at({0.9, -0.1}, 4e-4);
  const auto of_second = seen_middle({nullptr, &second}, kWalker, exact());
  ASSERT_TRUE(of_second);
  EXPECT_LE((of_second->position - Vector2(1.1, 0.0)).norm(), 1e-12);
}

TEST(SeenMiddle, OfTwoLegsInOneIsTheirs) {
  const Detection both = at({1.3, 0.2}, 4e-4, 0.1, 0.8);
  const auto middle = seen_middle({nullptr, &both}, kWalker, exact());
  ASSERT_TRUE(middle);
  EXPECT_LE((middle->position - both.position).norm(), 1e-12);
  EXPECT_FALSE(seen_middle({}, kWalker, exact()));
}

/// A sensor at the origin that sees all round, and somebody who walks past it at (3, y).
DetectionSet sweep_of(double t, double speed, Random& random) {
  DetectionSet sweep;
  sweep.time = Time::seconds(10.0 + t);
  sweep.angle_min = -std::numbers::pi;
  sweep.angle_increment = 2.0 * std::numbers::pi / 720.0;
  sweep.free_ranges.assign(720, 2.0F);
  const double swing = 0.18 * std::min(1.0, speed / 1.3) * std::sin(2.0 * std::numbers::pi * speed * t / 1.4);
  const Vector2 middle(3.0, -2.0 + speed * t);
  for (const double side : {1.0, -1.0}) {
    const double x = random.normal(0.0, 0.01);
    sweep.detections.push_back(
        at(middle + side * Vector2(0.12, swing) + Vector2(x, random.normal(0.0, 0.01)), 1e-4));
  }
  return sweep;
}

// Asked of the velocity: 0.15 m/s after 1 s.
TEST(TrackerWithHeading, KnowsTheVelocityAfterASecond) {
  Tracker tracker({});
  Random random(3);
  double square = 0.0;
  int count = 0;
  for (int k = 0; k <= 40; ++k) {
    const auto& people = tracker.update(sweep_of(0.1 * k, 1.1, random));
    if (people.empty()) continue;
    EXPECT_EQ(people[0].covariance.llt().info(), Eigen::Success);
    if (k < 14) continue;
    square += (people[0].velocity - Vector2(0.0, 1.1)).squaredNorm();
    ++count;
    EXPECT_NEAR(people[0].position.y(), -2.0 + 0.11 * k, 0.05);
  }
  ASSERT_GE(count, 20);
  EXPECT_LE(std::sqrt(square / count), 0.15);
}

// Detections that come and go anywhere: finite people with positive definite covariances.
TEST(TrackerWithHeading, SurvivesNonsense) {
  Tracker tracker({});
  Random random(11);
  long people = 0;
  for (int k = 0; k < 2000; ++k) {
    DetectionSet sweep = sweep_of(0.1 * (k % 40), 1.0, random);
    sweep.time = Time::seconds(10.0 + 0.1 * k);
    if (random.uniform() < 0.2) sweep.detections.pop_back();
    for (int i = 0; i < 5; ++i) {
      const double x = random.uniform(-5, 5);
      sweep.detections.push_back(at({x, random.uniform(-5, 5)}, std::pow(10.0, random.uniform(-12, 0)),
                                    random.uniform(), random.uniform()));
    }
    for (const TrackedPerson& person : tracker.update(sweep)) {
      ++people;
      ASSERT_TRUE(person.position.allFinite() && person.velocity.allFinite());
      ASSERT_EQ(person.covariance.llt().info(), Eigen::Success);
    }
  }
  EXPECT_GE(people, 1000);
}

}  // namespace
}  // namespace bw::people
