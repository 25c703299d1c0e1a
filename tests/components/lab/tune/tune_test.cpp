#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "components/lab/bench/planner_overrides.hpp"
#include "components/lab/tune/successive_halving.hpp"
#include "components/lab/tune/tune_suite.hpp"
#include "components/lab/tune/tuned_parameters.hpp"
#include "components/model/random.hpp"

namespace bw::tune {
namespace {

// Candidate k costs |k - 70| / 100 and noise of 0.1: of 100 the best is found within 3, and 0, today's, drives to the end.
TEST(SuccessiveHalving, FindsTheBestInNoiseWithinItsDrives) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::size_t count = candidates_for(2000);
    EXPECT_GE(count, 90U);
    std::size_t driven = 0;
    const auto ranked = successive_halving(count, [&](std::size_t k, std::size_t first, std::size_t n) {
      std::vector<double> costs;
      for (std::size_t i = 0; i < n; ++i) {
        Random random(seed * 1'000'000 + k * 1000 + first + i);
        costs.push_back(std::abs(static_cast<double>(k) - 70.0) / 100.0 + 0.1 * random.normal());
      }
      driven += n;
      return costs;
    });
    EXPECT_LE(driven, 2000U);
    EXPECT_NEAR(static_cast<double>(ranked.front().number), 70.0, 3.0) << seed;
    EXPECT_EQ(ranked.front().episodes, 162U);
    const auto today =
        std::find_if(ranked.begin(), ranked.end(), [](const Candidate& c) { return c.number == 0; });
    EXPECT_EQ(today->episodes, 162U);
  }
}

TEST(TunedParameters, AreTheNumbersOfItsSection) {
  for (const char* planner : {"eteb", "teb", "mppi", "edwa", "orca"}) {
    const std::vector<TunedParameter> parameters = parameters_of(planner, {});
    EXPECT_GE(parameters.size(), 2U) << planner;
    for (const TunedParameter& p : parameters) {
      const std::string section = p.name.substr(0, p.name.find('.'));
      EXPECT_TRUE(p.name.find('.') == std::string::npos || section == planner || section == "teb") << p.name;
      EXPECT_GE(p.value, p.min) << p.name;
      EXPECT_LE(p.value, p.max) << p.name;
    }
  }
  EXPECT_THROW(parameters_of("eteb", {"teb.no_such"}), std::runtime_error);
}

// Today's is candidate 0; every candidate can be read, and a planner made of it.
TEST(TunedParameters, CandidatesKeepToWhatIsAllowed) {
  const std::vector<TunedParameter> parameters = parameters_of("eteb", {});
  EXPECT_TRUE(settings_of(parameters, 0, 1).empty());
  EXPECT_EQ(settings_of(parameters, 5, 1), settings_of(parameters, 5, 1));
  EXPECT_NE(settings_of(parameters, 5, 1), settings_of(parameters, 6, 1));
  for (std::size_t k = 0; k < 200; ++k) {
    PlannerOptions options;
    ASSERT_NO_THROW(apply_overrides(options, settings_of(parameters, k, 1))) << k;
    EXPECT_NE(make_planner("eteb", options), nullptr);
  }
}

// Of a set the values are turned that it has: 12 by up to 3 either way.
TEST(TunedParameters, CandidatesAreDrawnAboutASet) {
  const std::string name = "mppi.path_follow.cost_weight";
  const std::vector<TunedParameter> parameters = parameters_of("mppi", {name}, {name + "=12"});
  ASSERT_EQ(parameters.size(), 1U);
  EXPECT_DOUBLE_EQ(parameters.front().value, 12.0);
}

// Episodes that judge are none that were tuned on: 20,001 and 40,001 were the same case of 500.
TEST(TuneSuite, CrowdNavGoesOnBeyondItsCases) {
  const PlannerOptions options;
  EXPECT_NE(drive_episode(TuneSuite::crowdnav, 20'001, "orca", options).time,
            drive_episode(TuneSuite::crowdnav, 40'001, "orca", options).time);
}

}  // namespace
}  // namespace bw::tune
