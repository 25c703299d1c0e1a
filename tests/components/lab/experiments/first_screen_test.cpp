#include "components/lab/experiments/first_screen.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace bw {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(MissedInWords, ACountHasNoDecimals) {
  const auto measured = [](double value, const std::string& asked) {
    return missed_in_words({"c", asked, value, false});
  };
  EXPECT_EQ(measured(1.0, "20 of 20"), "c: 1, asked 20 of 20");
  EXPECT_EQ(measured(17.0, "<= 20"), "c: 17, asked <= 20");
  EXPECT_EQ(measured(1.0, "<= 0.04"), "c: 1.00, asked <= 0.04");
  EXPECT_EQ(measured(17.25, "20 of 20"), "c: 17.2, asked 20 of 20");
  EXPECT_EQ(measured(NAN, "20 of 20"), "c: –, asked 20 of 20");
}

TEST(FirstScreen, SaysWhatIsMetAndWhatIsNot) {
  FirstScreen screen{.title = "T",
                     .about = "about",
                     .judged = "the planners",
                     .criteria = {{"first", "> 1", 2.0, true}, {"second", "< 1", 3.14159, false}},
                     .not_judged = {"pictures without figures"},
                     .tuned = {"places *here*"}};
  const nlohmann::ordered_json json = begin_report(screen).json();
  EXPECT_EQ(json["blocks"][0]["text"], "T");
  const auto& outcome = json["blocks"][2];
  EXPECT_EQ(outcome["tone"], "missed");
  EXPECT_THAT(outcome["lines"][0].get<std::string>(), HasSubstr("1 of 2 criteria are met. **Not met:**"));
  EXPECT_EQ(outcome["missed"].dump(), R"(["second: 3.14, asked < 1"])");
  EXPECT_EQ(json["blocks"][3]["items"][0], "pictures without figures");
  EXPECT_EQ(json["blocks"][4]["items"][0], "places \\*here\\*");
  EXPECT_EQ(json["blocks"][5]["rows"].size(), 2U);
  EXPECT_EQ(json["blocks"][5]["rows"][0][2], 2) << "a count";
  screen.criteria.pop_back();
  EXPECT_THAT(begin_report(screen).json().dump(), HasSubstr("The one criterion is met."));
}

TEST(FirstScreen, TellsWhatFewSeedsCannotShow) {
  FirstScreen screen{
      .judged = "the planners",
      .criteria = {{"first", "> 1", 2.0, true, ""}, {"second", "< 1", 3.0, false, "5 of 40 seeds"}}};
  const std::string text = begin_report(screen).json().dump();
  EXPECT_THAT(text, HasSubstr("1 asks for more seeds than were run, and is not judged."));
  EXPECT_THAT(text, HasSubstr("not judged: 5 of 40 seeds"));
  EXPECT_THAT(text, Not(HasSubstr("second: 3")));
  screen.criteria.erase(screen.criteria.begin());
  EXPECT_THAT(begin_report(screen).json().dump(), HasSubstr("None of the criteria is judged; 1 asks"));
}

}  // namespace
}  // namespace bw
