#include "components/slam/pose_graph.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

Eigen::Matrix3d sigmas(double metres, double radians) {
  return Eigen::Vector3d{metres * metres, metres * metres, radians * radians}.asDiagonal();
}

std::vector<Pose2> optimised(const std::vector<Edge>& edges, const std::vector<Pose2>& poses) {
  Optimisation optimisation(edges, poses);
  int steps = 0;
  while (optimisation.step()) EXPECT_LT(++steps, 1000);
  return optimisation.poses();
}

double worst_distance(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, test::distance(a[k], b[k]));
  return worst;
}

Pose2 noisy(const Pose2& X, double metres, double radians, Random& random) {
  return {X.x + random.normal(0.0, metres), X.y + random.normal(0.0, metres),
          wrap_angle(X.theta + random.normal(0.0, radians))};
}

// Twice round a regular polygon of n corners with sides of 4 m.
std::vector<Pose2> rounds(std::size_t n) {
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(n);
  std::vector<Pose2> poses{{}};
  while (poses.size() < 2 * n) poses.push_back(poses.back() * Pose2{4.0, 0.0, turn});
  return poses;
}

struct Drive {
  std::vector<Pose2> truth;
  std::vector<Pose2> start;  // by odometry
  std::vector<Edge> edges;
};

// Odometry from each to the next and a loop to where it was a round before, with honest noise.
Drive two_rounds(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Drive drive;
  drive.truth = rounds(n);
  drive.start.push_back({});
  for (std::size_t k = 1; k < drive.truth.size(); ++k) {
    const Pose2 step = noisy(inverse(drive.truth[k - 1]) * drive.truth[k], 0.03, 0.01, random);
    drive.edges.push_back({k - 1, k, {step, sigmas(0.03, 0.01)}, false});
    drive.start.push_back(drive.start.back() * step);
  }
  for (std::size_t k = n; k < 2 * n; ++k) {
    const Pose2 X = noisy(inverse(drive.truth[k - n]) * drive.truth[k], 0.03, 0.01, random);
    drive.edges.push_back({k - n, k, {X, sigmas(0.03, 0.01)}, true});
  }
  return drive;
}

// Edges without noise: at the optimum nothing disagrees, so that it is the truth, whatever the covariances. A
// wrong Jacobian would not come as near in 30 steps.
TEST(PoseGraph, OptimumOfALoopWithoutNoiseIsTheTruth) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const std::vector<Pose2> truth = rounds(10);
    std::vector<Edge> edges;
    const auto add = [&](std::size_t from, std::size_t to, bool loop) {
      Eigen::Matrix3d A;
      for (int i = 0; i < 9; ++i) A(i) = random.normal();
      const Eigen::Matrix3d C = 1e-3 * (A * A.transpose() + 0.2 * Eigen::Matrix3d::Identity());
      edges.push_back({from, to, {inverse(truth[from]) * truth[to], C}, loop});
    };
    for (std::size_t k = 1; k < truth.size(); ++k) add(k - 1, k, false);
    for (std::size_t k = 10; k < truth.size(); ++k) add(k - 10, k, true);
    std::vector<Pose2> start{truth[0]};
    for (std::size_t k = 1; k < truth.size(); ++k) start.push_back(noisy(truth[k], 0.3, 0.1, random));
    const std::vector<Pose2> found = optimised(edges, start);
    EXPECT_EQ(found[0], truth[0]) << "the first does not move";
    for (std::size_t k = 0; k < truth.size(); ++k)
      ASSERT_LT(difference(found[k], truth[k]).norm(), 1e-5) << "seed " << seed << " pose " << k;
  }
}

// On a line in x alone the optimum is a weighted mean: odometry says 1 + 1 with variances 0.01 each, the loop
// 2.3 with 0.01: the error of 0.3 is shared alike by three, a third each.
TEST(PoseGraph, SharesAnErrorByVariance) {
  const std::vector<Edge> edges{{0, 1, {{1.0, 0.0, 0.0}, sigmas(0.1, 0.1)}, false},
                                {1, 2, {{1.0, 0.0, 0.0}, sigmas(0.1, 0.1)}, false},
                                {0, 2, {{2.3, 0.0, 0.0}, sigmas(0.1, 0.1)}, true}};
  const std::vector<Pose2> found = optimised(edges, {{}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}});
  EXPECT_NEAR(found[1].x, 1.1, 1e-4);
  EXPECT_NEAR(found[2].x, 2.2, 1e-4);
}

