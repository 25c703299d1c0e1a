// Memory of the tracker while people come and go for long. BANDWAGON_PEOPLE_MINUTES=60: an hour of virtual
// time in place of five minutes.
#include <array>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>
#include <malloc.h>

#include "tests/components/people/tracker_stage.hpp"

namespace bw::people {
namespace {

/// Walks straight on from anywhere for 8 s, then somebody else does, from elsewhere.
struct Passer {
  Vector2 start{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double since = -1e9;

  void show(Stage& stage, double t, Random& random) {
    if (t - since > 8.0) {
      start = {random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
      velocity = random.uniform(0.5, 1.4) * direction(random.uniform(0.0, 2.0 * std::numbers::pi));
      since = t;
    }
    const Vector2 along = velocity.normalized();
    const Vector2 across(-along.y(), along.x());
    const double walked = velocity.norm() * (t - since);
    const double swing = 0.15 * std::sin(2.0 * std::numbers::pi * walked / 1.4);
    for (const double side : {1.0, -1.0})
      stage.add(start + walked * along + side * (0.12 * across + swing * along), 0.9);
  }
};

double kilobytes_in_use() { return static_cast<double>(mallinfo2().uordblks) / 1024.0; }

// Everybody who was ever lost would be 6 people * 3.5 kB every 8 s: 760 kB in five minutes. What is
// remembered for 20 s comes and goes with who is about, so the most of a minute is compared.
TEST(Tracker, TakesNoMoreMemoryWithTime) {
  const char* asked = std::getenv("BANDWAGON_PEOPLE_MINUTES");
  const int minutes = asked == nullptr ? 5 : std::max(5, std::atoi(asked));
  Stage stage;
  Tracker tracker({});
  Random random(5);
  std::array<Passer, 6> passers;
  for (std::size_t i = 0; i < passers.size(); ++i) passers[i].since = -8.0 + 1.3 * static_cast<double>(i);
  double first = 0.0;
  double last = 0.0;
  std::uint32_t people = 0;
  for (int minute = 0; minute < minutes; ++minute) {
    double most = 0.0;
    for (int k = 0; k < 600; ++k) {
      const double t = 60.0 * minute + 0.1 * k;
      stage.begin(t);
      for (Passer& passer : passers) passer.show(stage, t, random);
      for (const TrackedPerson& person : tracker.update(stage.set())) people = std::max(people, person.id);
      most = std::max(most, kilobytes_in_use());
    }
    if (minute == 1) first = most;
    last = most;
  }
  std::printf("%d minutes, %u people: at most %.0f kB in use in the second minute, %.0f kB in the last\n",
              minutes, people, first, last);
  EXPECT_GE(people, 20U * static_cast<unsigned>(minutes) / 5U);
  EXPECT_LE(last, first + 100.0);
}

}  // namespace
}  // namespace bw::people
