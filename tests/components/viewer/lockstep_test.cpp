// A run in lock-step that is looked at: the same bytes as without; and one that is commanded from the page:
// the record says all of it.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "runtime/recording/bag/bag.hpp"
#include "tests/components/viewer/foxglove_client.hpp"
#include "tests/folder.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using Bytes = FoxgloveClient::Bytes;

const std::string kGraph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";

std::vector<std::string> hallway(const std::filesystem::path& card, const std::vector<std::string>& more) {
  std::vector<std::string> command = {BANDWAGON_PROGRAM, "run", kGraph,   "--clock", "lockstep",
                                      "--seed",          "7",   "--stay", "--json",  card};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

nlohmann::json card(const std::filesystem::path& path) { return nlohmann::json::parse(std::ifstream(path)); }

PageAddress page_of(const Process& run) {
  PageAddress page;
  eventually([&] { return (page = page_in(run.out())).port != 0; });
  return page;
}

nlohmann::json goal(double x) {
  return {{"header", {{"frame_id", "map"}, {"stamp", {{"sec", 1700000000}, {"nsec", 0}}}}},
          {"pose", {{"position", {{"x", x}}}, {"orientation", {{"w", 1.0}}}}}};
}

std::map<std::string, std::multiset<Bytes>> recorded(const std::filesystem::path& path) {
  const auto bag = bag::open_bag(path);
  const auto all = bag->messages({});
  std::map<std::string, std::multiset<Bytes>> messages;
  for (bag::BagMessage one; all->next(one) == bag::Step::message;)
    messages[bag->topics()[one.topic].name].emplace(one.data.begin(), one.data.end());
  return messages;
}

// What a client sees is what was recorded, to the byte; it may miss some while it begins to hear.
TEST(ViewerInLockstep, WhoLooksOnChangesNothingAndSeesTheBytesOfTheRecord) {
  const Folder folder;
  const Outcome alone =
      run_to_end(hallway(folder / "alone.json", {"--for", "20", "--pace", "0"}), std::chrono::seconds(60));
  ASSERT_EQ(alone.status, 0) << alone.err;

  Process run(hallway(folder / "seen.json",
                      {"--for", "20", "--pace", "1", "--page=0", "--record", folder / "drive.mcap"}));
  FoxgloveClient client(page_of(run), true);
  client.advertise(1, "/goal_pose", "geometry_msgs/PoseStamped");
  client.publish(1, goal(3.0));
  EXPECT_TRUE(client.hears_status("start it with --accept-inputs"));
  ASSERT_EQ(run.wait(std::chrono::seconds(60)), 0) << run.err();
  EXPECT_EQ(client.info()["metadata"]["clock"], "lockstep");
  EXPECT_EQ(client.info()["metadata"]["accept_inputs"], "false");

  EXPECT_EQ(card(folder / "seen.json")["samples_sha256"], card(folder / "alone.json")["samples_sha256"]);
  EXPECT_EQ(card(folder / "seen.json")["inputs"], "graph");

  auto bag = recorded(folder / "drive.mcap");
  std::size_t count = 0;
  for (const auto& [topic, seen] : client.messages()) {
    for (const auto& message : seen) {
      const auto same = bag[topic].find(message.cdr);
      ASSERT_NE(same, bag[topic].end()) << topic << ": a message that is not in the record";
      bag[topic].erase(same);
      ++count;
      EXPECT_GE(message.time, 1000'000'000'000) << topic;  // virtual time begins at 1000 s
      EXPECT_LE(message.time, 1022'000'000'000) << topic;
    }
  }
  // The run takes 20 s of real time and has 1,000 messages of /odom: some of them are heard however busy the
  // machine is.
  EXPECT_GT(count, 500U);
  EXPECT_GT(client.messages()["/odom"].size(), 50U);
  EXPECT_EQ(client.messages()["/map"].size(), 1U);
  EXPECT_GT(client.messages().size(), 30U);
}

TEST(ViewerInLockstep, TwentyClicksAreAPartOfTheRecord) {
  const Folder folder;
  Process run(hallway(folder / "clicks.json", {"--for", "16", "--pace", "2", "--page=0", "--accept-inputs",
                                               "--record", folder / "drive"}));
  FoxgloveClient client(page_of(run), false);
  client.advertise(1, "/goal_pose", "geometry_msgs/PoseStamped");
  ASSERT_TRUE(client.subscribe("/odom"));
  for (int i = 0; i < 20; ++i) {
    const double when = 1003.0 + 0.5 * i;  // virtual time begins at 1000 s
    ASSERT_TRUE(eventually([&] { return client.seconds() >= when || client.is_closed(); }));
    client.publish(1, goal(i % 2 == 0 ? 12.0 : 18.0));
  }
  ASSERT_EQ(run.wait(std::chrono::seconds(60)), 0) << run.err();
  EXPECT_EQ(card(folder / "clicks.json")["inputs"], "outside");

  EXPECT_EQ(recorded(folder / "drive")["/goal_pose"].size(), 20U);
  for (const char* component : {"navigator", "global_planner", "local_planner", "motor_control"}) {
    const Outcome replay = run_to_end({BANDWAGON_PROGRAM, "replay", folder / "drive", "--graph", kGraph,
                                       "--clock", "lockstep", "--run", component},
                                      std::chrono::seconds(120));
    EXPECT_EQ(replay.status, 0) << component << ": " << replay.out << replay.err;
  }
}

}  // namespace
}  // namespace bw::test
