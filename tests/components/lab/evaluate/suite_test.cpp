// Suite files are read strictly, and their results are summed up as the formulas say.
#include "components/lab/evaluate/suite.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "components/lab/evaluate/suite_report.hpp"
#include "components/program/contacts/contact_report.hpp"

namespace bw {
namespace {

class SuiteFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / "bandwagon_suite_test";
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "graph.yaml") << "components:\n  world:\n    parameters: {truth_rate: 20.0}\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Suite load(const std::string& text) {
    const std::filesystem::path file = folder_ / "suite.yaml";
    std::ofstream(file) << text;
    return load_suite(file);
  }

  std::string refusal(const std::string& text) {
    try {
      load(text);
    } catch (const ConfigError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "accepted";
  }

  std::filesystem::path folder_;
};

TEST_F(SuiteFile, AppliesItsOverridesThenTheEpisodesOwn) {
  setenv("BANDWAGON_SUITE_TEST", "/somewhere", 1);
  const Suite suite = load(
      "graph: graph.yaml\n"
      "seeds: {first: 3, last: 4}\n"
      "set: [world.people_react=false, 'world.map=${BANDWAGON_SUITE_TEST}/map.yaml', world.tracks=eth.csv]\n"
      "episodes:\n"
      "  - name: a\n"
      "  - {name: b, set: [world.people_react=true]}\n");
  EXPECT_EQ(suite.options.seeds.first, 3);
  EXPECT_EQ(suite.graph, folder_ / "graph.yaml");
  const Graph a = suite.graph_of(0);
  const ConfigNode& parameters = a.find("world")->parameters;
  EXPECT_EQ(parameters.find("people_react")->scalar, "false");
  EXPECT_EQ(parameters.find("truth_rate")->scalar, "20.0");
  EXPECT_EQ(parameters.find("map")->scalar, "/somewhere/map.yaml");
  // Files are relative to the suite, not to the folder somebody happens to be in.
  const ConfigNode& tracks = *parameters.find("tracks");
  EXPECT_EQ(resolve_path(tracks.where, tracks.scalar), folder_ / "eth.csv");
  EXPECT_EQ(suite.graph_of(1).find("world")->parameters.find("people_react")->scalar, "true");
}

TEST_F(SuiteFile, RefusesWithFileLineAndRule) {
  EXPECT_EQ(refusal("graph: g.yaml\nepisodes: [{name: a}]\nsedes: {first: 1}\n"),
            "suite.yaml:3: sedes: unknown key; did you mean 'seeds'?");
  EXPECT_EQ(refusal("graph: g.yaml\nepisodes: []\n"), "suite.yaml:1: episodes must hold at least one");
  EXPECT_EQ(refusal("graph: g.yaml\nepisodes: [{name: a}, {name: a}]\n"),
            "suite.yaml:1: two episodes are named 'a'");
  EXPECT_EQ(refusal("graph: g.yaml\nepisodes: [{name: ../a}]\n"),
            "suite.yaml:1: an episode's name must be letters, digits, dot, _ and -, not '../a'");
  EXPECT_EQ(refusal("graph: g.yaml\nset:\n  - world.map=${NOT_SET_ANYWHERE}/m.yaml\nepisodes: [{name: a}]\n"),
            "suite.yaml:3: set = world.map=${NOT_SET_ANYWHERE}/m.yaml: "
            "the environment variable NOT_SET_ANYWHERE must be set");
  EXPECT_EQ(refusal("graph: g.yaml\nepisodes:\n  - name: a\n    set: [world.map]\n"),
            "suite.yaml:4: world.map: must have the form component.param=value");
}

// A variant comes after the episode's own; one without `set` is the suite as it is.
TEST_F(SuiteFile, VariantsAreConditionsOfAllEpisodes) {
  const Suite suite = load(
      "graph: graph.yaml\nset: [world.people_react=false]\nvariants:\n  - {name: as_is}\n"
      "  - {name: other, set: [world.people_react=true]}\nepisodes: [{name: a, set: [world.people_react=maybe]}]\n");
  const auto people_react = [&](const std::string& variant) {
    return suite.graph_of(0, variant).find("world")->parameters.find("people_react")->scalar;
  };
  EXPECT_EQ(people_react(""), "maybe");
  EXPECT_EQ(people_react("as_is"), "maybe");
  EXPECT_EQ(people_react("other"), "true");
  try {
    suite.graph_of(0, "own");
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("has as_is, other"), std::string::npos) << error.what();
  }
  EXPECT_EQ(refusal("graph: g.yaml\nvariants: [{name: a}, {name: a}]\nepisodes: [{name: a}]\n"),
            "suite.yaml:1: two variants are named 'a'");
}

