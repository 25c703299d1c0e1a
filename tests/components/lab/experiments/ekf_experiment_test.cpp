#include "components/lab/experiments/ekf_experiment.hpp"

#include <string>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr int kSeeds = 100;  // as in experiments/protocols.md 8.1

EkfErrors mean_of(EkfPath path, const EkfSensorSet& sensors, EkfWheelNoise noise) {
  EkfErrors mean;
  for (const EkfErrors& e : run_ekf_experiments(path, sensors, noise, kSeeds)) {
    mean.mean += e.mean / kSeeds;
    mean.variance += e.variance / kSeeds;
    mean.rms += e.rms / kSeeds;
  }
  return mean;
}

class EkfExperiment : public ::testing::TestWithParam<EkfPath> {};

// The criteria of experiments/protocols.md 8.1: (a) encoder >> + GPS > all, + compass > all, encoder / all >
// 100; (b) the mean within 25 % of the published one; (c) the fused variances within a factor of 3. Filter
// with the placing wheel noise.
TEST_P(EkfExperiment, MeetsTheCriteriaOfTheFigure) {
  const auto path = static_cast<std::size_t>(GetParam());
  std::array<EkfErrors, 4> measured;
  for (std::size_t i = 0; i < 4; ++i) {
    const EkfSensorSet& set = kEkfSensorSets[i];
    measured[i] = mean_of(GetParam(), set, EkfWheelNoise::placed);
    RecordProperty("placed_" + std::to_string(i), std::to_string(measured[i].mean));
    EXPECT_NEAR(measured[i].mean, set.published_mean[path], 0.25 * set.published_mean[path]) << set.name;
    if (i == 0) continue;  // the published variance of the encoders is unexplained (ekf/theory.md 3.1)
    EXPECT_LT(measured[i].variance, 3.0 * set.published_variance[path]) << set.name;
    EXPECT_GT(measured[i].variance, set.published_variance[path] / 3.0) << set.name;
  }
  EXPECT_GT(measured[0].mean, 100.0 * measured[3].mean);
  EXPECT_GT(measured[1].mean, measured[3].mean);
  EXPECT_GT(measured[2].mean, measured[3].mean);
}

// A filter that knows its wheels does clearly better with all sensors (ekf/theory.md 3.3: 0.07 m).
TEST_P(EkfExperiment, TheMatchedFilterIsBetter) {
  const EkfErrors placed = mean_of(GetParam(), kEkfSensorSets[3], EkfWheelNoise::placed);
  const EkfErrors matched = mean_of(GetParam(), kEkfSensorSets[3], EkfWheelNoise::matched);
  RecordProperty("matched_all", std::to_string(matched.mean));
  RecordProperty("matched_gps",
                 std::to_string(mean_of(GetParam(), kEkfSensorSets[1], EkfWheelNoise::matched).mean));
  EXPECT_LT(matched.mean, 0.7 * placed.mean);
}

INSTANTIATE_TEST_SUITE_P(Paths, EkfExperiment, ::testing::Values(EkfPath::sinus, EkfPath::circle));

TEST(EkfExperimentRun, SameSeedSameErrors) {
  const EkfErrors a = run_ekf_experiment(EkfPath::sinus, kEkfSensorSets[3], EkfWheelNoise::placed, 7);
  const EkfErrors b = run_ekf_experiment(EkfPath::sinus, kEkfSensorSets[3], EkfWheelNoise::placed, 7);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.variance, b.variance);
}

}  // namespace
}  // namespace bw
