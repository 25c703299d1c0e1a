#include "components/lab/comparison/comparison_report.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using ::testing::HasSubstr;

/// Ten episodes; the first succeeds in 0 to 3, the second in 0 to 8: alone in five. 9 could not succeed.
std::vector<ComparedRow> rows() {
  std::vector<ComparedRow> two = {{"teb", {}}, {"eteb own", {}}};
  for (int i = 0; i < 10; ++i) {
    const std::string key = std::to_string(i);
    two[0].episodes.push_back({key, i < 4, i < 9, 0.6, 1.0, 2.0, 10.0});
    two[1].episodes.push_back({key, i < 9, i < 9, i < 6 ? 0.5 : 0.6, 1.5, 1.0, i < 4 ? 11.0 : 30.0});
  }
  return two;
}

TEST(ComparisonReport, TellsPairsAndMeans) {
  const ComparisonSummary summary = summarize(rows(), "");
  const nlohmann::ordered_json json = to_json(summary);
  EXPECT_EQ(json["against"], "teb");
  const nlohmann::ordered_json& pair = json["pairs"]["eteb own"];
  EXPECT_EQ(pair["pairs"], 10);
  EXPECT_EQ(pair["only_this"], 5);
  EXPECT_EQ(pair["only_other"], 0);
  EXPECT_NEAR(pair["mcnemar_p"].get<double>(), 0.0625, 1e-12);
  EXPECT_DOUBLE_EQ(pair["success"]["mean"].get<double>(), 0.5);
  EXPECT_EQ(pair["both"], 4);
  EXPECT_NEAR(pair["collision_index"]["mean"].get<double>(), -0.1, 1e-12);
  EXPECT_NEAR(pair["time_s"]["mean"].get<double>(), 1.0, 1e-12);
  // Six of the nine that could succeed stay calm; the time is of those that did: (4 11 + 5 30) / 9.
  const nlohmann::ordered_json& row = json["rows"]["eteb own"];
  EXPECT_EQ(row["calm"]["count"], 6);
  EXPECT_EQ(row["calm"]["of"], 9);
  EXPECT_NEAR(row["time_s"]["mean"].get<double>(), 194.0 / 9.0, 1e-12);
  EXPECT_EQ(json["rows"]["teb"]["calm"]["count"], 0);
  const std::string words = in_words(summary);
  EXPECT_THAT(words, HasSubstr("10: 5, 0; 0.062; 4"));
  EXPECT_THAT(words, HasSubstr("6 of 9"));
  EXPECT_THAT(words, HasSubstr("-0.100 (-0.100 to -0.100)"));
  EXPECT_THAT(words, HasSubstr("seed 1"));
}

TEST(ComparisonReport, AgainstAnotherOrNobody) {
  EXPECT_EQ(to_json(summarize(rows(), "eteb own"))["pairs"]["teb"]["only_other"], 5);
  EXPECT_FALSE(to_json(summarize({rows()[0]}, "")).contains("pairs"));
  EXPECT_EQ(in_words(summarize({}, "")), "");
  try {
    row_against(rows(), "dwa");
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "--against dwa: must be one of teb, eteb own");
  }
}

}  // namespace
}  // namespace bw
