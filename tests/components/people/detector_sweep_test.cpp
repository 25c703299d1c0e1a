// Beams, clusters and what is done with sweeps that are none.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "components/people/detector/clusters.hpp"
#include "components/people/detector/detector.hpp"
#include "components/people/detector/neighbours.hpp"
#include "tests/components/people/detector_scan.hpp"

namespace bw::people {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

LaserSweep sweep_of(const std::vector<float>& ranges, double increment = 0.01) {
  return {Time::seconds(1.0), {}, 0.0, increment, 0.05, 10.0, ranges};
}

Clusters clusters_of(const std::vector<float>& ranges, double increment = 0.01,
                     const ClusterOptions& options = {}) {
  Beams beams;
  read_beams(sweep_of(ranges, increment), beams);
  Clusters clusters;
  find_clusters(beams, std::vector<std::uint8_t>(ranges.size(), 0), options, clusters);
  return clusters;
}

TEST(DetectorSweep, EveryBeamIsAHitFreeOrUnknown) {
  const std::vector<float> ranges = {2.0F, kInfinity, -kInfinity, kNan, 0.0F, -1.0F, 0.04F, 10.5F, 10.0F};
  Beams beams;
  read_beams(sweep_of(ranges), beams);
  using enum BeamKind;
  EXPECT_EQ(beams.kinds, (std::vector{hit, free, unknown, unknown, unknown, unknown, unknown, unknown, hit}));
  EXPECT_EQ(beams.ranges, (std::vector<float>{2.0F, 10.0F, 0, 0, 0, 0, 0, 0, 10.0F}));
}

TEST(DetectorSweep, AScannerThatTurnsTheOtherWaySeesTheSame) {
  const std::vector<float> ranges = {1.0F, 2.0F, 3.0F};
  const std::vector<float> reversed = {3.0F, 2.0F, 1.0F};
  Beams forwards;
  read_beams({{}, {1.0, 2.0, 0.3}, 0.1, 0.2, 0.05, 10.0, ranges}, forwards);
  Beams backwards;
  read_beams({{}, {1.0, 2.0, 0.3}, 0.5, -0.2, 0.05, 10.0, reversed}, backwards);
  EXPECT_NEAR(forwards.angle_min, 0.4, 1e-12);
  EXPECT_NEAR(backwards.angle_min, forwards.angle_min, 1e-12);
  EXPECT_NEAR(backwards.angle_increment, forwards.angle_increment, 1e-12);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT((backwards.points[i] - forwards.points[i]).norm(), 1e-12);
}

TEST(DetectorSweep, FaultsOfAWholeSweepAreNamedAndNothingIsSeen) {
  const std::vector<float> some(10, 1.0F);
  const std::vector<float> many(20'001, 1.0F);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto fault = [&](auto change) {
    LaserSweep sweep = sweep_of(some);
    change(sweep);
    Detector detector(DetectorOptions{});
    const DetectionSet& set = detector.detect(sweep, {});
    EXPECT_TRUE(set.detections.empty() && set.free_ranges.empty());
    return fault_for_people(sweep);
  };
  EXPECT_EQ(fault_for_people(sweep_of(some)), SweepFault::none);
  EXPECT_EQ(fault([](LaserSweep& s) { s.ranges = {}; }), SweepFault::wrong_length);
  EXPECT_EQ(fault([&](LaserSweep& s) { s.ranges = many; }), SweepFault::wrong_length);
  EXPECT_EQ(fault([&](LaserSweep& s) { s.angle_min = nan; }), SweepFault::bad_angles);
  EXPECT_EQ(fault([&](LaserSweep& s) { s.angle_increment = nan; }), SweepFault::bad_angles);
  EXPECT_EQ(fault([](LaserSweep& s) { s.angle_increment = 0.0; }), SweepFault::bad_angles);
  EXPECT_EQ(fault([](LaserSweep& s) { s.angle_increment = 1.0; }), SweepFault::bad_angles);
  EXPECT_EQ(fault([](LaserSweep& s) { s.angle_increment = 0.3; }), SweepFault::bad_angles);
  EXPECT_EQ(fault([&](LaserSweep& s) { s.range_max = nan; }), SweepFault::bad_limits);
  EXPECT_EQ(fault([](LaserSweep& s) { s.range_min = 20.0; }), SweepFault::bad_limits);
  const std::vector<float> blind(10, kNan);
  EXPECT_EQ(fault([&](LaserSweep& s) { s.ranges = blind; }), SweepFault::mostly_unknown);
  EXPECT_EQ(fault([&](LaserSweep& s) { s.X_FL.theta = nan; }), SweepFault::bad_pose);
}

TEST(DetectorClusters, JumpsPartThemAndEdgesSayWhatLiesBeyond) {
  // 3 beams at 2 m, 3 at 1 m (nearer by 1 m), a free beam, 2 at 2 m, unusable, end.
  const Clusters clusters = clusters_of({2, 2, 2, 1, 1, 1, kInfinity, 2, 2, kNan});
  ASSERT_EQ(clusters.all.size(), 3U);
  EXPECT_EQ(clusters.all[0].count, 3);
  EXPECT_TRUE(clusters.all[0].right.occluded);  // end of the field of view
  EXPECT_TRUE(clusters.all[0].left.occluded);
  EXPECT_NEAR(clusters.all[0].left.jump, -1.0, 1e-6);
  EXPECT_FALSE(clusters.all[1].right.occluded);
  EXPECT_NEAR(clusters.all[1].right.jump, 1.0, 1e-6);
  EXPECT_NEAR(clusters.all[1].left.jump, 9.0, 1e-6);  // free up to range_max = 10 m
  EXPECT_FALSE(clusters.all[2].right.occluded);
  EXPECT_TRUE(clusters.all[2].left.occluded);
}

TEST(DetectorClusters, UnusableBeamsAreBridgedFreeOnesAreNot) {
  EXPECT_EQ(clusters_of({2, 2, kNan, kNan, 2, 2}).all.size(), 1U);
  EXPECT_EQ(clusters_of({2, 2, kNan, kNan, kNan, 2, 2}).all.size(), 2U);  // bridge is 2
  EXPECT_EQ(clusters_of({2, 2, kInfinity, 2, 2}).all.size(), 2U);
}

TEST(DetectorClusters, TheThresholdGrowsWithTheDistanceBetweenBeams) {
  // Two beams 0.05 rad apart at 4 m end 0.2 m apart; the limit is 0.13 + 0.5 * 0.2 = 0.23 m.
  EXPECT_EQ(clusters_of({4, 4, 4}, 0.05).all.size(), 1U);
  ClusterOptions fixed;
  fixed.growth = 0.0;
  fixed.min_points = 1;
  EXPECT_EQ(clusters_of({4, 4, 4}, 0.05, fixed).all.size(), 3U);
}

TEST(DetectorClusters, OneThingAcrossTheSeamOfAFullTurnIsOneCluster) {
  const int beams = 360;
  std::vector<float> ranges(beams, kInfinity);
  for (const int i : {357, 358, 359, 0, 1}) ranges[static_cast<std::size_t>(i)] = 1.0F;
  const Clusters clusters = clusters_of(ranges, 2.0 * std::numbers::pi / beams);
  ASSERT_EQ(clusters.all.size(), 1U);
  EXPECT_EQ(clusters.members, (std::vector{357, 358, 359, 0, 1}));
  // The same when everything around is one wall.
  EXPECT_EQ(clusters_of(std::vector<float>(beams, 1.0F), 2.0 * std::numbers::pi / beams).all.size(), 1U);
}

TEST(DetectorClusters, ALegBeforeItsWallLeavesItWhenTheWallIsBackground) {
  Beams beams;
  // 0.10 m before the wall: nearer than jump, farther than edge_jump + half a beam at 1 m.
  read_beams(sweep_of({1, 1, 1, 0.9F, 0.9F, 0.9F, 1, 1, 1}), beams);
  Clusters clusters;
  find_clusters(beams, {0, 0, 0, 0, 0, 0, 0, 0, 0}, {}, clusters);
  EXPECT_EQ(clusters.all.size(), 1U);
  find_clusters(beams, {1, 1, 1, 0, 0, 0, 1, 1, 1}, {}, clusters);
  EXPECT_EQ(clusters.all.size(), 3U);
}

TEST(DetectorFuzz, NoSweepBreaksItAndWhatComesOutIsFinite) {
  Random random(5);
  Detector detector(DetectorOptions{});
  std::vector<float> ranges;
  const std::vector<float> odd = {kNan,   kInfinity, -kInfinity, 0.0F,
                                  -0.0F,  -1.0F,     1e30F,      -1e30F,
                                  1e-30F, 0.05F,     10.0F,      std::numeric_limits<float>::max()};
  for (int i = 0; i < 3000; ++i) {
    ranges.resize(static_cast<std::size_t>(random.uniform(0.0, 800.0)));
    const double share_odd = random.uniform() < 0.2 ? 1.0 : random.uniform() * 0.3;
    double range = random.uniform(0.1, 10.0);
    for (float& r : ranges) {
      range += random.uniform() < 0.1 ? random.normal() : 0.01 * random.normal();
      r = random.uniform() < share_odd
              ? odd[static_cast<std::size_t>(random.uniform() * static_cast<double>(odd.size()))]
              : static_cast<float>(range);
    }
    // A stamp on the wire has 32 bits of seconds: any two differ by less than 64 bits of nanoseconds.
    const LaserSweep sweep{Time{static_cast<std::int64_t>(random.bits()) / 4},
                           {1e3 * random.normal(), random.normal(), random.uniform(-3.0, 3.0)},
                           random.uniform(-7.0, 7.0),
                           random.uniform(-0.02, 0.02),
                           0.05,
                           10.0,
                           ranges};
    const DetectionSet& set = detector.detect(sweep, {});
    ASSERT_TRUE(set.free_ranges.empty() || set.free_ranges.size() == ranges.size());
    for (const float free : set.free_ranges) ASSERT_TRUE(free >= 0.0F && free <= 10.0F);
    for (const Detection& d : set.detections) {
      ASSERT_TRUE(d.position.allFinite() && d.covariance.allFinite()) << "sweep " << i;
      ASSERT_GT(d.covariance.determinant(), 0.0);
      ASSERT_TRUE(d.leg_score >= 0.0 && d.leg_score <= 1.0 && d.body_score >= 0.0 && d.body_score <= 1.0);
    }
  }
}

TEST(DetectorSweep, NarrowThingsKnowWhatIsNarrowBesideThem) {
  // At 2 m, three beams each 0.01 rad apart: middles at beams 11, 31 and 81, 2 cos(0.01) m away; and a thing
  // of 60 beams, 1.2 m, that is not narrow.
  std::vector<float> ranges(300, 5.0F);
  for (const std::size_t middle : {11, 31, 81})
    for (std::size_t i = middle - 1; i <= middle + 1; ++i) ranges[i] = 2.0F;
  std::fill(ranges.begin() + 100, ranges.begin() + 160, 2.0F);
  Beams beams;
  read_beams(sweep_of(ranges), beams);
  Clusters clusters;
  find_clusters(beams, std::vector<std::uint8_t>(ranges.size(), 0), {}, clusters);
  NeighbourSearch search;
  const std::vector<Neighbours>& found = search.find(beams, clusters);
  std::vector<Neighbours> narrow;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (clusters.all[i].count == 3) narrow.push_back(found[i]);
  ASSERT_EQ(narrow.size(), 3U);
  const auto apart = [](double beams_between) {
    return 2.0 * 2.0 * std::cos(0.01) * std::sin(0.01 * beams_between / 2.0);
  };
  EXPECT_NEAR(narrow[0].nearest, apart(20), 1e-6);  // 0.40 m
  EXPECT_NEAR(narrow[0].second, apart(70), 1e-6);   // 1.37 m
  EXPECT_EQ(narrow[0].about, 1);
  EXPECT_NEAR(narrow[1].second, apart(50), 1e-6);  // 0.99 m
  EXPECT_EQ(narrow[1].about, 2);
  EXPECT_NEAR(narrow[2].nearest, apart(50), 1e-6);
  EXPECT_NEAR(narrow[2].width, 2.0 * 2.0 * std::sin(0.01), 1e-6);
  EXPECT_EQ(narrow[2].about, 1);
}

}  // namespace
}  // namespace bw::people
