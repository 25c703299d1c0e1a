// What few seeds cannot show is not judged, and is said so in every form.
#include "components/lab/experiments/criterion.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "components/lab/experiments/caveats.hpp"
#include "components/lab/experiments/edwa_criteria.hpp"
#include "components/lab/experiments/hallway_experiment.hpp"
#include "components/lab/experiments/pf_experiment.hpp"

namespace bw {
namespace {

const Criterion kOpen = over_seeds({"median", "<= 0", 1.0, false}, 2, 20);

TEST(Criterion, OfManySeedsIsNotJudgedWithFewer) {
  EXPECT_EQ(kOpen.not_judged, "2 of 20 seeds");
  EXPECT_EQ(over_seeds({"median", "<= 0", 1.0, false}, 20, 20).not_judged, "");
}

TEST(Criterion, ThatIsNotJudgedDecidesNothing) {
  const Criterion met{"contacts", "0", 0.0, true};
  const Criterion missed{"contacts", "0", 1.0, false};
  EXPECT_TRUE(all_met({met, kOpen}));
  EXPECT_FALSE(all_met({missed, kOpen}));
  EXPECT_EQ(criteria_text({met, kOpen}),
            "met     contacts: 0.0000, asked 0\nnot judged, 2 of 20 seeds: median: 1.0000, asked <= 0\n");
  const nlohmann::ordered_json json = criteria_json({missed, kOpen});
  EXPECT_EQ(json[0]["met"], false);
  EXPECT_FALSE(json[0].contains("not_judged"));
  EXPECT_TRUE(json[1]["met"].is_null());
  EXPECT_EQ(json[1]["not_judged"], "2 of 20 seeds");
  EXPECT_EQ(verdict("it", {met, kOpen}), "it: met (1 of 2 criteria; 1 not judged: too few seeds)");
  EXPECT_EQ(verdict("it", {missed, met, kOpen}), "it: NOT MET (1 of 2 criteria; 1 not judged)");
  EXPECT_EQ(verdict("it", {kOpen}), "it: not judged (too few seeds)");
}

std::vector<bool> judged(const std::vector<Criterion>& criteria) {
  std::vector<bool> list;
  for (const Criterion& c : criteria) list.push_back(c.not_judged.empty());
  return list;
}

// Of a quick run of E3 contacts, goals and the lowest speed stand, which every run must keep; means do not.
TEST(QuickRun, JudgesWhatMustHoldOfEveryRun) {
  std::vector<EdwaRow> rows;
  for (int scene = 0; scene < kEdwaScenes; ++scene)
    for (const EdwaPairing& pairing : kEdwaPairings) {
      rows.push_back({.scene = scene, .pairing = pairing});
      rows.back().runs.resize(5);
    }
  EXPECT_THAT(judged(edwa_criteria(rows)), ::testing::ElementsAre(false, false, true, true, false, true));
  for (EdwaRow& row : rows) row.runs.resize(kEdwaSeeds);
  EXPECT_THAT(judged(edwa_criteria(rows)), ::testing::Each(true));
}

TEST(QuickRun, JudgesNoMedianOfTheHallway) {
  std::vector<HallwayDrive> drives;
  for (const char* planner : {"teb", "pteb"})
    for (std::int64_t seed = 1; seed <= kHallwaySeeds; ++seed)
      drives.push_back({.planner = planner, .episode = "full", .seed = seed, .reached = true});
  EXPECT_THAT(judged(hallway_criteria(hallway_rows(drives), {"teb", "pteb"})),
              ::testing::ElementsAre(true, true));
  drives.pop_back();
  EXPECT_THAT(judged(hallway_criteria(hallway_rows(drives), {"teb", "pteb"})),
              ::testing::ElementsAre(false, false));
}

TEST(QuickRun, JudgesNothingOfTheParticleFilter) {
  const PfTable table = run_pf_experiments({.particles = 10, .last_seed = 1});
  EXPECT_EQ(table.criteria.size(), 8U);
  EXPECT_THAT(judged(table.criteria), ::testing::Each(false));
}

}  // namespace
}  // namespace bw
