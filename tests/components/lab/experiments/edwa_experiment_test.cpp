#include "components/lab/experiments/edwa_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/lab/experiments/edwa_criteria.hpp"
#include "components/lab/experiments/edwa_report.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "tests/shortfall.hpp"

namespace bw {
namespace {

TEST(EdwaScenes, JitterWithinTheRangesOfTheBook) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    for (int i = 0; i < kEdwaScenes; ++i) {
      const std::vector<StartAndGoal> errands = edwa_scene(i, seed).errands;
      EXPECT_EQ(errands[0].start, Pose2{});
      EXPECT_EQ(errands[0].goal, (Pose2{16.0, 0.0, 0.0}));
    }
    const std::vector<StartAndGoal> head_on = edwa_scene(0, seed).errands;
    ASSERT_EQ(head_on.size(), 2U);
    EXPECT_NEAR(head_on[1].start.y, 0.8, 0.2);
    EXPECT_EQ(head_on[1].goal.y, head_on[1].start.y);
    EXPECT_DOUBLE_EQ(head_on[1].start.theta, std::numbers::pi);

    const std::vector<StartAndGoal> crossing = edwa_scene(1, seed).errands;
    EXPECT_NEAR(crossing[1].start.x, 8.0, 0.2);
    EXPECT_NEAR(crossing[1].start.y, -7.5, 0.4);
    EXPECT_EQ(crossing[1].goal.x, crossing[1].start.x);
    EXPECT_DOUBLE_EQ(crossing[1].start.theta, std::numbers::pi / 2.0);

    const std::vector<StartAndGoal> three = edwa_scene(3, seed).errands;
    ASSERT_EQ(three.size(), 4U);
    EXPECT_NEAR(three[1].start.y, 1.1, 0.2);
    EXPECT_EQ(three[3].start.x, 11.0);
    EXPECT_EQ(three[3].goal.y, -8.0);
  }
}

TEST(DeltaMin, FallsWithTheGap) {
  EXPECT_DOUBLE_EQ(delta_min(0.0), 1.0);
  EXPECT_DOUBLE_EQ(delta_min(-0.1), 1.0) << "contact";
  EXPECT_DOUBLE_EQ(delta_min(3.0), std::exp(-1.0));
}

// Drives straight on at full speed whatever comes; counts nobody.
class StraightOn final : public LocalPlanner {
 public:
  PlanningResult plan(const PlanningProblem& problem) override {
    PlanningResult result;
    result.status = PlanningStatus::ok;
    result.command = {
        std::min(problem.twist.v + problem.limits.acc_max * problem.control_period, problem.limits.v_max),
        0.0};
    return result;
  }
  void reset() override {}
};

FloorRobot straight_on(const Pose2& start, const Pose2& goal) {
  return {.planner = std::make_unique<StraightOn>(), .pose = start, .goal = goal};
}

TEST(SharedFloor, AloneTheMeanSpeedIsThatOfSpeedingUp) {
  // 0.25, 0.5, 0.75 m/s for a quarter second each: 0.375 m. Then 15.325 m to the goal radius at 1 m/s: 16.075
  // s in all, 15.7 / 16.075 = 0.9767.
  std::vector<FloorRobot> robots;
  robots.push_back(straight_on({}, {16.0, 0.0, 0.0}));
  const FloorRun run = run_on_floor(std::move(robots), published_edwa_rules());
  EXPECT_EQ(run.outcome, FloorOutcome::reached);
  EXPECT_NEAR(run.time, 16.075, 0.026);
  EXPECT_NEAR(run.mean_speed, 0.9767, 1e-3);
  EXPECT_TRUE(std::isinf(run.smallest_gap));
}

TEST(SharedFloor, HeadOnEndsInContactHalfWay) {
  // 10 m apart, 0.6 m between centres at contact: each has 4.7 m to go, 0.375 m in 0.75 s and the rest at
  // 1 m/s: 5.075 s.
  std::vector<FloorRobot> robots;
  robots.push_back(straight_on({}, {16.0, 0.0, 0.0}));
  robots.push_back(straight_on({10.0, 0.0, std::numbers::pi}, {0.0, 0.0, std::numbers::pi}));
  const FloorRun run = run_on_floor(std::move(robots), published_edwa_rules());
  EXPECT_EQ(run.outcome, FloorOutcome::contact);
  EXPECT_NEAR(run.time, 5.075, 0.026);
  EXPECT_LT(run.smallest_gap, 0.0);
}

TEST(SharedFloor, TimesOut) {
  FloorRules rules = published_edwa_rules();
  rules.timeout = 2.0;
  std::vector<FloorRobot> robots;
  robots.push_back(straight_on({}, {16.0, 0.0, 0.0}));
  EXPECT_EQ(run_on_floor(std::move(robots), rules).outcome, FloorOutcome::timeout);
}

TEST(EdwaExperiment, EdwaReachesTheGoalWithoutContactAndDwaDoesNotAlways) {
  EdwaExperimentOptions options;
  options.last_seed = 3;
  const EdwaTable table = run_edwa_experiment(options);
  ASSERT_EQ(table.rows.size(), 12U);
  int dwa_contacts = 0;
  for (const EdwaRow& row : table.rows) {
    EXPECT_EQ(row.success + row.contacts + row.timeouts, 3);
    if (row.pairing.robot == "dwa") {
      dwa_contacts += row.contacts;
      continue;
    }
    EXPECT_EQ(row.success, 3) << edwa_scene_name(row.scene) << " " << to_string(row.pairing);
    EXPECT_NEAR(row.mean, row.published, 0.04) << edwa_scene_name(row.scene) << " " << to_string(row.pairing);
  }
  EXPECT_GT(dwa_contacts, 0) << "plain DWA takes crossing robots for standing ones";
}

