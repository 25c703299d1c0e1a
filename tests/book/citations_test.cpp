// Every citation in comments, doc texts and READMEs points to something in this tree (book 1.2), and what
// finds them out is shown to find every kind of broken one.
#include "tests/book/citations.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/book/check_tree.hpp"
#include "tests/book/human_text.hpp"

namespace bw::book {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::filesystem::path kRoot = BANDWAGON_SOURCE_DIR;
const std::filesystem::path kFixture = "tests/book/fixture";

std::vector<std::string> keys_of(const std::vector<Citation>& citations) {
  std::vector<std::string> keys;
  for (const Citation& citation : citations) keys.push_back(citation.key);
  return keys;
}

std::vector<std::string> texts_of(const std::vector<Passage>& passages) {
  std::vector<std::string> texts;
  for (const Passage& passage : passages) texts.push_back(passage.text);
  return texts;
}

std::vector<std::string> comments_of(std::string_view code) {
  return texts_of(human_text(code, Language::cpp).prose);
}

TEST(HumanText, JoinsTheLinesOfOneComment) {
  EXPECT_THAT(comments_of("// one book\n// 6.2\n\nint a;  ///< two\n        ///< lines\n"),
              ElementsAre("one book 6.2", "two lines"));
}

TEST(HumanText, AnEmptyLineOfACommentPartsIt) {
  EXPECT_THAT(comments_of("// one\n//\n// two\n"), ElementsAre("one", "two"));
}

TEST(HumanText, ReadsDocTextsAndNoOtherStrings) {
  EXPECT_THAT(comments_of("f(\"no\"); v(\"a\", a, {.doc = \"yes, \"\n  \"both\"}); g(\"// no\");"),
              ElementsAre("yes, both"));
}

TEST(HumanText, IsNotFooledByLiterals) {
  EXPECT_THAT(comments_of("char c = '\"'; int n = 1'000; auto r = R\"x(// no)x\"; /* yes */ // too"),
              ElementsAre("yes too"));
}

TEST(HumanText, KnowsTheLineOfEveryCharacter) {
  const HumanText text = human_text("int a;\n/* b\n * c */\n", Language::cpp);
  ASSERT_EQ(text.prose.size(), 1U);
  EXPECT_EQ(text.prose[0].line_at(0), 2);
  EXPECT_EQ(text.prose[0].line_at(2), 3);
}

TEST(HumanText, OfYamlIsWhatStandsBehindAHash) {
  EXPECT_THAT(texts_of(human_text("# a\nkey: \"# no\"  # b\nurl: a#c\n", Language::hash).prose),
              ElementsAre("a", "b"));
}

TEST(HumanText, OfMarkdownHasRowsAndBlocksApart) {
  const HumanText text = human_text("a\nb\n| c |\n| d |\n```\ne\n```\nf\n", Language::markdown);
  EXPECT_THAT(texts_of(text.prose), ElementsAre("a b", "| c |", "| d |", "f"));
  EXPECT_THAT(texts_of(text.fenced), ElementsAre("e"));
}

TEST(Citations, ListsGoOnWhereNumbersDo) {
  EXPECT_THAT(keys_of(citations_in("book 6.1, 6.6 and 7.2, with 0.5 m")), ElementsAre("6.1", "6.6", "7.2"));
  EXPECT_THAT(keys_of(citations_in("rows 6 to 8, and row 33, 5 cm")), ElementsAre("6", "8", "33"));
  EXPECT_THAT(keys_of(citations_in("Figures 3.8b, 3.9; Table 3.2, 3.3 m")), ElementsAre("3.8", "3.9", "3.2"));
}

TEST(Citations, NumbersInParenthesesAreEquationsOfThreeChapters) {
  EXPECT_THAT(keys_of(citations_in("by (1.1), (2.35)(2.36) and (3.1)")),
              ElementsAre("1.1", "2.35", "2.36", "3.1"));
  EXPECT_THAT(citations_in("f(1.5) (0.5) (4.2) (1.2 m) (12.1) (1.234) [1](2.5)"), IsEmpty());
}

// One broken citation of each kind, and things that only look like citations: fixture/expected.txt has what
// must be complained about, line by line.
TEST(Fixture, EveryKindOfBrokenCitationIsFoundAndNothingElse) {
  std::vector<std::string> expected;
  std::ifstream in(kRoot / kFixture / "expected.txt");
  for (std::string line; std::getline(in, line);) expected.push_back(line);
  ASSERT_FALSE(expected.empty());
  std::vector<std::string> found;
  for (const Complaint& complaint : check_tree(kRoot / kFixture, {}).complaints) {
    EXPECT_FALSE(complaint.why.empty());
    found.push_back(complaint.file + ":" + std::to_string(complaint.line) + ": " + complaint.citation);
  }
  EXPECT_EQ(found, expected);
}

// Nothing is asked of version control: a copy of the fixture elsewhere gives the same.
TEST(Fixture, GivesTheSameWithoutVersionControlAndLeavesBuildsOut) {
  const std::filesystem::path copy = std::filesystem::path(testing::TempDir()) / "bandwagon_book";
  std::filesystem::remove_all(copy);
  std::filesystem::copy(kRoot / kFixture, copy, std::filesystem::copy_options::recursive);
  for (const char* folder : {"build", "out", ".hidden"}) {
    std::filesystem::create_directories(copy / folder);
    std::ofstream(copy / folder / "wrong.hpp") << "// book 9.9\n";
  }
  std::ofstream(copy / "out" / "CMakeCache.txt") << "\n";
  const TreeReport here = check_tree(kRoot / kFixture, {});
  const TreeReport there = check_tree(copy, {});
  EXPECT_EQ(here.files, there.files);
  ASSERT_EQ(here.complaints.size(), there.complaints.size());
  for (std::size_t i = 0; i < here.complaints.size(); ++i)
    EXPECT_EQ(here.complaints[i].text(), there.complaints[i].text());
  std::filesystem::remove_all(copy);
}

TEST(Tree, EveryCitationResolves) {
  const TreeReport report = check_tree(kRoot, {kFixture});
  for (const Complaint& complaint : report.complaints) ADD_FAILURE() << complaint.text();
  EXPECT_GT(report.files, 900);
  EXPECT_GT(report.resolved_count(), 500);  // a reader that finds nothing resolves nothing
  std::printf("%d citations in %d files, %zu broken\n", report.resolved_count(), report.files,
              report.complaints.size());
}

}  // namespace
}  // namespace bw::book
