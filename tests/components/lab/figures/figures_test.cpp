// The drawings that the theory pages show are those that the algorithms draw today: same elements, numbers
// within 0.3 px (what a pose may differ by from one mathematical library to another). After a change that
// means to: `bandwagon-lab figures`.
#include "components/lab/figures/figures.hpp"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace bw::figures {
namespace {

constexpr double kTolerance = 0.3;  // [px]

/// The number that `text` has from `at` on, and where it ends; false, and both as they were, where there is
/// none.
bool number_at(const std::string& text, std::size_t at, double& value, std::size_t& end) {
  if (std::isdigit(static_cast<unsigned char>(text[at])) == 0 && text[at] != '-') return false;
  char* after = nullptr;
  value = std::strtod(text.c_str() + at, &after);
  if (after == text.c_str() + at) return false;  // a hyphen
  end = static_cast<std::size_t>(after - text.c_str());
  return true;
}

/// Empty where both are alike; else the first position that is not.
std::string difference(const std::string& drawn, const std::string& kept) {
  std::size_t a = 0, b = 0;
  while (a < drawn.size() && b < kept.size()) {
    double x = 0.0, y = 0.0;
    std::size_t after_a = a + 1, after_b = b + 1;
    const bool is_number = number_at(drawn, a, x, after_a) && number_at(kept, b, y, after_b);
    if (is_number ? std::abs(x - y) > kTolerance : drawn[a] != kept[b])
      return "drawn: " + drawn.substr(a, 60) + "\nkept:  " + kept.substr(b, 60);
    a = after_a;
    b = after_b;
  }
  return a == drawn.size() && b == kept.size() ? "" : "one is longer";
}

TEST(Figures, AreThoseThatThePagesShow) {
  ASSERT_EQ(all().size(), 8U);
  for (const Figure& figure : all()) {
    const std::string file =
        std::string(BANDWAGON_SOURCE_DIR) + "/docs/figures/" + std::string(figure.name) + ".svg";
    std::ifstream in(file, std::ios::binary);
    ASSERT_TRUE(in) << file;
    const std::string kept((std::istreambuf_iterator<char>(in)), {});
    EXPECT_EQ(difference(figure.draw(), kept), "") << file;
  }
}

TEST(Figures, AreTheSameEachTime) {
  for (const Figure& figure : all()) EXPECT_EQ(figure.draw(), figure.draw()) << figure.name;
}

// A number that is off by more than the tolerance, another word and a missing end are seen.
TEST(Figures, ADifferenceIsSeen) {
  EXPECT_EQ(difference("<a x=\"1.0\"/>", "<a x=\"1.2\"/>"), "");
  EXPECT_NE(difference("<a x=\"1.0\"/>", "<a x=\"1.4\"/>"), "");
  EXPECT_NE(difference("<a/>", "<b/>"), "");
  EXPECT_NE(difference("<a/>", "<a/><b/>"), "");
}

}  // namespace
}  // namespace bw::figures
