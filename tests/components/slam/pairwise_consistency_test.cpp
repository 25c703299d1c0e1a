#include "components/slam/pairwise_consistency.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

Eigen::Matrix3d isotropic(double metres, double radians) {
  return Eigen::Vector3d{metres * metres, metres * metres, radians * radians}.asDiagonal();
}

// Submaps k and k + 20 are of one place, with honest noise between neighbours and in each loop.
struct Revisited {
  std::vector<Submap> submaps = std::vector<Submap>(40);
  std::vector<Loop> loops;

  explicit Revisited(std::uint64_t seed) {
    Random random(seed);
    const auto drawn = [&](const Pose2& X) -> Pose2 {
      return {X.x + random.normal(0.0, 0.02), X.y + random.normal(0.0, 0.02),
              wrap_angle(X.theta + random.normal(0.0, 0.005))};
    };
    const Pose2 step{2.0, 0.0, 2.0 * std::numbers::pi / 20.0};
    for (std::size_t k = 1; k < 40; ++k) submaps[k].X_PS = {drawn(step), isotropic(0.02, 0.005)};
    for (std::size_t k = 0; k < 8; ++k) {
      Loop loop;
      loop.edge = {k, k + 20, {drawn({}), isotropic(0.02, 0.005)}, true};
      loops.push_back(loop);
    }
  }
};

// Squared distances of what is right are chi^2 of three degrees of freedom: mean 3, and 1 % above 11.3. 400
// of them.
TEST(PairwiseConsistency, RightLoopsAgreeAsChiSquareSays) {
  double sum = 0.0;
  int above = 0;
  constexpr int kDraws = 400;
  for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
    const Revisited drive(seed);
    const double d = inconsistency(drive.loops[1], drive.loops[4], drive.submaps);
    EXPECT_NEAR(d, inconsistency(drive.loops[4], drive.loops[1], drive.submaps), 0.2 * d + 0.05)
        << "either way round";
    sum += d;
    above += d > 11.3;
  }
  EXPECT_NEAR(sum / kDraws, 3.0, 0.5) << "sigma of the mean: sqrt(6 / 400) = 0.12";
  EXPECT_LE(above, 12);
}

// Closed form: two loops of 0.02 m that say the same but for 0.3 m in x, with the ways between their ends known
// exactly: 0.3^2 / (2 * 0.02^2).
TEST(PairwiseConsistency, IsTheSquaredDistanceInSigmas) {
  std::vector<Submap> submaps(12);
  Loop a;
  a.edge = {0, 10, {{0.0, 0.0, 0.0}, isotropic(0.02, 0.005)}, true};
  Loop b = a;
  b.edge.from = 1;
  b.edge.to = 11;
  b.edge.X.X.x = 0.3;
  EXPECT_NEAR(inconsistency(a, b, submaps), 0.09 / (2.0 * 0.0004), 1e-6);
}

// A metre from each submap to the next, and a second drive that began 1 m beside submap 2: submap 9 lies at (3, 1). The
// way from there to submap 7 goes by the fork, and is far where the first drive was long before.
TEST(PairwiseConsistency, GoesByTheForkWhereAMapWasContinued) {
  std::vector<Submap> submaps(10);
  for (Submap& submap : submaps) submap.X_PS.X = {1.0, 0.0, 0.0};
  submaps[8].found_in = 2;
  submaps[8].X_PS.X = {0.0, 1.0, 0.0};
  Loop a;
  a.edge = {3, 7, {{4.0, 0.0, 0.0}, isotropic(0.02, 0.005)}, true};
  Loop b;
  b.edge = {4, 9, {{-1.0, 1.0, 0.0}, isotropic(0.02, 0.005)}, true};
  EXPECT_NEAR(inconsistency(a, b, submaps), 0.0, 1e-9);
  b.edge.X.X.x += 0.3;
  EXPECT_NEAR(inconsistency(a, b, submaps), inconsistency(b, a, submaps), 1e-6);
  EXPECT_GT(inconsistency(a, b, submaps), 11.3);
  std::vector<Submap> longer(16);
  longer[15].found_in = 0;
  a.edge.to = 14;
  b.edge.to = 15;
  EXPECT_TRUE(std::isinf(inconsistency(a, b, longer)));
}

TEST(PairwiseConsistency, AFalseLoopHasNoSupporters) {
  int all = 0;
  int false_ones = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Revisited drive(seed);
    Random random(seed + 1000);
    Loop wrong;
    wrong.edge = {
        3, 25, {{random.uniform(1.0, 4.0), random.uniform(1.0, 4.0), 0.4}, isotropic(0.02, 0.005)}, true};
    drive.loops.push_back(wrong);
    const std::vector<std::size_t> of_right = supporters(2, drive.loops, drive.submaps);
    EXPECT_EQ(of_right.front(), 2U);
    all += of_right.size() == 8;
    for (const std::size_t k : of_right) false_ones += k == 8;
    EXPECT_EQ(supporters(8, drive.loops, drive.submaps), (std::vector<std::size_t>{8})) << "seed " << seed;
    // Each pair of a set agrees: that is what the set is.
    for (std::size_t i = 0; i < of_right.size(); ++i)
      for (std::size_t k = i + 1; k < of_right.size(); ++k)
        EXPECT_LE(inconsistency(drive.loops[of_right[i]], drive.loops[of_right[k]], drive.submaps), 11.3);
  }
  EXPECT_EQ(false_ones, 0);
  EXPECT_GE(all, 30) << "28 pairs at 1 % each, which are not independent";
}

// Loops whose ends are more than ten submaps apart say nothing of each other, and neither do two of one pair.
TEST(PairwiseConsistency, FarLoopsAndTwinsDoNotSupport) {
  std::vector<Submap> submaps(40);
  Loop a;
  a.edge = {0, 20, {{}, isotropic(0.02, 0.005)}, true};
  Loop far = a;
  far.edge.from = 11;
  EXPECT_TRUE(std::isinf(inconsistency(a, far, submaps)));
  EXPECT_EQ(supporters(0, std::vector<Loop>{a, a, far}, submaps), (std::vector<std::size_t>{0}));
  Loop near = a;
  near.edge.from = 10;
  EXPECT_EQ(supporters(0, std::vector<Loop>{a, near}, submaps), (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace bw::slam