TEST_F(SuiteFile, AnOverrideOfNothingNamesTheSuite) {
  const Suite suite = load("graph: graph.yaml\nepisodes:\n  - {name: a, set: [wrld.map=m]}\n");
  try {
    suite.graph_of(0);
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.violations().front().where.line, 3);
    EXPECT_EQ(error.violations().front().key, "wrld.map");
  }
}

nlohmann::json json_of(const SuiteResult& result) { return to_json(result, summarize(result)); }

std::string words_of(const std::vector<SuiteResult>& results) {
  std::vector<std::vector<PlannerSummary>> planners;
  for (const SuiteResult& result : results) planners.push_back(summarize(result));
  return in_words(results, planners);
}

EpisodeResult drive(const std::string& name, bool reached, int contacts, int at_speed, double index) {
  return {name,
          1,
          "teb",
          {{"reached", reached},
           {"reason", "because"},
           {"collisions", contacts},
           {"collisions_at_speed", at_speed},
           {"min_distance_m", 1.0 - index},
           {"closest_person_m", 2.0 - index},
           {"max_collision_index", index},
           {"time_to_goal_s", reached ? 10.0 * contacts : 99.0},
           {"rms_jerk_mps3", index},
           {"localization", {{"rms_m", index / 10.0}, {"max_m", index}}},
           {"planner",
            {{"name", "teb"}, {"mean_ms", 10.0 * index}, {"p95_ms", 20.0 * index}, {"max_ms", 50.0}}}}};
}

// A contact is a failure, of a standing robot too, and so is a goal not reached. Wilson 95 % of 1 of 4 is
// 0.0456 to 0.6994 (z = 1.96: (0.25 + 0.4802 -+ 1.96 sqrt(0.046875 + 0.06002)) / 1.9604 by hand). Beside it:
// two reached it without a contact at speed.
TEST(SuiteReport, SumsUpByPlanner) {
  const SuiteResult result{"suite.yaml",
                           {drive("a", true, 0, 0, 0.1), drive("b", true, 1, 0, 0.2),
                            drive("c", true, 2, 1, 0.4), drive("d", false, 0, 0, 0.3)}};
  const nlohmann::json json = json_of(result);
  const nlohmann::json& row = json["summary"]["teb"];
  EXPECT_EQ(row["episodes"], 4);
  EXPECT_EQ(row["reached"], 3);
  EXPECT_EQ(row["successes"], 1);
  EXPECT_EQ(row["reached_without_contact_at_speed"], 2);
  EXPECT_EQ(json["success_means"], "the goal is reached in time, without any contact");
  EXPECT_NEAR(row["wilson95"][0].get<double>(), 0.0456, 5e-4);
  EXPECT_NEAR(row["wilson95"][1].get<double>(), 0.6994, 5e-4);
  EXPECT_EQ(row["contacts"], 3);
  EXPECT_EQ(row["contacts_at_speed"], 1);
  EXPECT_DOUBLE_EQ(row["min_distance_m"].get<double>(), 0.6);
  EXPECT_DOUBLE_EQ(row["closest_person_m"].get<double>(), 1.6);
  EXPECT_DOUBLE_EQ(row["planner_ms"]["mean"].get<double>(), 2.5);
  EXPECT_DOUBLE_EQ(row["planner_ms"]["p95"].get<double>(), 8.0);
  EXPECT_DOUBLE_EQ(row["planner_ms"]["max"].get<double>(), 50.0);
  EXPECT_DOUBLE_EQ(row["max_collision_index"]["max"].get<double>(), 0.4);
  EXPECT_DOUBLE_EQ(row["max_collision_index"]["median"].get<double>(), 0.2);
  EXPECT_DOUBLE_EQ(row["mean_time_s"].get<double>(), 10.0);
  EXPECT_DOUBLE_EQ(row["mean_rms_jerk_mps3"].get<double>(), 0.25);
  EXPECT_DOUBLE_EQ(row["localization"]["mean_rms_m"].get<double>(), 0.025);
  EXPECT_DOUBLE_EQ(row["localization"]["max_m"].get<double>(), 0.4);
  EXPECT_EQ(json["episodes"][2]["planner"], "teb");
  EXPECT_EQ(json["episodes"][2]["success"], false);
  const std::string words = words_of({result});
  EXPECT_NE(words.find("failed: d seed 1 teb: not reached (because)"), std::string::npos) << words;
  EXPECT_NE(words.find("1 of 4"), std::string::npos) << words;
}

