// Which detection is which leg: how far a leg may be, and what lies on background.
#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "components/people/tracker/matching.hpp"
#include "tests/components/people/tracker_sightings.hpp"

namespace bw::people {
namespace {

const Vector2 kFirst(0.0, 0.12);
const Vector2 kSecond(0.0, -0.12);
constexpr double kNow = 2.0;  // [s]

PersonTrack somebody(double variance, double unseen) {
  return {.walker = Walker(kFirst, kSecond, {0.0, 0.0}, variance, 1.0), .unseen = {unseen, kSweepTime}};
}

Detection detection(const Vector2& position, double score = 0.9) {
  Detection d;
  d.position = position;
  d.covariance = 1e-4 * Eigen::Matrix2d::Identity();
  d.leg_score = score;
  return d;
}

// With gates that let all pass: 0.3 m, and 2 m/s since that leg was seen, 1.2 m in all.
TEST(Matching, ReachGrowsWithTime) {
  AssociationOptions options;
  options.gate = 100.0;
  struct Case {
    double unseen;
    double reach;
  };
  for (const auto& [unseen, reach] :
       {Case{0.025, 0.35}, Case{0.1, 0.5}, Case{0.2, 0.7}, Case{0.4, 1.1}, Case{1.0, 1.2}}) {
    for (const bool within : {true, false}) {
      const Vector2 off(0.0, within ? reach - 0.01 : reach + 0.01);
      Matching of_leg;
      const std::vector<PersonTrack> people{somebody(1.0, unseen)};
      of_leg.match({detection(kFirst + off), detection(kSecond)}, people, {}, kNow, options);
      EXPECT_EQ(of_leg.of_person(0).first, within ? 0 : -1) << unseen << " s";
      EXPECT_EQ(of_leg.of_person(0).second, 1);
      EXPECT_EQ(of_leg.taken(0), within);

      Matching of_cluster;
      const ClusterTrack cluster = standing({0.0, 0.0}, 20);
      of_cluster.match({detection(off)}, {}, {cluster}, kNow + unseen, options);
      EXPECT_EQ(of_cluster.of_cluster(0), within ? 0 : -1) << unseen << " s";
    }
  }
}

// A detection 0.10 m off on background costs a leg as much as one r off that stands free when
// (r^2 - 0.10^2) / s = 2, s the variance of prediction, detection and slack together: 0.25 m here.
TEST(Matching, BackgroundCostsALeg) {
  const std::vector<PersonTrack> people{somebody(0.01, kSweepTime)};
  const Eigen::Matrix2d spread = people[0].walker.spread(BodyPart::first_leg);
  const double even = std::sqrt(0.01 + 2.0 * (spread(0, 0) + 1e-4 + 0.12 * 0.12));
  EXPECT_NEAR(even, 0.25, 0.02);
  for (const double off : {even - 0.02, even + 0.02}) {
    std::vector<Detection> detections{detection(kFirst + Vector2(0.10, 0.0)),
                                      detection(kFirst - Vector2(off, 0.0)), detection(kSecond)};
    detections[0].on_static = true;
    Matching matching;
    matching.match(detections, people, {}, kNow, {});
    EXPECT_EQ(matching.of_person(0).first, off < even ? 1 : 0);
    EXPECT_EQ(matching.of_person(0).second, 2);
  }
}

}  // namespace
}  // namespace bw::people
