#include "components/local_planner/planner_registry.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw {
namespace {

TEST(PlannerNames, MakesEveryPlannerItNames) {
  for (const std::string_view name : planner_names()) EXPECT_NE(make_planner(name, {}), nullptr) << name;
}

TEST(PlannerNames, RefusesUnknownNamesAndNamesTheKnown) {
  try {
    make_planner("tbe", {});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), ::testing::AllOf(::testing::HasSubstr("tbe"), ::testing::HasSubstr("teb")));
  }
}

// Made anew in the middle of a drive, a planner goes on as if nothing had been.
TEST(PlannerNames, MakesPlannersThatContinueFromOthersOfTheirKind) {
  bool matters = false;
  for (const std::string_view name : planner_names()) {
    Random random(5);
    PlanningProblem problem = random_scene(random);
    const auto planner = make_planner(name, {});
    const auto next_cycle = [&problem] {
      problem.now = problem.now + Duration::milliseconds(100);
      problem.pose = advance_exact(problem.pose, problem.twist, 0.1);
    };
    for (int cycle = 0; cycle < 3; ++cycle) {
      problem.twist = planner->plan(problem).command;
      next_cycle();
    }
    const auto other = make_planner(name, {});
    other->continue_from(*planner);
    other->continue_from(*make_planner(name == "hrvo" ? "teb" : "hrvo", {}));  // of another kind: nothing
    const auto fresh = make_planner(name, {});
    for (int cycle = 0; cycle < 3; ++cycle) {
      const PlanningResult expected = planner->plan(problem);
      const PlanningResult result = other->plan(problem);
      matters |= fresh->plan(problem).command != expected.command;
      EXPECT_EQ(result.command, expected.command) << name << " " << cycle;
      EXPECT_EQ(result.candidates.size(), expected.candidates.size()) << name << " " << cycle;
      problem.twist = expected.command;
      next_cycle();
    }
  }
  EXPECT_TRUE(matters);  // one that starts afresh drives otherwise
}

}  // namespace
}  // namespace bw
