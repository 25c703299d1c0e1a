// A drive of the hallway is recorded and scored by two commands: the bag holds the truth, so no labels are
// needed.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/folder.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

class BenchPeopleVerb : public testing::Test {
 protected:
  static Outcome bandwagon(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
    return run_to_end(arguments, std::chrono::seconds(120));
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const {
    std::ifstream in(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  Folder folder_;
};

TEST_F(BenchPeopleVerb, ScoresARecordedHallway) {
  const std::string graph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";
  const Outcome drive = bandwagon(
      {"run", graph, "--clock", "lockstep", "--seed", "7", "--for", "10", "--record", file("drive")});
  ASSERT_TRUE(std::filesystem::exists(file("drive"))) << drive.err;
  const std::vector<std::string> bench = {"bench", "people", file("drive"), "--graph", graph};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), bench.begin(), bench.end());
    return bandwagon(more);
  };
  const Outcome first = with({"--json", file("a.json"), "--errors"});
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("/sim/ground_truth: "));
  const std::string bytes = content("a.json");
  const Outcome second = with({"--json", file("a.json"), "--errors"});
  EXPECT_EQ(first.out, second.out);
  EXPECT_EQ(bytes, content("a.json")) << "the same command, the same bytes";
  const Outcome drawn = with({"--page", file("a.html")});
  if (drawn.status == 0) {
    EXPECT_THAT(content("a.html"), HasSubstr("distance from the robot [m]"));
  } else {  // a program without the page says so before it replays anything
    EXPECT_THAT(drawn.err, HasSubstr("built without the page"));
  }
  const Outcome retired = with({"--svg", file("a.svg")});
  EXPECT_EQ(retired.status, 2);
  EXPECT_THAT(retired.err, HasSubstr("tracks are shown by --page FILE.html"));

  const auto json = nlohmann::json::parse(content("a.json"));
  EXPECT_TRUE(json["truth"]);
  ASSERT_EQ(json["stretches"].size(), 1U);
  EXPECT_GT(json["stretches"][0]["places"],
            200);  // some of eight people within 6 m, ten times a second for 10 s
  EXPECT_GT(json["stretches"][0]["mota"], 0.6);
  EXPECT_LT(json["stretches"][0]["motp_m"], 0.15);

  std::ofstream(file("bad.csv")) << "time,id,x,y,frame\n1,1,0,0,map\n0.5,1,0,0,map\n";
  const Outcome bad = with({"--labels", file("bad.csv")});
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.err, HasSubstr("bad.csv:3: column time: is before that of line 2: times must not fall"));
}

}  // namespace
}  // namespace bw::test
