// Packages for ROS 2: every type in them has the hash that we announce for it, computed from the exported
// text by another hand.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/wire/type_registry.hpp"
#include "tests/folder.hpp"
#include "tests/idl/interface_texts.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

const std::string kInterfaces = std::string(BANDWAGON_SOURCE_DIR) + "/idl";

Outcome export_to(const std::filesystem::path& folder, const std::vector<std::string>& packages) {
  std::vector<std::string> command = {IDL_COMPILER, "--ros2-package", kInterfaces, folder.string()};
  command.insert(command.end(), packages.begin(), packages.end());
  return run_to_end(command, std::chrono::seconds(30));
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t times = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++times;
  return times;
}

std::vector<std::string> all_packages() {
  std::vector<std::string> packages;
  for (const TypeDescription* type : all_types()) {
    const std::string package(type->ros_name.substr(0, type->ros_name.find('/')));
    if (std::find(packages.begin(), packages.end(), package) == packages.end()) packages.push_back(package);
  }
  return packages;
}

TEST(Ros2Package, EveryTypeHasOurHash) {
  const Folder folder;
  const Outcome outcome = export_to(folder / "src", all_packages());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  InterfaceTexts texts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "src")) {
    const std::filesystem::path parts = entry.path().lexically_relative(folder / "src");
    if (std::distance(parts.begin(), parts.end()) != 3 || !entry.is_regular_file()) continue;
    const std::string category = parts.parent_path().filename();
    ASSERT_EQ(parts.extension(), "." + category) << parts;
    ASSERT_NO_THROW(texts.read(*parts.begin(), category, parts.stem(), text_of(entry.path()))) << parts;
    // rosidl_generate_interfaces() takes the files it is told.
    EXPECT_EQ(count(text_of(folder / "src" / *parts.begin() / "CMakeLists.txt"),
                    "\n  \"" + category + "/" + parts.filename().string() + "\"\n"),
              1U)
        << parts;
  }
  const std::map<std::string, std::string> hashes = texts.hashes();
  for (const TypeDescription* type : all_types()) {
    const auto exported = hashes.find(std::string(type->ros_name));
    ASSERT_NE(exported, hashes.end()) << type->ros_name;
    EXPECT_EQ(exported->second, type->type_hash) << type->ros_name;
  }
  EXPECT_EQ(hashes.size(), all_types().size());
}

TEST(Ros2Package, KeepsTheCommentsOfAMessage) {
  const Folder folder;
  ASSERT_EQ(export_to(folder / "src", {"bandwagon_msgs"}).status, 0);
  EXPECT_EQ(
      text_of(folder / "src/bandwagon_msgs/msg/Track.msg"),
      "# One moving obstacle. Covariance of (x, y, vx, vy), row major [m, m/s]; radius [m]. Confidence: how sure it is that\n"
      "# this is a person (or another mover), 0 to 1; from 0.5 on they are confirmed, below they may be furniture, and at 0\n"
      "# they are an obstacle like any other and nothing more.\n"
      "\n"
      "uint32 id\n"
      "geometry_msgs/Point position\n"
      "geometry_msgs/Vector3 velocity\n"
      "float64[16] covariance\n"
      "float64 radius\n"
      "float64 confidence\n"
      "bandwagon_msgs/PredictedPosition[] predictions\n"
      "\n"
      "# Written by Bandwagon's export_ros2_messages.sh; changes to this file will be lost.\n");
  EXPECT_THAT(
      text_of(folder / "src/bandwagon_msgs/msg/ScoreCard.msg"),
      HasSubstr(
          "\n# odometry/filtered against the truth; NaN where nobody publishes it, the angle also where the truth has no "
          "heading\nuint32 localization_poses\n"));
  EXPECT_THAT(text_of(folder / "src/bandwagon_msgs/msg/FollowRequest.msg"),
              HasSubstr("uint8 STOP=0\nuint8 FOLLOW=1\n"));
}

// A package depends on those of the types it refers to, once each and not on itself; one with an action also
// on action_msgs.
TEST(Ros2Package, NamesItsDependencies) {
  const Folder folder;
  ASSERT_EQ(export_to(folder / "src", {"bandwagon_msgs", "nav2_msgs", "std_msgs"}).status, 0);
  const auto depends = [&](const std::string& package) {
    const std::string text = text_of(folder / "src" / package / "package.xml");
    std::vector<std::string> names;
    for (std::size_t at = 0; (at = text.find("  <depend>", at)) != std::string::npos;) {
      at += 10;
      names.push_back(text.substr(at, text.find('<', at) - at));
      EXPECT_EQ(count(text_of(folder / "src" / package / "CMakeLists.txt"),
                      "find_package(" + names.back() + " REQUIRED)\n"),
                1U);
    }
    return names;
  };
  EXPECT_THAT(depends("bandwagon_msgs"),
              testing::ElementsAre("builtin_interfaces", "geometry_msgs", "nav_msgs", "std_msgs"));
  EXPECT_THAT(depends("nav2_msgs"), testing::ElementsAre("action_msgs", "builtin_interfaces", "geometry_msgs",
                                                         "nav_msgs", "std_msgs"));
  EXPECT_THAT(depends("std_msgs"), testing::ElementsAre("builtin_interfaces"));
  const std::string manifest = text_of(folder / "src/bandwagon_msgs/package.xml");
  EXPECT_THAT(manifest, HasSubstr("<package format=\"3\">\n  <name>bandwagon_msgs</name>\n"));
  EXPECT_THAT(manifest, HasSubstr("  <member_of_group>rosidl_interface_packages</member_of_group>\n"));
}

TEST(Ros2Package, LeavesTheFilesOfOthersAlone) {
  const Folder folder;
  const std::filesystem::path theirs = folder / "src/bandwagon_msgs/CMakeLists.txt";
  std::filesystem::create_directories(theirs.parent_path());
  std::ofstream(theirs) << "project(mine)\n";
  const Outcome refused = export_to(folder / "src", {"bandwagon_msgs"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr(theirs.string() +
                                     ": exists and was not written by this program; nothing was written\n"));
  EXPECT_EQ(text_of(theirs), "project(mine)\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "src/bandwagon_msgs/package.xml"));
  std::filesystem::remove(theirs);
  ASSERT_EQ(export_to(folder / "src", {"bandwagon_msgs"}).status, 0);
  EXPECT_EQ(export_to(folder / "src", {"bandwagon_msgs"}).status, 0);  // its own it may replace
  EXPECT_THAT(text_of(theirs), HasSubstr("project(bandwagon_msgs)\n"));
}

TEST(Ros2Package, RefusesAPackageThatDoesNotExist) {
  const Folder folder;
  const Outcome refused = export_to(folder / "src", {"bandwagon_msgs", "no_msgs"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.err, "bandwagon_idl_compiler: no package no_msgs in " + kInterfaces + "\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "src"));
}

// The other hand can tell: one field more, one less, or another order is another hash.
TEST(InterfaceTexts, SeeADifference) {
  const auto hash = [](const std::string& text) {
    InterfaceTexts texts;
    texts.read("std_msgs", "msg", "String", text);
    return texts.hashes().at("std_msgs/msg/String");
  };
  EXPECT_EQ(hash("string data\n"),
            "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");  // Jazzy's
  EXPECT_NE(hash("string data\nbool x\n"), hash("bool x\nstring data\n"));
  EXPECT_NE(hash("string<=5 data\n"), hash("string data\n"));
  EXPECT_THROW(hash("string Data\n"), std::runtime_error);
  EXPECT_THROW(hash("string data_\n"), std::runtime_error);
}

}  // namespace
}  // namespace bw::test
