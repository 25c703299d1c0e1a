// Every frame that a message names hangs on the tree of transforms, as rviz2 needs it.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/known_type.hpp"
#include "runtime/wire/yaml.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

/// What a recorded run names: topics by frame, and the parent of each frame that a transform places.
struct Frames {
  std::map<std::string, std::set<std::string>> named_by;
  std::map<std::string, std::string> parent;

  /// The frame at the end of the chain of parents; empty for a circle.
  std::string root_of(std::string frame) const {
    for (std::size_t steps = 0; steps <= parent.size(); ++steps) {
      const auto up = parent.find(frame);
      if (up == parent.end()) return frame;
      frame = up->second;
    }
    return {};
  }
};

std::vector<std::string> values_of(const std::string& key, const std::string& yaml) {
  const std::regex line("(?:^|\\n)[ -]*" + key + ": ([^\\n]*)");
  std::vector<std::string> values;
  for (std::sregex_iterator match(yaml.begin(), yaml.end(), line), end; match != end; ++match)
    values.push_back((*match)[1]);
  return values;
}

Frames frames_of(const std::filesystem::path& file) {
  const auto recording = bag::open_bag(file);
  Frames frames;
  std::map<std::size_t, int> seen;
  auto messages = recording->messages({});
  for (bag::BagMessage m; messages->next(m) == bag::Step::message;) {
    if (++seen[m.topic] > 30) continue;
    const bag::BagTopic& topic = recording->topics()[m.topic];
    const bag::KnownType known = bag::known_type(topic);
    if (known.type == nullptr) {
      ADD_FAILURE() << topic.name << ": " << known.why;
      continue;
    }
    const std::string yaml = to_yaml(*known.type, m.data);
    const std::vector<std::string> named = values_of("frame_id", yaml);
    const std::vector<std::string> children = values_of("child_frame_id", yaml);
    for (const std::string& frame : named) frames.named_by[frame].insert(topic.name);
    for (const std::string& frame : children) frames.named_by[frame].insert(topic.name);
    if (!topic.name.starts_with("/tf")) continue;
    for (std::size_t i = 0; i < children.size(); ++i) frames.parent[children[i]] = named.at(i);
  }
  return frames;
}

Frames frames_of_run(const std::string& graph, const std::string& seconds) {
  const std::filesystem::path recording = std::filesystem::temp_directory_path() / "frames.mcap";
  std::filesystem::remove(recording);
  const Outcome run = run_to_end({BANDWAGON_PROGRAM, "run", graph, "--clock", "lockstep", "--seed", "7",
                                  "--for", seconds, "--record", recording.string()},
                                 std::chrono::seconds(100));
  EXPECT_TRUE(std::filesystem::exists(recording)) << run.err;
  return frames_of(recording);
}

void expect_one_tree(const Frames& frames, const std::string& root) {
  for (const auto& [frame, topics] : frames.named_by) {
    if (frame == "''") continue;  // joints are in no frame, nor is a marker that deletes all others
    EXPECT_EQ(frames.root_of(frame), root) << frame << " of " << testing::PrintToString(topics);
  }
}

TEST(Frames, OfTheWholeHallwayAreOneTreeUnderMap) {
  const Frames frames = frames_of_run(std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml", "6");
  expect_one_tree(frames, "map");
  for (const char* frame : {"map", "odom", "base_link", "laser", "imu", "gps"})
    EXPECT_TRUE(frames.named_by.contains(frame)) << frame;
}

TEST(Frames, OfTwoRobotsAreOneTreeUnderTheMapTheyShare) {
  const Frames frames =
      frames_of_run(std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/two_robots.yaml", "6");
  expect_one_tree(frames, "map");
  for (const std::string robot : {"robot1/", "robot2/"}) {
    for (const char* frame : {"odom", "base_link", "laser", "imu", "gps"})
      EXPECT_TRUE(frames.named_by.contains(robot + frame)) << robot << frame;
  }
  for (const char* frame : {"odom", "base_link", "robot1/map"})
    EXPECT_FALSE(frames.named_by.contains(frame)) << frame;
}

// As each of several real robots runs a graph of its own: names below robot1, frames with its prefix, but the
// map.
TEST(Frames, OfARobotWithNamespaceAndPrefixHangOnTheMapAllShare) {
  const std::string folder = std::string(BANDWAGON_SOURCE_DIR) + "/config/";
  std::ifstream hallway(folder + "graphs/hallway.yaml");
  std::string text((std::istreambuf_iterator<char>(hallway)), std::istreambuf_iterator<char>());
  const std::string robot = "../robots/";
  text.replace(text.find(robot), robot.size(), folder + "robots/");
  const std::string graph = (std::filesystem::temp_directory_path() / "namespaced.yaml").string();
  std::ofstream(graph) << "namespace: robot1\nframe_prefix: robot1/\n" << text;
  const Frames frames = frames_of_run(graph, "6");
  expect_one_tree(frames, "map");
  EXPECT_TRUE(frames.named_by.contains("robot1/laser"));
  EXPECT_TRUE(frames.named_by.at("map").contains("/robot1/score_card")) << "nobody judges the drive";
  EXPECT_FALSE(frames.named_by.contains("robot1/map"));
}

// A graph that says nothing of the robot's sensors: they sit at base_link, and tf says so.
TEST(Frames, OfSensorsThatTheRobotDoesNotListSitAtTheBase) {
  const std::string graph = (std::filesystem::temp_directory_path() / "frames.yaml").string();
  std::ofstream(graph)
      << "components:\n  world: {parameters: {laser: {frame: scanner}}}\n  robot_base:\n    inputs: "
         "{wheel_commands: {external: true}}\n";
  const Frames frames = frames_of_run(graph, "2");
  for (const char* sensor : {"scanner", "imu", "gps"}) {
    EXPECT_TRUE(frames.named_by.contains(sensor)) << sensor;
    EXPECT_EQ(frames.parent.contains(sensor) ? frames.parent.at(sensor) : "", "base_link") << sensor;
  }
}

}  // namespace
}  // namespace bw::test
