// Files of parameters as ROS 2's tools have them.
#include "runtime/parameters/parameter_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

const std::vector<NamedValue> kParameters = {{"rate", 1.0},
                                             {"teb.weights.obstacle", 50.0},
                                             {"teb.weights.time", 2.5},
                                             {"teb.label", "1"},
                                             {"walls.0.ids", std::vector<std::int64_t>{1, 2}},
                                             {"use_sim_time", true}};

std::vector<NamedValue> read(const std::string& yaml, std::string_view node = "/robot1/planner") {
  return parameters_of_node(parse_yaml(yaml, "p.yaml"), node);
}

std::string refusal(const std::string& yaml) {
  try {
    read(yaml);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ParameterFile, IsWrittenInSectionsAndReadsBack) {
  const std::string text = to_parameter_file("/robot1/planner", kParameters);
  EXPECT_EQ(
      text,
      "/robot1/planner:\n  ros__parameters:\n    rate: 1.0\n    teb:\n      weights:\n        obstacle: 50.0\n"
      "        time: 2.5\n      label: \"1\"\n    walls:\n      \"0\":\n        ids: [1, 2]\n    use_sim_time: true\n");
  EXPECT_EQ(read(text), kParameters);
}

TEST(ParameterFile, FindsItsNodeAsRosToolsDo) {
  const std::string parameters = "{ros__parameters: {a.b: 1}}";
  const NamedValue expected{"a.b", std::int64_t{1}};
  EXPECT_THAT(read("/robot1/planner: " + parameters), ElementsAre(expected));
  EXPECT_THAT(read("robot1: {planner: " + parameters + "}"), ElementsAre(expected));
  EXPECT_THAT(read("/robot1: {planner: " + parameters + "}"), ElementsAre(expected));
  EXPECT_THAT(read("/**: " + parameters), ElementsAre(expected));
  EXPECT_THAT(read("planner: " + parameters, "/planner"), ElementsAre(expected));
  EXPECT_EQ(
      refusal("/robot2/planner: " + parameters),
      "p.yaml:1: says nothing of /robot1/planner; it should have '/robot1/planner: {ros__parameters: ...}'");
  EXPECT_EQ(
      refusal("rate: 1"),
      "p.yaml:1: says nothing of /robot1/planner; it should have '/robot1/planner: {ros__parameters: ...}'");
}

TEST(ParameterFile, RefusesWhatIsNoValue) {
  EXPECT_EQ(refusal("/**:\n  ros__parameters:\n    a: [1, x]\n    b:\n"),
            "p.yaml:3: a = a list: must be a bool, a number, text, or a list of one of these\n"
            "p.yaml:4: b = nothing: must be a bool, a number, text, or a list of one of these");
}

}  // namespace
}  // namespace bw
