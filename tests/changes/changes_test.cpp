// Each component of the hallway meets five recorded seconds again; what it answers stands in tests/changes as
// text.
// A difference is a change of behaviour: wanted, and then BANDWAGON_UPDATE_CHANGES=1 writes the files anew,
// or not.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

const std::filesystem::path kSource = BANDWAGON_SOURCE_DIR;
const std::filesystem::path kFolder = kSource / "tests" / "changes";

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The first line in which two texts differ, with both.
std::string first_difference(const std::string& stored, const std::string& now) {
  std::istringstream a(stored), b(now);
  std::string left, right, topic;
  for (int line = 1;; ++line) {
    const bool has_left = static_cast<bool>(std::getline(a, left));
    const bool has_right = static_cast<bool>(std::getline(b, right));
    if (!has_left && !has_right) return "";
    if (has_left && left.starts_with("/")) topic = left;
    if (has_left == has_right && left == right) continue;
    return "line " + std::to_string(line) + " (" + topic + ")\n- " + (has_left ? left : "") + "\n+ " +
           (has_right ? right : "");
  }
}

class Changes : public testing::TestWithParam<const char*> {};

TEST_P(Changes, TheAnswersAreThoseOnFile) {
  const std::string component = GetParam();
  const std::filesystem::path now = std::filesystem::path(BANDWAGON_BINARY_DIR) / (component + ".txt");
  const std::filesystem::path stored = kFolder / (component + ".txt");
  std::filesystem::remove(now);
  const Outcome outcome =
      run_to_end({BANDWAGON_PROGRAM, "replay", kFolder / "hallway.mcap", "--graph",
                  kSource / "config" / "graphs" / "hallway.yaml", "--text", now, "--run", component},
                 std::chrono::seconds(120));
  // 1: the bytes differ, which another build alone can do; the text is the rule here.
  ASSERT_TRUE(outcome.status == 0 || outcome.status == 1) << outcome.out << outcome.err;
  const std::string text = content_of(now);
  EXPECT_GT(text.size(), 100U);
  if (std::getenv("BANDWAGON_UPDATE_CHANGES") != nullptr)
    std::filesystem::copy_file(now, stored, std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(first_difference(content_of(stored), text), "")
      << "all of it: diff " << stored << " " << now
      << "\nif it is wanted: BANDWAGON_UPDATE_CHANGES=1 ctest -R changes";
}

INSTANTIATE_TEST_SUITE_P(Hallway, Changes,
                         testing::Values("localization", "people", "local_costmap", "global_planner",
                                         "local_planner", "collision_monitor", "navigator"),
                         [](const auto& component) { return std::string(component.param); });

}  // namespace
}  // namespace bw::test
