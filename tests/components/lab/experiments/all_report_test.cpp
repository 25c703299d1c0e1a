// One page of all experiments: every verdict is on it, and the exit status stands for them.
#include "components/lab/experiments/all_report.hpp"

#include <gmock/gmock.h>

#include "components/lab/experiments/published_value.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

nlohmann::json results_of(const std::vector<Criterion>& criteria) {
  const std::vector<PublishedValue> values = {{"Table 2.1",
                                               "error <of> the filter",
                                               "m",
                                               "0.1098",
                                               spread_of({0.08, 0.10}),
                                               {{"as printed", spread_of({0.14})}}}};
  return {{"judged", "what is judged"},
          {"criteria", criteria_json(criteria)},
          {"other_readings",
           {{{"name", "weights as printed"}, {"criteria", criteria_json({{"x", "> 0", -1.0, false}})}}}},
          {"published", published_json(values)},
          {"tuned_to_published", {"length of the run"}}};
}

const Criterion kMet{"order", "> 0", 0.5, true};
const Criterion kMissed{"gain of EDWA", ">= 0.01", 0.00412345, false};
const Criterion kUndecided = over_seeds({"median", "<= 0", 1.0, false}, 2, 20);

AllRun run_of(const std::vector<std::vector<Criterion>>& criteria) {
  AllRun run{.parts = all_parts(), .is_finished = true};
  for (std::size_t i = 0; i < run.parts.size(); ++i)
    run.parts[i].results = results_of(criteria[std::min(i, criteria.size() - 1)]);
  return run;
}

TEST(AllReport, AVerdictIsThatOfWhatIsJudged) {
  const auto verdict = [](const std::vector<Criterion>& criteria) {
    return verdict_of({.results = results_of(criteria)});
  };
  EXPECT_EQ(verdict({kMet, kMet}), Verdict::reproduced);
  EXPECT_EQ(verdict({kMet, kMissed, kUndecided}), Verdict::not_reproduced);
  EXPECT_EQ(verdict({kMet, kUndecided}), Verdict::in_part);
  EXPECT_EQ(verdict({kUndecided}), Verdict::not_judged);
  EXPECT_EQ(verdict({}), Verdict::not_judged);
  EXPECT_EQ(verdict_of({}), Verdict::missing);
}

TEST(AllReport, TheExitStatusAsksForEveryPart) {
  EXPECT_TRUE(nothing_missed(run_of({{kMet}}).parts));
  EXPECT_TRUE(nothing_missed(run_of({{kUndecided}, {kMet, kUndecided}}).parts));  // a quick run
  EXPECT_FALSE(nothing_missed(run_of({{kMet}, {kMissed}, {kMet}}).parts));
  AllRun run = run_of({{kMet}});
  run.parts[4].results = nullptr;
  EXPECT_FALSE(nothing_missed(run.parts));
}

// `reproduced` in results.json is what a script may rely on: every criterion of every part was judged and is
// met. A part that is met in part or not judged, and one without any criteria, is none of that, although
// nothing is missed.
TEST(AllReport, ReproducedSaysThatEverythingWasJudgedAndMet) {
  const auto json = [](const std::vector<std::vector<Criterion>>& criteria) {
    return all_json(run_of(criteria));
  };
  EXPECT_TRUE(json({{kMet}})["reproduced"]);
  for (const std::vector<Criterion>& second : {std::vector{kMet, kUndecided}, std::vector{kUndecided}, {}}) {
    const nlohmann::ordered_json quick = json({{kMet}, second, {kMet}});
    EXPECT_FALSE(quick["reproduced"]);
    EXPECT_TRUE(quick["nothing_missed"]);
    EXPECT_EQ(quick["verdicts"]["reproduced"], 4);
  }
  EXPECT_EQ(json({{kMet}, {kMet, kUndecided}, {kMet}})["verdicts"]["what few seeds show is met"], 1);
  EXPECT_FALSE(json({{kMissed}})["nothing_missed"]);
  AllRun interrupted = run_of({{kMet}});
  interrupted.is_finished = false;
  EXPECT_FALSE(all_json(interrupted)["reproduced"]);
  EXPECT_FALSE(all_json(interrupted)["nothing_missed"]);
}

TEST(AllPage, HoldsEveryVerdictAndLinksToEveryPart) {
  const AllRun run = run_of({{kMet}, {kMet, kMissed}, {kUndecided}, {kMet, kUndecided}, {kMet}});
  const std::string page = all_page(run).json().dump();
  for (const AllPart& part : run.parts) {
    EXPECT_THAT(page, HasSubstr("[" + part.experiments + "](" + part.subject + "/index.html)"));
    EXPECT_THAT(page, HasSubstr("{\"text\":\"" + std::string(to_string(verdict_of(part))) + "\",\"tone\""));
  }
  // What is missed stands above the first table.
  EXPECT_LT(page.find("gain of EDWA: 0.00412, asked >= 0.01"), page.find("\"table\""));
  EXPECT_THAT(page, HasSubstr("2 of 20 seeds"));
  EXPECT_THAT(page, HasSubstr("weights as printed: NOT MET (1 of 1 criteria)"));
  EXPECT_THAT(page, HasSubstr("error <of> the filter \\\\[m\\\\]"));
  EXPECT_THAT(page, HasSubstr("0.1098"));
  EXPECT_THAT(page, HasSubstr(R"({"value":0.09,"low":0.08,"high":0.1})"));
  EXPECT_THAT(page, HasSubstr("as printed: 0.140"));
  EXPECT_THAT(page, HasSubstr("length of the run"));
  EXPECT_THAT(page, Not(HasSubstr("has not ended")));
}

TEST(AllPage, NamesWhatIsReproducedAndWhatIsNotBeforeTheFirstTable) {
  AllRun run = run_of({{kMet}, {kMissed}, {kMet}, {kMet}, {kMet}});
  run.parts[4].results = nullptr;
  const std::string page = all_page(run).json().dump(), first = page.substr(0, page.find("\"table\""));
  EXPECT_THAT(first, HasSubstr("**Reproduced, 3 of 5:** [EKF: Figure 2.3"));
  EXPECT_THAT(first, HasSubstr("**Not reproduced:** [Particle filter: Table 2.1](pf/index.html)."));
  EXPECT_THAT(first, HasSubstr("**Without a result:** The whole system"));
  EXPECT_THAT(all_page(run_of({{kMissed}})).json().dump(), HasSubstr("Nothing is reproduced."));
}

TEST(AllPage, SaysThatARunHasNotEndedAndWhatIsInTrouble) {
  AllRun run = run_of({{kMet}});
  run.is_finished = false;
  run.parts[1].results = nullptr;
  run.parts[1].trouble = "pf ended with status 139: see pf/log.txt";
  const std::string page = all_page(run).json().dump();
  EXPECT_THAT(page, HasSubstr("has not ended"));
  EXPECT_THAT(page, HasSubstr("pf ended with status 139"));
  EXPECT_THAT(page, HasSubstr("no result"));
  EXPECT_FALSE(all_json(run)["reproduced"]);
  EXPECT_EQ(all_json(run)["parts"][1]["verdict"], "no result");
  EXPECT_EQ(all_json(run)["parts"][0]["page"], "ekf/index.html");
  EXPECT_THAT(all_table(run.parts), HasSubstr("pf ended with status 139"));
}

}  // namespace
}  // namespace bw
