// `evaluate --html`: a page of each drive that failed, and of no other.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "components/viewer/adaptor/site.hpp"
#include "tests/folder.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

// Two drives of 1 m in a room to oneself; one of them has its goal behind the wall at y = 3.
constexpr const char* kSuite = R"(graph: GRAPH
time_limit: 12
seeds: {first: 3, last: 3}
episodes:
  - {name: near, set: ["navigator.goal={enabled: true, x: 2.0, y: 0.0, theta: 0.0}"]}
  - {name: outside, set: ["navigator.goal={enabled: true, x: 2.0, y: 5.0, theta: 0.0}"]}
)";

TEST(FailedDrives, HaveAPageEach) {
  const Folder folder;
  std::string suite = kSuite;
  suite.replace(suite.find("GRAPH"), 5, std::string(BANDWAGON_SOURCE_DIR) + "/tests/interop/one_room.yaml");
  std::ofstream(folder / "suite.yaml") << suite;
  const std::filesystem::path pages = folder / "pages";
  const std::filesystem::path json = folder / "out.json";
  const Outcome run = run_to_end({BANDWAGON_PROGRAM, "evaluate", (folder / "suite.yaml").string(), "--html",
                                  pages.string(), "--json", json.string()},
                                 std::chrono::seconds(120));
  if (viewer::page_files().empty()) {
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("this program was built without the page"));
    return;
  }
  ASSERT_EQ(run.status, 0) << run.err;
  const nlohmann::json episodes = nlohmann::json::parse(std::ifstream(json))["episodes"];
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_TRUE(episodes[0]["success"].get<bool>());
  EXPECT_FALSE(episodes[0].contains("page"));
  EXPECT_FALSE(episodes[1]["success"].get<bool>());
  EXPECT_EQ(episodes[1]["page"], (pages / "outside_seed3.html").string());
  EXPECT_THAT(run.out, HasSubstr((pages / "outside_seed3.html").string()));
  EXPECT_GT(std::filesystem::file_size(pages / "outside_seed3.html"), 10'000U);
  EXPECT_FALSE(std::filesystem::exists(pages / "near_seed3.html"));
  EXPECT_THAT(run.err, testing::Not(HasSubstr("not the same drive")));
}

}  // namespace
}  // namespace bw::test
