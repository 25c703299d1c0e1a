#include "components/lab/experiments/page_parts.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace bw::page {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Sensible, HasThreeSignificantDigits) {
  EXPECT_EQ(sensible(37.4074), "37.4");
  EXPECT_EQ(sensible(0.02180), "0.0218");
  EXPECT_EQ(sensible(0.1455), "0.145");  // the double lies below
  EXPECT_EQ(sensible(1234.5), "1234");
  EXPECT_EQ(sensible(-2.0), "-2.00");
  EXPECT_EQ(sensible(0.0), "0");
  EXPECT_EQ(sensible(NAN), "–");
}

TEST(Sensible, ACountHasNoDecimals) {
  EXPECT_EQ(sensible(1.0, "20 of 20"), "1");
  EXPECT_EQ(sensible(17.0, "<= 20"), "17");
  EXPECT_EQ(sensible(1.0, "<= 0.04"), "1.00");
  EXPECT_EQ(sensible(17.25, "20 of 20"), "17.2");
  EXPECT_EQ(sensible(NAN, "20 of 20"), "–");
}

TEST(Table, NamesTheColumnInEveryCellForNarrowScreens) {
  Table table({"way", "error < 1 [m]"});
  EXPECT_EQ(table.html(), "");
  table.row({"sinus", "0.2"});  // words are set to the left, and their headings; figures to the right
  EXPECT_EQ(table.html(),
            "<table><thead><tr><th class=\"text\">way</th><th>error &lt; 1 [m]</th></tr></thead><tbody>\n"
            "<tr><td data-is=\"way\">sinus</td><td data-is=\"error &lt; 1 [m]\">0.2</td></tr>\n"
            "</tbody></table>\n");
}

TEST(FirstScreen, SaysWhatIsMetAndWhatIsNot) {
  FirstScreen screen{.title = "T",
                     .about = "about",
                     .judged = "the planners",
                     .criteria = {{"first", "> 1", 2.0, true}, {"second", "< 1", 3.14159, false}},
                     .not_judged = {"pictures without figures"},
                     .tuned = {"places <here>"}};
  const std::string html = first_screen(screen);
  EXPECT_THAT(html, HasSubstr("1 of 2 criteria are met"));
  EXPECT_THAT(html, HasSubstr("<li>second: 3.14, asked &lt; 1</li>"));
  EXPECT_THAT(html, Not(HasSubstr("<li>first")));
  EXPECT_THAT(html, HasSubstr("<li>pictures without figures</li>"));
  EXPECT_THAT(html, HasSubstr("places &lt;here&gt;"));
  screen.criteria.pop_back();
  EXPECT_THAT(first_screen(screen), HasSubstr("The one criterion is <span class=\"met\">met</span>."));
}

TEST(FirstScreen, TellsWhatFewSeedsCannotShow) {
  FirstScreen screen{
      .judged = "the planners",
      .criteria = {{"first", "> 1", 2.0, true, ""}, {"second", "< 1", 3.0, false, "5 of 40 seeds"}}};
  const std::string html = first_screen(screen);
  EXPECT_THAT(html, HasSubstr("1 asks for more seeds than were run, and is not judged."));
  EXPECT_THAT(html, HasSubstr("not judged: 5 of 40 seeds"));
  EXPECT_THAT(html, Not(HasSubstr("<li>second")));
  screen.criteria.erase(screen.criteria.begin());
  EXPECT_THAT(first_screen(screen), HasSubstr("None of the criteria is judged; 1 asks"));
}

TEST(Opening, IsMadeForPhonesAndPaper) {
  const std::string html = opening("a & b", 60);
  EXPECT_THAT(html, HasSubstr("width=device-width"));
  EXPECT_THAT(html, HasSubstr("@media print"));
  EXPECT_THAT(html, HasSubstr("<title>a &amp; b</title>"));
  EXPECT_THAT(html, Not(HasSubstr("http")));
}

}  // namespace
}  // namespace bw::page
