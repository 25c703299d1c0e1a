#include "runtime/supervisor/rotating_log.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>

#include "tests/folder.hpp"

namespace bw::test {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(RotatingLog, KeepsTheLastOnesWithinTwiceItsSize) {
  const Folder folder;
  const std::filesystem::path path = folder / "planning.log";
  RotatingLog log(path, 10);
  for (const char* line : {"first\n", "second\n", "third\n", "fourth\n"}) log.write(line);
  EXPECT_EQ(content(path), "fourth\n");
  EXPECT_EQ(content(path.string() + ".1"), "third\n");
  EXPECT_EQ(log.last_words(), "fourth");
}

TEST(RotatingLog, GoesOnWithWhatIsThere) {
  const Folder folder;
  std::ofstream(folder / "a.log") << "before\n";
  RotatingLog log(folder / "a.log");
  log.write("after\n");
  EXPECT_EQ(content(folder / "a.log"), "before\nafter\n");
}

// /dev/full: each write fails with ENOSPC.
TEST(RotatingLog, AFullDiskCostsLinesAndNothingElse) {
  RotatingLog log("/dev/full");
  log.write("one\ntwo\n");
  EXPECT_THAT(log.fault(), testing::HasSubstr("/dev/full: No space left on device"));
  EXPECT_EQ(log.lost(), 8U);
  EXPECT_EQ(log.last_words(), "two");
}

TEST(RotatingLog, WritesAgainOnceItCan) {
  const Folder folder;
  RotatingLog log(folder / "later" / "a.log");
  log.write("lost\n");
  EXPECT_NE(log.fault(), "");
  std::filesystem::create_directory(folder / "later");
  log.write("kept\n");
  EXPECT_EQ(log.fault(), "");
  EXPECT_EQ(content(folder / "later" / "a.log"), "kept\n");
}

TEST(RotatingLog, LastWordsAreTheLastLineOfThisRunAlone) {
  const Folder folder;
  RotatingLog log(folder / "a.log");
  EXPECT_EQ(log.last_words(), "");
  log.write("\n\n");
  EXPECT_EQ(log.last_words(), "");
  log.write("a\nb\n\n");
  EXPECT_EQ(log.last_words(), "b");
  log.write(std::string(600, 'x'));
  EXPECT_EQ(log.last_words(), std::string(500, 'x'));
  log.forget_last_words();
  EXPECT_EQ(log.last_words(), "");
}

}  // namespace
}  // namespace bw::test
