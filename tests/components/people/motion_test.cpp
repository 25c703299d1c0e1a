// Settings of the motion's filter side by side in simulated rooms. The short
// version guards the choice; the long one (BANDWAGON_PEOPLE_MINUTES: minutes of each room) prints the table
// of the tracker's README. Parameters were chosen on other seeds (3001 to 3012, 3101 to 3112).
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/people/motion_score.hpp"
#include "tests/shortfall.hpp"

namespace bw::people::test {
namespace {

struct Candidate {
  std::string name;
  TrackerOptions options;
};

std::vector<Candidate> candidates() {
  const TrackerOptions heading;
  TrackerOptions gliding = heading;  // never has a heading
  gliding.heading.walking_speed = 100.0;
  gliding.heading.acceleration_standing = 0.5;
  TrackerOptions as_planned = heading;
  as_planned.heading.heading_noise = 0.5;
  as_planned.heading.acceleration = as_planned.heading.acceleration_standing = 0.8;
  as_planned.heading.position_noise = 0.05;
  return {{"heading", heading}, {"constant velocity", gliding}, {"heading, noise first planned", as_planned}};
}

/// Twelve rooms: 3, 8, 20 people; bare and furnished; robot standing and driving.
std::vector<MotionScore> rooms(const TrackerOptions& options, double seconds) {
  std::vector<MotionScore> scores;
  std::uint64_t seed = 2001;
  for (const bool furnished : {false, true}) {
    for (const bool driving : {false, true}) {
      for (const int people : {3, 8, 20}) {
        Trial trial({.people = people, .furnished = furnished, .driving = driving}, {}, options, seed++);
        scores.push_back(MotionJudge(trial).run(seconds));
      }
    }
  }
  return scores;
}

MotionScore sum(const std::vector<MotionScore>& scores) {
  MotionScore all;
  for (const MotionScore& score : scores) all.add(score);
  return all;
}

void print(const std::string& name, const std::vector<MotionScore>& scores,
           const std::vector<MotionScore>& first) {
  const MotionScore all = sum(scores);
  int faster = 0;
  int foreseen = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    faster += scores[i].score.velocity_rmse() < first[i].score.velocity_rmse() ? 1 : 0;
    foreseen += scores[i].straight[1].value() < first[i].straight[1].value() ? 1 : 0;
  }
  std::printf(
      "%-22s velocity %.4f (steady %.4f) m/s  MOTP %.4f m  NEES %.2f (steady %.2f, %.3f within 95 %%)  "
      "straight on %.4f / %.4f m  turning %.4f / %.4f m  better in %d, %d of %zu rooms  %ld velocities\n",
      name.c_str(), all.score.velocity_rmse(), all.score.steady_rmse(), all.score.motp(), all.nees.value(),
      all.nees_steady.value(), all.inside_95.value(), all.straight[0].value(), all.straight[1].value(),
      all.rotating[0].value(), all.rotating[1].value(), faster, foreseen, scores.size(),
      all.score.velocities);
  std::fflush(stdout);
}

// The default is to foresee people best: 2 % of 1.6 s ahead are what separates them in an hour of rooms, so
// none may be better than it by as much. A true covariance has NEES 2; asked of the velocity is 1.5 to 2.5.
TEST(Motion, ReportsTheBetterFilter) {
  const char* minutes = std::getenv("BANDWAGON_PEOPLE_MINUTES");
  const double seconds = minutes == nullptr ? 15.0 : 60.0 * std::atof(minutes);
  const MotionScore chosen = sum(rooms({}, seconds));
  std::vector<MotionScore> first;
  for (const Candidate& candidate : candidates()) {
    const std::vector<MotionScore> scores = rooms(candidate.options, seconds);
    if (first.empty()) first = scores;
    print(candidate.name, scores, first);
    const MotionScore all = sum(scores);
    EXPECT_LE(chosen.straight[1].value(), 1.02 * all.straight[1].value()) << candidate.name;
  }
  // Asked 0.15 m/s, measured 0.123. The candidate that is as good has 0.121, the one that is worse 0.139 in the same
  // rooms: halfway is a loss.
  EXPECT_LE(chosen.score.velocity_rmse(), 0.133);
  EXPECT_LE(chosen.score.motp(), 0.10);
  EXPECT_GE(chosen.nees.value(), 1.5);
  EXPECT_LE(chosen.nees.value(), 2.5);
  // Of those who walk on steadily: 1.58 with errors of 0.083 m/s, 1.36 with 0.074. The same share of the covariance is
  // true for all.
  bw::test::expect_at_least("NEES of who keeps their velocity", {1.5, 1.36, 0.1}, chosen.nees_steady.value());
  EXPECT_LE(chosen.nees_steady.value(), 2.5);
}

}  // namespace
}  // namespace bw::people::test
