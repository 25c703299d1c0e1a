// Detector and tracker together against the truth of simulated rooms. The short version guards
// what was reached; the long one (BANDWAGON_PEOPLE_MINUTES: minutes of each scene) prints the figures.
// Parameters were chosen on other seeds (README of the tracker); change the ones here when choosing anew.
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/components/people/perception_trial.hpp"
#include "tests/shortfall.hpp"

namespace bw::people::test {
namespace {

double seconds_each(double in_short) {
  const char* minutes = std::getenv("BANDWAGON_PEOPLE_MINUTES");
  return minutes == nullptr ? in_short : 60.0 * std::atof(minutes);
}

bool is_long() { return std::getenv("BANDWAGON_PEOPLE_MINUTES") != nullptr; }

void print(const char* name, const Score& score) {
  std::printf(
      "%-28s %5.1f person-min  MOTA %.3f  MOTP %.3f m  recall %.3f  precision %.3f  switches %ld (%ld in "
      "view)  velocity %.3f (steady %.3f) m/s  confirmed %.1f s (95 %%: %.1f)\n",
      name, score.person_minutes(), score.mota(), score.motp(), score.recall(), score.precision(),
      score.switches, score.switches_seen, score.velocity_rmse(), score.steady_rmse(),
      score.confirmation_quantile(0.5), score.confirmation_quantile(0.95));
}

TEST(Perception, FollowsPeopleAroundAStandingAndADrivingRobot) {
  Score all;
  std::uint64_t seed = 801;
  for (const bool furnished : {false, true}) {
    for (const bool driving : {false, true}) {
      for (const int people : {1, 3, 6, 10, 20}) {
        SceneOptions scene{.people = people, .furnished = furnished, .driving = driving};
        const TrialRecord record = Trial(scene, {}, {}, seed++).run(seconds_each(30.0));
        char name[64];
        std::snprintf(name, sizeof name, "%2d people, %s, %s", people, furnished ? "furnished" : "bare",
                      driving ? "driving" : "standing");
        if (is_long()) print(name, record.score);
        all.add(record.score);
      }
    }
  }
  print("all", all);
  // What is asked, and held.
  EXPECT_GE(all.mota(), 0.80);
  EXPECT_LE(all.motp(), 0.10);
  EXPECT_GE(all.precision(), 0.95);
  EXPECT_LE(all.velocity_rmse(), 0.15);
  EXPECT_LE(all.confirmation_quantile(0.5), 0.5);
  // What is asked, and not held; over more minutes: README of the tracker.
  bw::test::expect_at_least("recall, unoccluded, within 6 m", 0.95, 0.92, all.recall());
  bw::test::expect_at_most("confirmed, 95 % [s]", 0.5, 1.5, all.confirmation_quantile(0.95));
  bw::test::expect_at_most("identity switches in view per 10 person-minutes", 1.0, 4.0,
                           10.0 * static_cast<double>(all.switches_seen) / all.person_minutes());
}

// Nobody is there: whatever is tracked is false. Asked: one in ten minutes.
TEST(Perception, TakesFurnitureForNobody) {
  int false_tracks = 0;
  double minutes = 0.0;
  for (std::uint64_t seed = 851; seed < 855; ++seed) {
    const double seconds = seconds_each(60.0);
    const TrialRecord record = Trial({.people = 0}, {}, {}, seed).run(seconds);
    false_tracks += record.false_tracks;
    minutes += seconds / 60.0;
  }
  std::printf("empty furnished rooms, driving: %d false tracks in %.0f minutes\n", false_tracks, minutes);
  // So few minutes hold two or three of them where one in ten minutes is the rule.
  bw::test::expect_at_most("false tracks per 10 minutes", 1.0,
                           10.0 / minutes * std::ceil(minutes / 10.0 * 3.0), 10.0 / minutes * false_tracks);
}

}  // namespace
}  // namespace bw::people::test
