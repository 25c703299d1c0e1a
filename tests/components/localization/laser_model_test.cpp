// The vectorised kernel against the sum written out.
#include "components/localization/laser/laser_model.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::localization {
namespace {

OccupancyGrid scattered(Random& random) {
  OccupancyGrid map{.resolution = 0.05, .origin = {-3.0, -2.0}, .width = 200, .height = 160};
  for (int i = 0; i < map.width * map.height; ++i) {
    const double u = random.uniform();
    map.cells.push_back(u < 0.01  ? OccupancyGrid::kOccupied
                        : u < 0.3 ? OccupancyGrid::kUnknown
                                  : OccupancyGrid::kFree);
  }
  return map;
}

ParticleSet particles_around(Random& random, std::size_t count) {
  ParticleSet set;
  set.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    set.x[i] = random.uniform(-5.0, 9.0);
    set.y[i] = random.uniform(-4.0, 8.0);
    set.theta[i] = random.uniform(-std::numbers::pi, std::numbers::pi);
    set.weight[i] = 1.0 / static_cast<double>(count);
  }
  return set;
}

BeamEnds random_ends(Random& random, int count) {
  BeamEnds ends;
  for (int i = 0; i < count; ++i) {
    ends.x.push_back(static_cast<float>(random.uniform(-6.0, 6.0)));
    ends.y.push_back(static_cast<float>(random.uniform(-6.0, 6.0)));
  }
  return ends;
}

TEST(LaserModel, AddsTheSumOfLogsOverBeamsTimesTheShare) {
  Random random(4);
  const OccupancyGrid map = scattered(random);
  LikelihoodFieldOptions options;
  options.effective_beams = 15.0;
  const LikelihoodField field(map, options);
  // Neither a multiple of any vector's width nor of the block of 1024.
  const ParticleSet particles = particles_around(random, 2501);
  for (const int count : {1, 7, 60}) {
    const BeamEnds ends = random_ends(random, count);
    std::vector<double> log_weight(particles.size(), 0.5);
    add_log_weights(field, ends, particles, log_weight);
    const double share = std::min(1.0, 15.0 / count);
    int at_borders = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const Pose2 X_MB{particles.x[i], particles.y[i], particles.theta[i]};
      double sum = 0.0;
      for (std::size_t b = 0; b < ends.size(); ++b) {
        const Vector2 end = X_MB * Vector2{static_cast<double>(ends.x[b]), static_cast<double>(ends.y[b])};
        sum += field.log_likelihood(end.x(), end.y());
      }
      // An end within float rounding of a cell's border may fall to the neighbour.
      if (std::abs(log_weight[i] - 0.5 - share * sum) > 1e-3) ++at_borders;
    }
    EXPECT_LE(at_borders, 2 + count / 5) << count;  // 2501 * count ends, 1e-5 of a cell's width each
  }
}

TEST(LaserModel, SurvivesParticlesThatAreNoNumbers) {
  Random random(5);
  const LikelihoodField field(scattered(random), {});
  ParticleSet particles = particles_around(random, 20);
  particles.x[3] = std::numeric_limits<double>::quiet_NaN();
  particles.y[4] = std::numeric_limits<double>::infinity();
  particles.theta[5] = std::numeric_limits<double>::quiet_NaN();
  particles.x[6] = 1e300;
  std::vector<double> log_weight(particles.size(), 0.0);
  add_log_weights(field, random_ends(random, 60), particles, log_weight);
  for (const double w : log_weight) EXPECT_TRUE(std::isfinite(w));
}

TEST(LaserModel, NoBeamsSayNothing) {
  Random random(6);
  const LikelihoodField field(scattered(random), {});
  const ParticleSet particles = particles_around(random, 5);
  std::vector<double> log_weight(particles.size(), -1.0);
  add_log_weights(field, {}, particles, log_weight);
  for (const double w : log_weight) EXPECT_EQ(w, -1.0);
  EXPECT_EQ(scan_fit(field, {}, {}).known, 0.0);
}

TEST(LaserModel, FitOfOneEndOneSigmaAwayAndOneUnknown) {
  // One obstacle cell at 0.025; the end in the cell at 0.225 is 0.2 m = 1 sigma away: exp(-1/2). The other
  // end is outside.
  OccupancyGrid map{.resolution = 0.05, .width = 20, .height = 1, .cells = std::vector<std::int8_t>(20, 0)};
  map.cells[0] = 100;
  const LikelihoodField field(map, {});
  const ScanFit fit = scan_fit(field, {.x = {0.225F, -3.0F}, .y = {0.025F, 0.025F}}, {});
  EXPECT_NEAR(fit.hit, std::exp(-0.5), 1e-6);
  EXPECT_DOUBLE_EQ(fit.known, 0.5);
}

// A wall across the path at 1 m. From the origin: an end at the wall, one 1 m behind it, one half way (a
// person).
TEST(LaserModel, BeamsThroughAWallSpeakAgainstAPoseAndShortOnesDoNot) {
  OccupancyGrid map{.resolution = 0.05, .origin = {-1.0, -1.0}, .width = 80, .height = 40};
  map.cells.assign(80 * 40, OccupancyGrid::kFree);
  for (int row = 0; row < 40; ++row)
    map.cells[map.index(40, row)] = OccupancyGrid::kOccupied;  // x in [1, 1.05)
  const LikelihoodField field(map, {});
  const ScanFit right = scan_fit(field, {.x = {1.02F, 0.2F}, .y = {0.0F, 0.0F}}, {});
  EXPECT_EQ(right.through, 0.0);
  EXPECT_NEAR(right.agreement(), 1.0, 1e-12);
  const ScanFit wrong = scan_fit(field, {.x = {1.02F, 2.0F, 0.2F, 2.0F}, .y = {0.0F, 0.0F, 0.0F, 0.5F}}, {});
  EXPECT_EQ(wrong.through, 0.5);
  // One of four hits; d = 0.8 and 0.95 m are four sigma or more away.
  EXPECT_NEAR(wrong.hit, 0.25, 1e-3);
  EXPECT_NEAR(wrong.agreement(), 0.25 / 0.75, 2e-3);
  const ScanFit nothing = scan_fit(field, {.x = {0.2F}, .y = {0.0F}}, {});
  EXPECT_EQ(nothing.agreement(), 0.0);
}

}  // namespace
}  // namespace bw::localization