// Table 3.2 has gains of 0.01 m/s and more in every scene. DWA robots that reach the goal at all are as fast
// here.
TEST(EdwaExperiment, TheGainOverDwaFallsShort) {
  EdwaExperimentOptions options;
  options.last_seed = 3;
  const std::vector<Criterion> criteria = run_edwa_experiment(options).criteria;
  const auto gain = std::find_if(criteria.begin(), criteria.end(),
                                 [](const Criterion& c) { return c.name.starts_with("smallest gain"); });
  ASSERT_NE(gain, criteria.end());
  // Noise: each of the two means is of three seeds, and one that is another by 0.003 m/s moves it by 0.001;
  // two in each.
  bw::test::expect_at_least("smallest gain of EDWA over DWA in a scene [m/s]",
                            {.asked = 0.01, .measured = -0.0161, .noise = 0.002}, gain->measured);
}

TEST(EdwaExperiment, PrintedHeadingDoesNotReachTheGoal) {
  EdwaExperimentOptions options;
  options.planners.of<dwa::EdwaOptions>("edwa").heading = dwa::EdwaHeading::hrvo_printed;
  options.rules.timeout = 30.0;
  EXPECT_NE(run_edwa_scene(1, kEdwaPairings[1], 1, options).outcome, FloorOutcome::reached);
}

TEST(EdwaExperiment, IsDeterministic) {
  const FloorRun a = run_edwa_scene(3, kEdwaPairings[2], 7, {});
  const FloorRun b = run_edwa_scene(3, kEdwaPairings[2], 7, {});
  EXPECT_EQ(a.mean_speed, b.mean_speed);
  EXPECT_EQ(a.smallest_gap, b.smallest_gap);
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) EXPECT_EQ(a.samples[i].v, b.samples[i].v);
  EXPECT_NE(a.mean_speed, run_edwa_scene(3, kEdwaPairings[2], 8, {}).mean_speed) << "the seed matters";
}

// A table in which everything is met.
std::vector<EdwaRow> perfect_rows() {
  std::vector<EdwaRow> rows;
  for (int scene = 0; scene < kEdwaScenes; ++scene) {
    for (const EdwaPairing& pairing : kEdwaPairings) {
      EdwaRow row{.scene = scene, .pairing = pairing, .published = 0.95, .mean = 0.95, .success = 2};
      row.runs.resize(2);
      row.lowest_v = 0.6;
      row.mean_max_delta = 0.9;
      if (pairing.robot == "dwa") {
        row.mean = 0.9;
        row.mean_max_delta = 0.99;
      }
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<bool> met(const std::vector<EdwaRow>& rows) {
  std::vector<bool> list;
  for (const Criterion& c : edwa_criteria(rows)) list.push_back(c.met);
  return list;
}

TEST(EdwaCriteria, EachOneCanFail) {
  using ::testing::ElementsAre;
  EXPECT_THAT(met(perfect_rows()), ElementsAre(true, true, true, true, true, true));
  std::vector<EdwaRow> rows = perfect_rows();
  rows[5].mean = 0.95 + 0.041;  // S2, EDWA-EDWA
  rows[6].mean = 0.941;         // S3, DWA-DWA: a gain of 0.009
  rows[1].contacts = 1;
  rows[2].success = 1;
  rows[10].mean_max_delta = 0.995;  // S4, EDWA-DWA
  rows[4].lowest_v = 0.39;
  EXPECT_THAT(met(rows), ElementsAre(false, false, false, false, false, false));
  rows = perfect_rows();
  rows[0].mean = std::nan("");  // no DWA run survived: no gain can be claimed
  EXPECT_FALSE(met(rows)[1]);
}

TEST(EdwaReport, HoldsTheRowsAndTheCriteria) {
  EdwaTable table{perfect_rows(), edwa_criteria(perfect_rows())};
  table.rows[0].mean = std::nan("");
  table.rows[0].example = {{0.0, 0.25, 3.0}, {0.25, 0.5, 2.0}};
  const std::vector<EdwaVariant> variants = edwa_variants(1, 2);
  const std::vector<EdwaResult> results = {{variants[0], table}, {variants[1], table}};
  const nlohmann::ordered_json json = edwa_json(results);
  EXPECT_EQ(json["experiment"], "edwa");
  ASSERT_EQ(json["rows"].size(), 12U);
  EXPECT_TRUE(json["rows"][0]["mean"].is_null());
  EXPECT_EQ(json["rows"][1]["pairing"], "EDWA-DWA");
  EXPECT_EQ(json["rows"][1]["published"], 0.95);
  EXPECT_EQ(json["rows"][1]["runs"], 2);
  EXPECT_EQ(json["criteria"].size(), 6U);
  EXPECT_EQ(json["variants"].size(), 1U);
  const nlohmann::ordered_json page = edwa_page(results).json();
  EXPECT_THAT(page.dump(), ::testing::HasSubstr("EDWA-EDWA"));
  std::vector<std::size_t> pictures;
  for (const auto& block : page["blocks"])
    if (block["kind"] == "figure") pictures.push_back(block["pictures"].size());
  EXPECT_EQ(pictures, (std::vector<std::size_t>{12, 4, 4, 4})) << "ways, distances, speeds, velocities";
}

}  // namespace
}  // namespace bw