// Squared distance in standard deviations: (0.3 / 0.1)^2 + (0.2 / 0.1)^2 + (0.1 / 0.05)^2.
TEST(PoseGraph, DisagreementIsTheMahalanobisDistance) {
  const Edge edge{0, 1, {{1.0, 0.0, 0.1}, sigmas(0.1, 0.05)}, true};
  const Pose2 X{2.0, 3.0, 1.0};
  EXPECT_NEAR(disagreement(edge, {X, X * Pose2{1.3, 0.2, 0.2}}), 9.0 + 4.0 + 4.0, 1e-4);
}

// The optimum of twenty right loops errs by less than the 0.03 m of each, all the way round.
TEST(PoseGraph, LoopsTakeBackWhatOdometryLost) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Drive drive = two_rounds(20, seed);
    const std::vector<Pose2> found = optimised(drive.edges, drive.start);
    EXPECT_LT(test::distance(found[20], drive.truth[20]), 0.09) << "seed " << seed << ": three sigmas";
    EXPECT_LT(worst_distance(found, drive.truth), 1.5) << "seed " << seed;
  }
}

// One of twenty-one is false, metres off: its weight falls as 1 / s^2, so that it moves nothing by more than
// a few millimetres.
TEST(PoseGraph, AFalseLoopAmongTwentyIsTakenBack) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Drive drive = two_rounds(20, seed);
    const std::vector<Pose2> without = optimised(drive.edges, drive.start);
    Random random(seed + 100);
    const Pose2 wrong = inverse(drive.truth[5]) * drive.truth[33] *
                        Pose2{random.uniform(2.0, 8.0), random.uniform(2.0, 8.0), random.uniform(-1.0, 1.0)};
    drive.edges.push_back({5, 33, {wrong, sigmas(0.03, 0.01)}, true});
    const std::vector<Pose2> with = optimised(drive.edges, drive.start);
    EXPECT_LT(worst_distance(with, without), 0.01) << "seed " << seed;
    EXPECT_GT(disagreement(drive.edges.back(), with), 100.0);
  }
}

// Twenty odometry edges that turn 0.05 rad too far each, their sigma, end 10.5 m from where they began in
// truth: in squared sigmas of the loop more than 1e4, of which it would keep 2e-6 of its weight. What the edges
// allow is closed all the same, since the scaling begins at that disagreement and falls from there.
TEST(PoseGraph, ALoopFarOffThatOdometryAllowsIsClosed) {
  std::vector<Edge> edges;
  std::vector<Pose2> start{{}};
  const double turn = 2.0 * std::numbers::pi / 20.0;
  for (std::size_t k = 1; k <= 20; ++k) {
    const Pose2 step{4.0, 0.0, turn + 0.05};
    edges.push_back({k - 1, k, {step, sigmas(0.05, 0.05)}, false});
    start.push_back(start.back() * step);
  }
  ASSERT_GT(test::distance(start[20], start[0]), 10.0);
  edges.push_back({0, 20, {{0.0, 0.0, 0.0}, sigmas(0.03, 0.01)}, true});
  ASSERT_GT(disagreement(edges.back(), start), 1e4);
  const std::vector<Pose2> found = optimised(edges, start);
  EXPECT_LT(test::distance(found[20], found[0]), 0.1);
  EXPECT_LT(disagreement(edges.back(), found), 7.8) << "it counts in full";
}

