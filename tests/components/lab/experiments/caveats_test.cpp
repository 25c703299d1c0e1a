#include "components/lab/experiments/caveats.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

const std::vector<Criterion> kMixed = {
    {"a", "<= 1", 0.5, true}, {"b", "<= 1", 2.0, false}, {"c", "0", 1.0, false}};

TEST(Honesty, EverySubjectSaysWhatWasTuned) {
  for (const char* subject : {"ekf", "pf", "edwa", "pteb", "eteb"})
    EXPECT_FALSE(tuned_to_published(subject).empty()) << subject;
  EXPECT_TRUE(tuned_to_published("navigation").empty());  // nothing is published
  EXPECT_THROW(tuned_to_published("all"), std::out_of_range);
}

TEST(Honesty, AVerdictCountsWhatIsMissed) {
  EXPECT_EQ(verdict("the defaults", {}), "the defaults: met");
  EXPECT_EQ(verdict("the defaults", {kMixed[0]}), "the defaults: met");
  EXPECT_EQ(verdict("the defaults", kMixed), "the defaults: NOT MET (2 of 3 criteria)");
}

TEST(Honesty, TheLastLineTellsWhatTheExitStatusJudges) {
  const std::string text = closing_lines("pf", "the Gaussian weights", kMixed);
  EXPECT_THAT(text, HasSubstr("tuned to the published values: length of the run"));
  EXPECT_THAT(text,
              EndsWith("\njudged by the exit status: the Gaussian weights: NOT MET (2 of 3 criteria)\n"));
}

}  // namespace
}  // namespace bw