nlohmann::json contact(const char* who, bool begins_mid_floor) {
  return {{"t", 3.0},
          {"person", 4},
          {"who", who},
          {"robot_closing_mps", 0.1},
          {"person_closing_mps", 0.9},
          {"there_for_s", 0.4},
          {"begins_mid_floor", begins_mid_floor},
          {"ends_mid_floor", false},
          {"verdict", "not avoidable"},
          {"saveable_until_s", nullptr},
          {"lost_since_s", 2.6}};
}

// Of four drives three succeed and one could not: 3 of 4, and 3 of 3 where possible. Wilson 95 % of 3 of 3:
// from 1 / (1 + z^2 / 3) = 0.4385 on.
TEST(SuiteReport, TellsSuccessWhereItWasPossible) {
  EpisodeResult lost = drive("lost", true, 2, 1, 0.6);
  lost.card["possible"] = false;
  lost.card["contacts"] = {contact("person_side", true), contact("person_behind", false)};
  const SuiteResult result{
      "suite.yaml",
      {drive("a", true, 0, 0, 0.1), drive("b", true, 0, 0, 0.1), drive("c", true, 0, 0, 0.1), lost}};
  const nlohmann::json json = json_of(result);
  const nlohmann::json& row = json["summary"]["teb"];
  EXPECT_EQ(row["successes"], 3);
  EXPECT_EQ(row["possible"], 3);
  EXPECT_NEAR(row["wilson95_possible"][0].get<double>(), 0.4385, 5e-5);
  EXPECT_EQ(row["hits"]["mid_floor"], 1);
  EXPECT_EQ(row["hits"]["person_side"], 0);
  EXPECT_EQ(row["hits"]["person_behind"], 1);
  EXPECT_EQ(json["episodes"][3]["possible"], false);
  EXPECT_EQ(json["episodes"][0]["possible"], true);
  const std::string words = words_of({result});
  EXPECT_NE(words.find("3 of 3"), std::string::npos) << words;
  EXPECT_NE(
      words.find("could not succeed\n  3.00 s person 4: person_side (robot 0.10, person 0.90 m/s), there for "
                 "0.40 s, not avoidable, lost since 2.6 s"),
      std::string::npos)
      << words;
  EXPECT_NE(words.find("contacts in suite of teb: 1 person_behind, 1 mid_floor"), std::string::npos) << words;
}

// Two suites of two episodes; by own senses the second of each fails: two pairs of four are the first's
// alone, p = 2 / 2^2.
TEST(SuiteReport, ComparesPlannersAndConditionsByEpisodeAndSeed) {
  const auto by = [](const std::string& name, const std::string& planner, bool reached) {
    EpisodeResult result = drive(name, reached, 0, 0, reached ? 0.1 : 0.6);
    result.planner = planner;
    return result;
  };
  const std::vector<EpisodeResult> drives = {by("a", "eteb ideal", true), by("b", "eteb ideal", true),
                                             by("b", "eteb own", false), by("a", "eteb own", true)};
  const std::vector<ComparedRow> rows = compared({{"x/eth.yaml", drives}, {"x/hotel.yaml", drives}});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].name, "eteb ideal");
  const Comparison c = compare(rows[0].episodes, rows[1].episodes);
  EXPECT_EQ(c.pairs, 4);
  EXPECT_EQ(c.only_first, 2);
  EXPECT_EQ(c.only_second, 0);
  EXPECT_DOUBLE_EQ(c.p, 0.5);
  EXPECT_EQ(c.both, 2);
  EXPECT_DOUBLE_EQ(c.closest.mean, 0.0);
}

