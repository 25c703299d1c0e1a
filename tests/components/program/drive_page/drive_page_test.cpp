// `run --html`, `replay --html` and `view --html` as a person runs them.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "components/viewer/adaptor/site.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "tests/components/program/drive_page/page_parts.hpp"
#include "tests/folder.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

const std::string kGraph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";
constexpr auto kLimit = std::chrono::seconds(120);

Outcome bandwagon(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
  return run_to_end(arguments, kLimit);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The bag in the page, as a file beside it.
std::unique_ptr<bag::Bag> bag_of(const std::filesystem::path& html) {
  const std::vector<std::uint8_t> bytes =
      from_base64(between(between(text_of(html), "id=\"bag\"", "</script>") + "<", ">", "<"));
  const std::filesystem::path file = html.string() + ".mcap";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return bag::open_bag(file);
}

std::set<std::string> topics_with_messages(const bag::Bag& bag) {
  std::set<std::string> names;
  for (const bag::BagTopic& topic : bag.topics())
    if (topic.message_count > 0) names.insert(topic.name);
  return names;
}

bool has_page() { return !viewer::page_files().empty(); }

// 4 s of the hallway in virtual time: the robot sees people, plans and drives.
std::vector<std::string> short_drive() {
  return {"run", kGraph, "--clock", "lockstep", "--seed", "7", "--for", "4"};
}

TEST(DrivePage, HoldsWhatThePageShowsOfTheDrive) {
  if (!has_page()) return;  // the program without it is looked at below
  const Folder folder;
  const std::filesystem::path html = folder / "pages/drive.html";
  std::vector<std::string> command = short_drive();
  command.insert(command.end(), {"--html", html.string(), "--json", (folder / "with.json").string()});
  const Outcome run = bandwagon(command);
  EXPECT_EQ(run.status, 1) << run.err;  // the goal is not reached within 4 s
  const std::string page = text_of(html);
  EXPECT_THAT(page, HasSubstr("data-name=\"hallway seed 7\""));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"/")));
  const auto bag = bag_of(html);
  EXPECT_TRUE(bag->faults().empty());
  EXPECT_NEAR((bag->end() - bag->start()).to_seconds(), 4.0, 0.1);
  EXPECT_THAT(
      topics_with_messages(*bag),
      IsSupersetOf({"/map", "/tf", "/tf_static", "/scan", "/odom", "/tracks", "/local_plan", "/cmd_vel",
                    "/local_costmap", "/navigation_status", "/local_planner_cycle", "/comfort"}));
  EXPECT_THAT(topics_with_messages(*bag), Not(testing::Contains("/sim/wheel_commands")));

  // The page is made aside: the run is the same without.
  std::vector<std::string> without = short_drive();
  without.insert(without.end(), {"--json", (folder / "without.json").string()});
  bandwagon(without);
  const auto hash = [&](const char* name) {
    return nlohmann::json::parse(std::ifstream(folder / name))["samples_sha256"].get<std::string>();
  };
  EXPECT_EQ(hash("with.json"), hash("without.json"));
}

TEST(DrivePage, OfAReplayHoldsTheNewOutputs) {
  if (!has_page()) return;
  const Folder folder;
  std::vector<std::string> command = short_drive();
  command.insert(command.end(), {"--record", (folder / "drive.mcap").string()});
  bandwagon(command);
  const std::filesystem::path html = folder / "replay.html";
  const Outcome replay = bandwagon({"replay", (folder / "drive.mcap").string(), "--graph", kGraph, "--run",
                                    "local_planner", "--html", html.string()});
  EXPECT_EQ(replay.status, 0) << replay.out << replay.err;
  EXPECT_THAT(text_of(html), HasSubstr("data-name=\"drive replayed\""));
  EXPECT_THAT(topics_with_messages(*bag_of(html)), IsSupersetOf({"/map", "/tracks", "/local_plan"}));
}

TEST(DrivePage, IsMadeOfARecordingToo) {
  if (!has_page()) return;
  const Folder folder;
  std::vector<std::string> command = short_drive();
  command.insert(command.end(), {"--record", (folder / "drive.mcap").string()});
  bandwagon(command);
  const std::string html = (folder / "view.html").string();
  EXPECT_EQ(bandwagon({"view", (folder / "drive.mcap").string(), "--html", html}).status, 0);
  const auto from = bag::open_bag(folder / "drive.mcap");
  const auto shown = bag_of(html);
  // Every message of what is shown: the odometry's 50 Hz for 4 s.
  const auto count = [](const bag::Bag& bag) {
    const auto found = std::ranges::find(bag.topics(), "/odom", &bag::BagTopic::name);
    return found == bag.topics().end() ? 0U : found->message_count;
  };
  EXPECT_NEAR(static_cast<double>(count(*shown)), 200.0, 5.0);
  EXPECT_EQ(count(*shown), count(*from));

  const Outcome nothing = bandwagon({"view", (folder / "no.mcap").string(), "--html", html});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_THAT(nothing.err, HasSubstr("no.mcap"));
}

TEST(DrivePage, IsRefusedBeforeTheDriveWhereTheProgramHasNoPage) {
  if (has_page()) return;
  const Folder folder;
  std::vector<std::string> command = short_drive();
  command.insert(command.end(), {"--html", (folder / "drive.html").string()});
  const Outcome run = bandwagon(command);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("drive.html: this program was built without the page"));
  EXPECT_FALSE(std::filesystem::exists(folder / "drive.html"));
}

TEST(DrivePage, ThatCannotBeWrittenFailsTheRunAndSaysSo) {
  if (!has_page()) return;
  const Folder folder;
  std::ofstream(folder / "file") << "in the way";
  std::vector<std::string> command = short_drive();
  const std::string html = (folder / "file/drive.html").string();
  command.insert(command.end(), {"--html", html});
  const Outcome run = bandwagon(command);
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("--html: " + html + " is not written: "));
}

}  // namespace
}  // namespace bw::test
