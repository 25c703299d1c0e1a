#include "runtime/parameters/config_error.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace bw {
namespace {

// A section that several components read, such as `robot`.
TEST(Violations, OfTheSameTextAreToldOnce) {
  std::vector<Violation> all;
  for (const int line : {3, 4, 3, 3}) {
    Violation& violation = all.emplace_back();
    violation.where = {"r.yaml", line};
    violation.key = line == 3 ? "robot.radius" : "robot.name";
    violation.value = line == 3 ? "-1" : "";
    violation.rule = line == 3 ? "must be positive" : "is missing";
  }
  EXPECT_STREQ(ConfigError(all).what(),
               "r.yaml:3: robot.radius = -1: must be positive\nr.yaml:4: robot.name: is missing");
}

}  // namespace
}  // namespace bw
