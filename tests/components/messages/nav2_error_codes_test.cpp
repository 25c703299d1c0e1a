// The table of error codes for people against the constants of Nav2's definitions, as they stand in the files
// of idl/.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace bw {
namespace {

const std::filesystem::path kRoot = BANDWAGON_SOURCE_DIR;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  EXPECT_TRUE(in) << file;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

using Codes = std::set<std::pair<int, std::string>>;

/// Of every action of every distribution.
Codes defined_codes() {
  Codes codes;
  const std::regex constant("const uint16 ([A-Z_]+) = ([0-9]+);");
  for (const char* folder : {"idl/nav2_msgs/action", "idl/distros/kilted/nav2_msgs/action",
                             "idl/distros/lyrical/nav2_msgs/action"}) {
    for (const auto& entry : std::filesystem::directory_iterator(kRoot / folder)) {
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator it(text.begin(), text.end(), constant), end; it != end; ++it)
        codes.insert({std::stoi((*it)[2]), (*it)[1]});
    }
  }
  return codes;
}

/// Rows of the table: `| 200, 300 | UNKNOWN | ... |`, or as many names as codes.
Codes told_codes() {
  Codes codes;
  const std::string text = text_of(kRoot / "components/model/nav2_error_codes.md");
  const std::regex row("\\| ([0-9, ]+) \\| ([A-Z0-9_, ]+) \\| ");
  for (std::sregex_iterator it(text.begin(), text.end(), row), end; it != end; ++it) {
    std::istringstream numbers((*it)[1]), names((*it)[2]);
    std::string name;
    for (std::string number; std::getline(numbers, number, ',');) {
      if (std::string next; names >> next) name = next.substr(0, next.find(','));
      codes.insert({std::stoi(number), name});
    }
  }
  return codes;
}

TEST(Nav2ErrorCodes, TheTableHasThoseOfTheDefinitionsAndNoOthers) {
  Codes defined = defined_codes();
  // 0, 1, 2; 9 of following, 9 and 10 of planning, 4 of waypoints, 4 + 5 + 5 of behaviors, 4 + 4 of
  // navigators.
  ASSERT_EQ(defined.size(), 3U + 9 + 9 + 10 + 4 + 4 + 5 + 5 + 4 + 4);
  defined.insert({740, "UNKNOWN"});  // of Kilted's Wait, whose definition is Jazzy's here
  EXPECT_EQ(told_codes(), defined);
}

}  // namespace
}  // namespace bw
