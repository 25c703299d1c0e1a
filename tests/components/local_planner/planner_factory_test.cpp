#include "components/local_planner/planner_factory.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

TEST(PlannerFactory, MakesEveryPlannerItNames) {
  for (const std::string_view name : planner_names()) EXPECT_NE(make_planner(name, {}), nullptr) << name;
}

TEST(PlannerFactory, RefusesUnknownNamesAndNamesTheKnown) {
  try {
    make_planner("tbe", {});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), ::testing::AllOf(::testing::HasSubstr("tbe"), ::testing::HasSubstr("teb")));
  }
}

}  // namespace
}  // namespace bw
