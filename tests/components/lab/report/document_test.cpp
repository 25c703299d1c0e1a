#include "components/lab/report/document.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace bw::report {
namespace {

using Json = nlohmann::ordered_json;

TEST(Document, HoldsItsBlocksInTheirOrder) {
  Document document("Figure 2.3");
  Figure figure{.title = "ways", .id = "d1"};
  figure.add(floor_plan("a"));
  document.heading("Figure 2.3", 1)
      .text("**bold**")
      .list("lead", {"one", "two"})
      .list("nothing", {})
      .outcome(Tone::missed, {"1 of 2"}, {"gain"})
      .table(Table({"a"}))
      .figure({.title = "without pictures"})
      .figure(figure);
  const Json json = document.json();
  EXPECT_EQ(json["report"], 1);
  EXPECT_EQ(json["title"], "Figure 2.3");
  std::vector<std::string> kinds;
  for (const Json& block : json["blocks"]) kinds.push_back(block["kind"]);
  EXPECT_EQ(kinds, (std::vector<std::string>{"heading", "text", "list", "outcome", "figure"}))
      << "what is empty is left out";
  EXPECT_EQ(json["blocks"][3]["tone"], "missed");
  EXPECT_EQ(json["blocks"][4]["pictures"][0]["title"], "a");
  EXPECT_EQ(json["blocks"][4]["id"], "d1");
}

TEST(Table, KeepsFiguresAsNumbers) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Table table({"way", {"error [m]", 4}, "runs", "interval", "verdict", "nothing"});
  table.row({"sinus", 37.40736999, 100, Interval{0.2, 0.1, none}, Verdict{"met", Tone::met},
             std::optional<double>{}});
  const Json json = table.json();
  EXPECT_EQ(json["columns"][0], Json::parse(R"({"name": "way"})"));
  EXPECT_EQ(json["columns"][1], Json::parse(R"({"name": "error [m]", "decimals": 4})"));
  EXPECT_EQ(json["rows"][0],
            Json::parse(R"(["sinus", {"value": 37.4074}, 100, {"value": 0.2, "low": 0.1, "high": null},
                                            {"text": "met", "tone": "met"}, {"value": null}])"));
}

TEST(Plain, HasNoMarkup) { EXPECT_EQ(plain("[x, y] *a* <b>"), "\\[x, y\\] \\*a\\* <b>"); }

TEST(InDigits, HasThreeSignificantOnes) {
  EXPECT_EQ(in_digits(37.4074), "37.4");
  EXPECT_EQ(in_digits(0.02180), "0.0218");
  EXPECT_EQ(in_digits(0.1455), "0.145");  // the double lies below
  EXPECT_EQ(in_digits(1234.5), "1234");
  EXPECT_EQ(in_digits(-2.0), "-2.00");
  EXPECT_EQ(in_digits(0.0), "0");
  EXPECT_EQ(in_digits(NAN), "–");
}

}  // namespace
}  // namespace bw::report
