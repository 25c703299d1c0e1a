// Parameters that are one of some choices. Expected texts are the message form of config_error.hpp filled in
// by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/parameters/parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

enum class Gait { walk, run, stand };
constexpr auto choice_table(Gait) {
  return choices<Gait>({{Gait::walk, "walk"}, {Gait::run, "run"}, {Gait::stand, "no"}});
}

struct Walker {
  Gait gait = Gait::run;
  std::vector<Gait> gaits = {Gait::walk};

  template <class Visitor>
  void fields(Visitor& v) {
    v("gait", gait, {.doc = "how it moves"});
    v("gaits", gaits);
  }
  bool operator==(const Walker&) const = default;
};

std::string walker_refusal(const std::string& yaml) {
  try {
    read_parameters<Walker>(parse_yaml(yaml, "w.yaml"), "walker");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Choices, AreReadByTheTextsOfTheirTable) {
  const Walker walker =
      read_parameters<Walker>(parse_yaml("gait: no\ngaits: [run, 'walk', run]", "w.yaml"), "walker");
  EXPECT_EQ(walker, (Walker{Gait::stand, {Gait::run, Gait::walk, Gait::run}}));
  EXPECT_EQ(read_parameters<Walker>(parse_yaml("", "w.yaml"), "walker"), Walker{});
}

TEST(Choices, RefuseOtherTextsAndNameTheNearest) {
  EXPECT_EQ(walker_refusal("gait: wakl"),
            "w.yaml:1: walker.gait = wakl: must be one of walk, run, no; did you mean 'walk'?");
  EXPECT_EQ(walker_refusal("gaits: [run, hover]"),
            "w.yaml:1: walker.gaits.1 = hover: must be one of walk, run, no");
  EXPECT_EQ(walker_refusal("gait: Run"),
            "w.yaml:1: walker.gait = Run: must be one of walk, run, no; did you mean 'run'?");
  EXPECT_EQ(walker_refusal("gait: [run]"), "w.yaml:1: walker.gait = a list: must be text");
  EXPECT_EQ(walker_refusal("gait:"), "w.yaml:1: walker.gait = nothing: must be text");
  EXPECT_EQ(walker_refusal("gait: ''"), "w.yaml:1: walker.gait = \"\": must be one of walk, run, no");
}

TEST(Choices, AreWrittenAndListedByThatTable) {
  Walker walker{Gait::stand, {Gait::run, Gait::stand}};
  // "no" is quoted: other YAML readers take it for a truth value.
  EXPECT_EQ(to_yaml(walker), "gait: \"no\"\ngaits: [run, \"no\"]\n");
  EXPECT_EQ(read_parameters<Walker>(parse_yaml(to_yaml(walker), "w.yaml"), "walker"), walker);
  const std::vector<ParameterRow> rows = list_parameters(walker, "walker");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].type + " " + rows[0].value + " " + rows[0].default_value, "string \"no\" run");
  EXPECT_EQ(rows[1].type + " " + rows[1].value + " " + rows[1].default_value,
            "string list [run, \"no\"] [walk]");
  EXPECT_THAT(rows[0].choices, ElementsAre("walk", "run", "no"));
  EXPECT_THAT(rows[1].choices, ElementsAre("walk", "run", "no"));
}

TEST(Choices, AreKnownAtCompileTime) {
  static_assert(text_of(Gait::stand) == "no" && choice_of<Gait>("walk") == Gait::walk);
  static_assert(!choice_of<Gait>("hover") && text_of(static_cast<Gait>(7)).empty());
  static_assert(ChoiceField<Gait> && !ChoiceField<ConfigNode::Kind> && !ChoiceField<int>);
}

}  // namespace
}  // namespace bw
