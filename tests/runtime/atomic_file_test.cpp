// Files that are written whole, in folders where others write too.
#include "runtime/atomic_file.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/bounded_line.hpp"
#include "tests/folder.hpp"

namespace bw {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The draft was PATH.part and the process id: who knew it led the write to a file of his choice by a link.
TEST(AtomicFile, NoLinkOfAForeseenNameIsFollowed) {
  test::Folder folder;
  std::ofstream(folder / "victim") << "as it was";
  const std::string foreseen = (folder / "card.json").string() + ".part" + std::to_string(getpid());
  std::filesystem::create_symlink(folder / "victim", foreseen);
  write_file_atomically(folder / "card.json", "new");
  EXPECT_EQ(content(folder / "victim"), "as it was");
  EXPECT_EQ(content(folder / "card.json"), "new");
}

TEST(AtomicFile, ALinkIsReplacedAndNotFollowed) {
  test::Folder folder;
  std::ofstream(folder / "victim") << "as it was";
  std::filesystem::create_symlink(folder / "victim", folder / "card.json");
  write_file_atomically(folder / "card.json", "new");
  EXPECT_EQ(content(folder / "victim"), "as it was");
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(folder / "card.json")));
}

TEST(AtomicFile, LeavesNothingBehindAndKeepsTheMode) {
  test::Folder folder;
  std::ofstream(folder / "secret") << "old";
  chmod((folder / "secret").c_str(), 0600);
  write_file_atomically(folder / "secret", "new");
  EXPECT_EQ(std::filesystem::status(folder / "secret").permissions(), std::filesystem::perms(0600));
  std::filesystem::create_directory(folder / "taken");
  EXPECT_THROW(write_file_atomically(folder / "taken", "x"), std::runtime_error);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "")) ++files;
  EXPECT_EQ(files, 2U);
}

/// Characters without an end, counted.
class Endless : public std::streambuf {
 public:
  std::size_t given = 0;

 private:
  int_type underflow() override { return 'x'; }
  int_type uflow() override {
    ++given;
    return 'x';
  }
};

TEST(BoundedLine, ReadsNoFurtherThanItsBound) {
  Endless endless;
  std::istream input(&endless);
  std::string text;
  EXPECT_TRUE(read_line(input, text, 100));
  EXPECT_EQ(text.size(), 101U);
  EXPECT_EQ(endless.given, 101U);
}

TEST(BoundedLine, IsGetlineOtherwise) {
  for (const std::string file : {"", "\n", "a", "a\n", "a\nb", "\n\nab\r\n", "abc\nabc"}) {
    std::istringstream ours(file);
    std::istringstream theirs(file);
    std::string a;
    std::string b;
    while (true) {
      const bool is_there = read_line(ours, a, 3);
      ASSERT_EQ(is_there, static_cast<bool>(std::getline(theirs, b))) << file;
      EXPECT_EQ(ours.eof(), theirs.eof()) << file;
      if (!is_there) break;
      EXPECT_EQ(a, b);
    }
  }
}

}  // namespace
}  // namespace bw