// Along a chain it is the sum that the surest path has; two edges that agree say it twice as surely; and a loop that the
// poses contradict by far says nothing.
TEST(PoseGraph, TheMarginalIsOfAllEdgesTogether) {
  Random random(3);
  std::vector<Pose2> poses{test::random_pose(random, 5.0, 3.0)};
  std::vector<Edge> chain;
  for (std::size_t k = 1; k < 5; ++k) {
    poses.push_back(poses.back() * test::random_pose(random, 4.0, 1.0));
    chain.push_back({k - 1, k, {inverse(poses[k - 1]) * poses[k], sigmas(0.05, 0.02)}, false});
  }
  const Eigen::Matrix3d sum = relative_to(0, chain, poses)[4].covariance;
  const UncertainPose of_chain = marginal(4, 0, chain, poses);
  EXPECT_LT((of_chain.covariance - sum).norm(), 1e-5 * sum.norm());  // 1e-9 is added to each edge
  EXPECT_LT(test::distance(of_chain.X, inverse(poses[0]) * poses[4]), 1e-12);

  std::vector<Edge> twice{chain[0], chain[0]};
  twice[1].loop = true;
  EXPECT_LT((marginal(1, 0, twice, poses).covariance - 0.5 * chain[0].X.covariance).norm(), 1e-8);

  twice[1].X.X.x += 50.0;
  EXPECT_LT((marginal(1, 0, twice, poses).covariance - chain[0].X.covariance).norm(), 1e-8);
}

TEST(PoseGraph, OfNothingIsFinishedAtOnce) {
  EXPECT_FALSE(Optimisation({}, {}).step());
  EXPECT_FALSE(Optimisation({}, {{1.0, 2.0, 0.3}}).step());
  EXPECT_EQ(Optimisation({}, {{1.0, 2.0, 0.3}}).poses().front(), (Pose2{1.0, 2.0, 0.3}));
}

// A chain has one way: the covariance is that of the product along it, forwards and backwards.
TEST(RelativeTo, SumsAlongTheOnlyWay) {
  const Drive drive = two_rounds(6, 3);
  std::vector<Edge> chain;
  for (const Edge& edge : drive.edges)
    if (!edge.loop) chain.push_back(edge);
  const std::vector<UncertainPose> others = relative_to(5, chain, drive.start);
  ASSERT_EQ(others.size(), drive.start.size());
  UncertainPose after;
  for (std::size_t k = 6; k < drive.start.size(); ++k) {
    after = after * chain[k - 1].X;
    EXPECT_LT(difference(others[k].X, after.X).norm(), 1e-9);
    EXPECT_LT((others[k].covariance - after.covariance).norm(), 1e-9 * after.covariance.norm());
  }
  UncertainPose before;
  for (std::size_t k = 5; k-- > 0;) {
    before = before * inverse(chain[k].X);
    EXPECT_LT(difference(others[k].X, before.X).norm(), 1e-9);
    EXPECT_LT((others[k].covariance - before.covariance).norm(), 1e-9 * before.covariance.norm());
  }
  EXPECT_EQ(others[5].covariance.norm(), 0.0);
}

// Two ways from 0 to 2: over 1 by two edges of 1 m sigma, or at once. The surer counts, whichever it is; and
// a loop that the poses contradict is none.
TEST(RelativeTo, TakesTheSurerOfTwoWays) {
  const std::vector<Pose2> poses{{}, {4.0, 0.0, 0.0}, {8.0, 0.0, 0.0}};
  std::vector<Edge> edges{{0, 1, {{4.0, 0.0, 0.0}, sigmas(0.1, 0.001)}, false},
                          {1, 2, {{4.0, 0.0, 0.0}, sigmas(0.1, 0.001)}, false},
                          {0, 2, {{8.0, 0.0, 0.0}, sigmas(0.05, 0.001)}, true}};
  EXPECT_NEAR(relative_to(0, edges, poses)[2].covariance(0, 0), 0.05 * 0.05, 1e-9) << "at once";
  edges[2].X.covariance = sigmas(0.5, 0.001);
  EXPECT_NEAR(relative_to(0, edges, poses)[2].covariance(0, 0), 2 * 0.1 * 0.1, 1e-9) << "over 1";
  edges[2].X = {{9.0, 0.0, 0.0}, sigmas(0.05, 0.001)};
  EXPECT_NEAR(relative_to(0, edges, poses)[2].covariance(0, 0), 2 * 0.1 * 0.1, 1e-9) << "20 sigmas off";
}

}  // namespace
}  // namespace bw::slam