// What was written is read again, under another name: before and after.
TEST(SuiteReport, ReadsWhatItWrote) {
  const auto file = std::filesystem::path(testing::TempDir()) / "bandwagon_suite_report.json";
  const SuiteResult one{"x/eth.yaml", {drive("a", true, 0, 0, 0.1), drive("b", false, 0, 0, 0.3)}};
  std::ofstream(file) << nlohmann::json{{"suites", {json_of(one), json_of({"x/hotel.yaml", one.episodes})}}};
  std::vector<SuiteResult> read;
  read_results(file, "", read);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(json_of(read[0]), json_of(one));
  std::ofstream(file) << json_of(one);
  read_results(file, "before", read);
  ASSERT_EQ(read.size(), 2U);
  ASSERT_EQ(read[0].episodes.size(), 4U);
  EXPECT_EQ(read[0].episodes[3].planner, "teb before");
  EXPECT_EQ(compared(read)[1].episodes.size(), 2U);
  std::ofstream(file) << "{}";
  EXPECT_THROW(read_results(file, "", read), std::runtime_error);
  EXPECT_THROW(read_results("no_such.json", "", read), std::runtime_error);
}

JudgedContact touched(double time, possible::Avoidance avoidance) {
  JudgedContact judged;
  judged.record.time = time;
  judged.is_judged = true;
  judged.verdict.avoidance = avoidance;
  return judged;
}

// Two robots, a contact each: success of both was impossible only if neither could be avoided.
TEST(ContactReport, JudgesAllRobots) {
  const JudgedContact lost = touched(3.0, possible::Avoidance::not_avoidable);
  const JudgedContact open = touched(4.0, possible::Avoidance::avoidable);
  nlohmann::json card = {{"reached", true}, {"collisions", 2}};
  add_contacts(card, {{"robot1", {lost}}, {"robot2", {open}}});
  EXPECT_EQ(card["contacts"].size(), 2U);
  EXPECT_EQ(card["contacts"][1]["robot"], "robot2");
  EXPECT_EQ(card["possible"], true);
  EXPECT_EQ(contacts_in_words(card, "").substr(0, 28), "robot1 at 3.00 s person 0: r");
  add_contacts(card, {{"robot1", {lost}}, {"robot2", {lost}}});
  EXPECT_EQ(card["possible"], false);
  add_contacts(card, {{"robot1", {lost}}, {"robot2", {}}});  // the second contact was with a wall
  EXPECT_EQ(card["possible"], true);
  add_contacts(card, {{"", {lost}}});
  EXPECT_FALSE(card["contacts"][0].contains("robot"));
}

// Whoever is late has failed, whatever its contacts: nothing shows that it could not have arrived.
TEST(ContactReport, WhoIsLateIsNeverExcused) {
  const JudgedContact lost = touched(3.0, possible::Avoidance::not_avoidable);
  nlohmann::json card = {{"reached", true}, {"collisions", 1}};
  add_contacts(card, {{"", {lost}}});
  EXPECT_EQ(card["possible"], false);
  card["reached"] = false;
  add_contacts(card, {{"", {lost}}});
  EXPECT_EQ(card["possible"], true);
  EpisodeResult late = drive("late", false, 1, 1, 0.6);
  late.card["possible"] = card["possible"];
  EXPECT_FALSE(late.is_excused());
  const std::vector<PlannerSummary> rows = summarize({"suite.yaml", {drive("a", true, 0, 0, 0.1), late}});
  EXPECT_EQ(rows[0].successes, 1);
  EXPECT_EQ(rows[0].possible, 2);
  // Undecided counts as possible.
  card["reached"] = true;
  add_contacts(card, {{"", {touched(3.0, possible::Avoidance::undecided)}}});
  EXPECT_EQ(card["possible"], true);
}

// One row for each suite and planner, planners in the order of --planners and not of the alphabet.
TEST(SuiteReport, OneTableForAllSuitesAndPlanners) {
  const auto by = [](const std::string& planner) {
    EpisodeResult result = drive("a", true, 0, 0, 0.1);
    result.planner = planner;
    return result;
  };
  const std::string words =
      words_of({{"x/hall.yaml", {by("teb"), by("dwa"), by("teb")}}, {"x/eth.yaml", {by("teb_homotopy")}}});
  std::vector<std::string> rows;
  std::istringstream lines(words);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string suite, planner, successes, of, drives;
    fields >> suite >> planner >> successes >> of >> drives;
    rows.push_back(suite + " " + planner + " " + successes + "/" + drives);
  }
  ASSERT_EQ(rows.size(), 7U) << words;  // and one line of contacts for each
  EXPECT_EQ(rows[1], "hall teb 2/2");
  EXPECT_EQ(rows[2], "hall dwa 1/1");
  EXPECT_EQ(rows[3], "eth teb_homotopy 1/1");
}

}  // namespace
}  // namespace bw
