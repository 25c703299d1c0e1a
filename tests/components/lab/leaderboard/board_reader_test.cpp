#include "components/lab/leaderboard/board_reader.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/lab/leaderboard/board_page.hpp"

namespace bw {
namespace {

class BoardFiles : public testing::Test {
 protected:
  BoardFiles() { std::filesystem::create_directories(folder); }
  ~BoardFiles() override { std::filesystem::remove_all(folder); }
  std::filesystem::path file(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name) << content;
    return folder / name;
  }
  std::string fault(const std::string& content) {
    try {
      read_board(file("bad.json", content), suites);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "none";
  }
  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "bandwagon_board";
  std::vector<BoardSuite> suites;
};

constexpr const char* kScenes =
    R"({"prediction": "constant_velocity", "made": {"revision": "0123456789abcdef",
  "date": "2026-01-02", "command": "bandwagon-lab bench dynabarn"},
  "rows": [{"set": "easy", "planner": "eteb", "drives": [
    {"name": "world_00, phases 1", "success": true, "time_s": 10.5, "contacts": [], "mean_ms": 0.5},
    {"name": "world_00, phases 2", "success": false, "time_s": 11.0, "contacts": [{"who": "person_side"}], "mean_ms": 0.7}]}]})";

TEST_F(BoardFiles, OfScenesHaveWorldsAsStarts) {
  read_board(file("a.json", kScenes), suites);
  ASSERT_EQ(suites.size(), 1U);
  EXPECT_EQ(suites[0].name, "easy");
  EXPECT_FALSE(suites[0].whole_graph);
  EXPECT_EQ(suites[0].rows[0].made, "revision 0123456789ab, 2026-01-02, bandwagon-lab bench dynabarn");
  const std::vector<BoardFigures> figures = figures_of(suites[0]);
  EXPECT_EQ(figures[0].drives, 2);
  EXPECT_EQ(figures[0].starts, 1);
  EXPECT_EQ(figures[0].successes, 1);
  EXPECT_DOUBLE_EQ(*figures[0].cycle, 0.6);
  EXPECT_EQ(figures[0].contacts.to_json()["person_side"], 1);
}

TEST_F(BoardFiles, OfEvaluationsHaveARowForEachPlanner) {
  read_board(file("b.json", R"({"suite": "config/suites/hallway.yaml", "episodes": [
    {"name": "full", "seed": 1, "planner": "eteb", "success": true, "time_to_goal_s": 22.0, "contacts": [], "planner_ms": {"mean_ms": 1.0}},
    {"name": "full", "seed": 1, "planner": "teb", "success": false, "time_to_goal_s": null, "contacts": [], "planner_ms": null, "page": "f.html"}]})"),
             suites);
  ASSERT_EQ(suites[0].rows.size(), 2U);
  EXPECT_TRUE(suites[0].whole_graph);
  EXPECT_EQ(suites[0].rows[1].drives[0].page, "f.html");
  EXPECT_EQ(suites[0].rows[0].drives[0].key, "full, seed 1");
  const std::string page = board_page(suites).json().dump();
  EXPECT_THAT(page, testing::HasSubstr("[teb, full, seed 1](f.html)"));
}

// A variant is a suite of its own, and values of --vary are departures of one start, whose drives are not independent.
TEST_F(BoardFiles, OfVariantsAreSuitesAndOfDeparturesOneStart) {
  read_board(file("v.json", R"({"suite": "eth.yaml", "episodes": [
    {"name": "eth_1s_0.6", "episode": "eth_1s", "variant": "own", "seed": 1, "planner": "eteb own", "success": true},
    {"name": "eth_1s_0.8", "episode": "eth_1s", "variant": "own", "seed": 1, "planner": "eteb own", "success": false}]})"),
             suites);
  ASSERT_EQ(suites.size(), 1U);
  EXPECT_EQ(suites[0].name, "eth, own");
  EXPECT_EQ(suites[0].rows[0].planner, "eteb");
  const BoardFigures figures = figures_of(suites[0])[0];
  EXPECT_EQ(figures.drives, 2);
  EXPECT_EQ(figures.starts, 1);
  EXPECT_EQ(suites[0].rows[0].drives[1].key, "eth_1s_0.8, seed 1");
}

// `bench course`: whole robots, with a score of its own rule, of which 0.5 and 0 are 0.25.
TEST_F(BoardFiles, OfCoursesHaveAScore) {
  read_board(
      file("c.json",
           R"({"whole_graph": true, "rows": [{"set": "BARN, given worlds", "planner": "eteb", "drives": [
    {"name": "world_000", "success": true, "contacts": 0, "time_s": 5.0, "score": 0.5, "mean_ms": 1.0},
    {"name": "world_030", "success": false, "contacts": 1, "time_s": 9.0, "score": 0.0, "mean_ms": 1.0}]}]})"),
      suites);
  ASSERT_EQ(suites.size(), 1U);
  EXPECT_TRUE(suites[0].whole_graph);
  EXPECT_DOUBLE_EQ(*figures_of(suites[0])[0].score, 0.25);
  EXPECT_THAT(board_page(suites).json().dump(), testing::HasSubstr("score"));
}

// `bench crowd`: one planner is a row alone, several are `planners`.
TEST_F(BoardFiles, OfACrowdHaveOnePlannerOrSeveral) {
  const std::string row =
      R"({"planner": "teb", "episodes": [{"name": "31001", "success": true, "time_s": 20.0}]})";
  read_board(file("one.json", row), suites);
  read_board(file("two.json", R"({"planners": [{"planner": "eteb", "episodes": []}]})"), suites);
  ASSERT_EQ(suites.size(), 1U);
  EXPECT_EQ(suites[0].name, "walkers who do not react");
  ASSERT_EQ(suites[0].rows.size(), 2U);
  EXPECT_EQ(suites[0].rows[0].drives[0].key, "31001");
  read_board(file("again.json", row), suites, "tuned");
  EXPECT_EQ(suites[0].rows[2].planner, "teb tuned");
}

TEST_F(BoardFiles, AreRefusedByName) {
  EXPECT_THAT(fault("{"), testing::HasSubstr("bad.json: "));
  EXPECT_THAT(fault(R"({"x": 1})"), testing::HasSubstr("bad.json: holds no drives"));
  read_board(file("a.json", kScenes), suites);
  EXPECT_THAT(fault(kScenes), testing::HasSubstr("eteb of easy is there already"));
}

}  // namespace
}  // namespace bw
