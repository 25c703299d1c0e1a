#include "components/lab/experiments/hallway_experiment.hpp"

#include <gtest/gtest.h>

#include "components/lab/experiments/anticipation_report.hpp"

namespace bw {
namespace {

nlohmann::json card(double index, int contacts = 0) {
  return {{"reached", true},
          {"collisions", contacts},
          {"collisions_at_speed", 0},
          {"max_collision_index", index},
          {"share_ci_above_0_54", 0.1},
          {"share_ci_above_0_14", 0.3},
          {"time_to_goal_s", 20.0},
          {"path_length_m", 18.5}};
}

std::vector<HallwayDrive> drives(const std::string& planner, const std::vector<double>& indices) {
  std::vector<HallwayDrive> out;
  for (const double index : indices)
    for (const char* episode : {"light", "full"})
      out.push_back(
          hallway_drive(planner, episode, true, static_cast<std::int64_t>(out.size()), card(index)));
  return out;
}

std::vector<HallwayDrive> operator+(std::vector<HallwayDrive> a, const std::vector<HallwayDrive>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(HallwayExperiment, ReadsAScoreCard) {
  const HallwayDrive drive = hallway_drive("teb", "full", false, 7, card(0.4, 1));
  EXPECT_FALSE(drive.succeeded()) << "a contact while standing is one";
  EXPECT_EQ(drive.contacts, 1);
  EXPECT_EQ(drive.max_collision_index, 0.4);
  EXPECT_EQ(drive.share_above_0_14, 0.3);
  EXPECT_EQ(drive.path_length, 18.5);
  EXPECT_TRUE(hallway_drive("teb", "full", false, 7, card(0.7)).succeeded());
  const HallwayDrive nothing =
      hallway_drive("teb", "full", true, 1, {{"reached", false}, {"time_to_goal_s", nullptr}});
  EXPECT_FALSE(nothing.reached);
  EXPECT_EQ(nothing.time, 0.0);
}

TEST(HallwayExperiment, RowsAreMediansAndSharesOverSeeds) {
  const std::vector<HallwayRow> rows = hallway_rows(drives("teb", {0.5, 0.9, 0.1, 0.6}));
  ASSERT_EQ(rows.size(), 2u);  // light and full
  EXPECT_EQ(rows[0].episode, "light");
  EXPECT_EQ(rows[0].drives, 4);
  EXPECT_EQ(rows[0].successes, 4);
  EXPECT_EQ(rows[0].contacts, 0);
  EXPECT_EQ(rows[0].median_max_collision_index, 0.5);  // nearest rank: the second of four
  EXPECT_EQ(rows[0].share_of_seeds_below_0_54, 0.5);
  EXPECT_NEAR(*rows[0].mean_time, 20.0, 1e-12);
}

TEST(HallwayExperiment, ARowWithoutAReachedGoalHasNoTime) {
  const std::vector<HallwayRow> rows =
      hallway_rows({hallway_drive("teb", "full", true, 1, {{"reached", false}, {"time_to_goal_s", 120.0}})});
  EXPECT_FALSE(rows.at(0).mean_time.has_value());
  EXPECT_TRUE(hallway_json({})["rows"].empty());
}

// Half of the drives by own senses: rows of their own, and no criterion asks for them.
TEST(HallwayExperiment, OwnSensesAreRowsOfTheirOwnAndNotJudged) {
  std::vector<HallwayDrive> own = drives("pteb", {0.9, 0.9});
  for (HallwayDrive& drive : own) drive.own_senses = true;
  const std::vector<HallwayDrive> ideal = drives("teb", {0.6, 0.6}) + drives("pteb", {0.5, 0.5});
  const std::vector<HallwayRow> rows = hallway_rows(own + ideal);
  ASSERT_EQ(rows.size(), 6u);  // own: pteb; ideal: teb and pteb; each light and full
  EXPECT_TRUE(rows[0].own_senses);
  EXPECT_EQ(rows[0].median_max_collision_index, 0.9);
  for (const Criterion& c : hallway_criteria(rows, {"teb", "pteb"})) EXPECT_TRUE(c.met) << c.name;
  EXPECT_EQ(hallway_json(own)["rows"][0]["senses"], "own");
  EXPECT_EQ(hallway_json(ideal)["drives"][0]["senses"], "ideal");
}

TEST(HallwayCriteria, AskForFallingMediansAndForSpaceInFourOfFiveSeeds) {
  const std::vector<HallwayDrive> good = drives("teb", {0.6, 0.6, 0.6, 0.6, 0.6}) +
                                         drives("pteb", {0.5, 0.5, 0.5, 0.5, 0.6}) +
                                         drives("eteb", {0.5, 0.4, 0.4, 0.4, 0.6});
  const std::vector<Criterion> met = hallway_criteria(hallway_rows(good), {"teb", "pteb", "eteb"});
  EXPECT_EQ(met.size(), 8u);  // two planners, two episodes, two rules
  for (const Criterion& c : met) EXPECT_TRUE(c.met) << c.name;

  const std::vector<HallwayDrive> bad =
      drives("teb", {0.3, 0.3, 0.3, 0.3, 0.3}) + drives("pteb", {0.5, 0.5, 0.5, 0.6, 0.6});
  for (const Criterion& c : hallway_criteria(hallway_rows(bad), {"teb", "pteb"}))
    EXPECT_FALSE(c.met) << c.name;
}

TEST(HallwayCriteria, PeopleWhoDoNotReactAreOnlyReported) {
  std::vector<HallwayDrive> all = drives("teb", {0.3}) + drives("pteb", {0.9});
  for (HallwayDrive& drive : all) drive.people_react = false;
  EXPECT_TRUE(hallway_criteria(hallway_rows(all), {"teb", "pteb"}).empty());
}

TEST(AnticipationReport, PageAndJsonHoldWhatWasMeasured) {
  AnticipationResults results{.subject = "pteb"};
  for (const CrossingEntry& entry : default_entries(false)) {
    results.crossing.push_back(run_crossing(entry, {}, 1));
    results.proposed.push_back(results.crossing.back());
  }
  for (const CrossingEntry& entry : published_entries(false)) {
    results.crossing.push_back(results.crossing.front());
    results.crossing.back().entry = entry;
  }
  results.hallway = drives("teb", {0.6}) + drives("pteb", {0.5});
  // Three of E5, two of E6 in light and full each.
  EXPECT_EQ(anticipation_criteria(results).size(), 7u);
  const nlohmann::ordered_json json = anticipation_json(results);
  EXPECT_EQ(json["crossing"]["rows"].size(), 6u);
  EXPECT_EQ(json["hallway"]["drives"].size(), 4u);
  const auto page = [&] { return anticipation_page(results).json().dump(); };
  EXPECT_NE(page().find("pteb, published"), std::string::npos);
  // Snapshots of planners with several bands at two times, the whole paths, the largest index in light and
  // full.
  std::vector<std::size_t> pictures;
  const nlohmann::ordered_json blocks = anticipation_page(results).json()["blocks"];
  for (const auto& block : blocks)
    if (block["kind"] == "figure") pictures.push_back(block["pictures"].size());
  EXPECT_EQ(pictures, (std::vector<std::size_t>{8, 2, 2}));

  // A drive that failed is linked where it can be played, the others are not.
  EXPECT_EQ(page().find("to be played"), std::string::npos);
  results.hallway.front().page = "failed/hallway_full_seed7.html";
  EXPECT_NE(page().find("](failed/hallway_full_seed7.html)"), std::string::npos);
  EXPECT_EQ(hallway_json(results.hallway)["drives"][0]["page"], "failed/hallway_full_seed7.html");
  EXPECT_FALSE(hallway_json(results.hallway)["drives"][1].contains("page"));
}

}  // namespace
}  // namespace bw
