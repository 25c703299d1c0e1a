// Two whose paths cross within half a metre, legs hiding legs: who keeps their identity.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/people/tracker_stage.hpp"

namespace bw::people {
namespace {

struct Passer {
  Vector2 crossing;  ///< where they are at 2 s
  double direction;
  double speed;
  double phase;         ///< of the legs
  double starts = 0.0;  ///< stands until then [s]

  Vector2 along() const { return {std::cos(direction), std::sin(direction)}; }
  Vector2 middle(double t) const { return crossing + speed * (std::max(t, starts) - 2.0) * along(); }
  Vector2 leg(double t, double side) const {
    const double swing = 0.18 * std::min(1.0, speed / 1.3) *
                         std::sin(2.0 * std::numbers::pi * speed * std::max(t, starts) / 1.4 + phase);
    const Vector2 across(-along().y(), along().x());
    return middle(t) + side * (0.1 * across + swing * along());
  }
};
using Two = std::array<Passer, 2>;

Two any_two(Random& random) {
  Two two;
  const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double between = random.uniform(0.2, 3.1);
  for (int i = 0; i < 2; ++i) {
    Passer& passer = two[static_cast<std::size_t>(i)];
    passer.crossing.x() = 3.0 + random.uniform(-0.15, 0.15);
    passer.crossing.y() = random.uniform(-0.15, 0.15);
    passer.direction = direction + i * between;
    passer.speed = random.uniform(0.5, 1.4);
    passer.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
  }
  return two;
}

/// Legs whose middle is within 0.08 m of the line of sight to a nearer leg are not seen.
void show(Stage& stage, const Two& two, double t) {
  std::vector<Vector2> legs;
  for (const Passer& passer : two)
    for (const double side : {1.0, -1.0}) legs.push_back(passer.leg(t, side));
  std::ranges::sort(legs, {}, [](const Vector2& leg) { return leg.norm(); });
  std::vector<Vector2> shown;
  for (const Vector2& leg : legs) {
    const auto hides = [&](const Vector2& nearer) {
      const double angle = std::atan2(leg.y(), leg.x()) - std::atan2(nearer.y(), nearer.x());
      return std::abs(wrap_angle(angle)) * leg.norm() < 0.08;
    };
    if (std::ranges::any_of(shown, hides)) continue;
    shown.push_back(leg);
    stage.add(leg, 0.9);
  }
}

/// Of the nearest reported within 0.3 m; 0: nobody.
std::uint32_t id_at(const Tracker& tracker, const Vector2& position) {
  std::uint32_t id = 0;
  double least = 0.3;
  for (const TrackedPerson& person : tracker.people()) {
    const double distance = (person.position - position).norm();
    if (distance >= least) continue;
    least = distance;
    id = person.id;
  }
  return id;
}

/// Whether both have at 4 s the id they had at 1.2 s; nothing when they had none then.
std::optional<bool> keep_their_ids(const Two& two, const TrackerOptions& options) {
  Stage stage;
  Tracker tracker(options);
  std::array<std::uint32_t, 2> before{};
  for (int k = 0; k <= 40; ++k) {
    const double t = 0.1 * k;
    stage.begin(t);
    show(stage, two, t);
    tracker.update(stage.set());
    if (k == 12) before = {id_at(tracker, two[0].middle(t)), id_at(tracker, two[1].middle(t))};
  }
  if (before[0] == 0 || before[1] == 0 || before[0] == before[1]) return std::nullopt;
  return id_at(tracker, two[0].middle(4.0)) == before[0] && id_at(tracker, two[1].middle(4.0)) == before[1];
}

// Measured on 3887 other crossings: 407 lose an identity, 834 when legs are never paired anew (a margin
// nothing reaches). Asked of these: 60 % of that at most, and 15 % of all.
TEST(Tracker, PairingLegsAnewKeepsIdentities) {
  TrackerOptions never;
  never.leg_reassociation.margin = 5.0;
  Random random(23);
  int all = 0;
  int lost = 0;
  int lost_without = 0;
  for (int k = 0; k < 800; ++k) {
    const Two two = any_two(random);
    const auto kept = keep_their_ids(two, {});
    const auto kept_without = keep_their_ids(two, never);
    if (!kept || !kept_without) continue;
    ++all;
    lost += *kept ? 0 : 1;
    lost_without += *kept_without ? 0 : 1;
  }
  EXPECT_GE(all, 700);
  EXPECT_LE(lost, 0.6 * lost_without);
  EXPECT_LE(lost, 0.15 * all) << "of " << all << ", " << lost_without << " without";
}

// Who stood until 0.8 s and was born standing is known by how they walked when their legs last were theirs
// for sure. Measured on 1003 other crossings: 10.0 % lose an identity, 14.8 % when known by their birth only.
TEST(Tracker, WhoIsWhoIsToldByHowTheyWalkedLately) {
  Random random(29);
  int all = 0;
  int lost = 0;
  for (int k = 0; k < 1000; ++k) {
    Two two = any_two(random);
    for (Passer& passer : two) passer.starts = 0.8;
    const auto kept = keep_their_ids(two, {});
    if (!kept) continue;
    ++all;
    lost += *kept ? 0 : 1;
  }
  EXPECT_GE(all, 600);
  EXPECT_LE(lost, 0.125 * all) << "of " << all;
}

}  // namespace
}  // namespace bw::people
