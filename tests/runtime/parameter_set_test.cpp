// Parameters as ROS 2 sees them: typed leaves of a struct, and changes of them. Expected texts are the rules
// of read_parameters.hpp with the name of the parameter; type numbers are those of
// rcl_interfaces/msg/ParameterType.
#include "runtime/parameters/parameter_set.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/any_options.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMax = std::numeric_limits<double>::max();

enum class Pace { walk, run };
constexpr auto choice_table(Pace) { return choices<Pace>({{Pace::walk, "walk"}, {Pace::run, "run"}}); }

struct Wall {
  double x = 0.0;
  std::vector<std::int64_t> ids;

  void fields(auto& v) {
    v("x", x, {.unit = "m", .min = -10, .max = 10});
    v("ids", ids);
  }
  bool operator==(const Wall&) const = default;
};

struct Speeds {
  double slow = 1.0;
  double fast = 2.0;

  void fields(auto& v) {
    v("slow", slow, {.unit = "m/s", .min = 0, .max = 10, .doc = "when people are near"});
    v("fast", fast, {.unit = "m/s", .min = 0, .doc = "elsewhere"});
  }
  std::optional<std::string> violated_rule() const {
    if (fast < slow) return "fast must be at least slow";
    return std::nullopt;
  }
  bool operator==(const Speeds&) const = default;
};

struct Everything {
  bool react = true;
  int beams = 720;
  std::int64_t seed = 1;
  double range = kInfinity;
  Pace gait = Pace::walk;
  std::string model = "orca";
  std::string label;
  std::string map;
  Speeds speeds;
  std::vector<Wall> walls = {{.x = 1.0, .ids = {4}}, {.x = 2.0, .ids = {}}};
  std::vector<Wall> no_walls;
  std::vector<bool> flags;
  std::vector<int> counts = {1, 2};
  std::vector<double> gains = {0.5};
  std::vector<std::string> names = {"a"};
  std::vector<Pace> gaits = {Pace::run};
  std::vector<std::vector<double>> rows = {{1.0}, {}};

  void fields(auto& v) {
    v("react", react, {.doc = "to the robot"});
    v("beams", beams, {.min = 1});
    v("seed", seed, {.min = 0, .max = 9});
    v("range", range, {.unit = "m", .min = 0, .infinity = true});
    v("gait", gait, {.doc = "how it moves"});
    v("model", model, {.choices = {"orca", "social_force"}});
    v("label", label);
    v("map", map, {.path = true});
    v("speeds", speeds);
    v("walls", walls);
    v("no_walls", no_walls);
    v("flags", flags);
    v("counts", counts, {.min = 0, .max = 5});
    v("gains", gains, {.max = 3});
    v("names", names);
    v("gaits", gaits);
    v("rows", rows);
  }
  bool operator==(const Everything&) const = default;
};

std::optional<std::string> change(ParameterSet& set, const std::string& name, ParameterValue value) {
  const NamedValue one{name, std::move(value)};
  return set.change({&one, 1});
}

/// The reason of a refusal, or "accepted".
std::string said(const std::string& name, ParameterValue value) {
  ParameterSet set(Everything{});
  const std::optional<std::string> refusal = change(set, name, std::move(value));
  EXPECT_TRUE(!refusal || set.as<Everything>() == Everything{}) << name;
  return refusal.value_or("accepted");
}

TEST(ParameterSet, HasTypedLeavesInTheOrderOfTheFields) {
  const ParameterSet set(Everything{});
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < set.size(); ++i) {
    lines.push_back(set.name(i) + " " + std::to_string(set.value(i).index()) + " " +
                    to_yaml_text(set.value(i)));
    EXPECT_EQ(set.descriptor(i).type, type_of(set.value(i))) << set.name(i);
    EXPECT_EQ(set.find(set.name(i)), i);
  }
  EXPECT_THAT(
      lines,
      ElementsAre("react 1 true", "beams 2 720", "seed 2 1", "range 3 .inf", "gait 4 walk", "model 4 orca",
                  "label 4 \"\"", "map 4 \"\"", "speeds.slow 3 1.0", "speeds.fast 3 2.0", "walls.0.x 3 1.0",
                  "walls.0.ids 7 [4]", "walls.1.x 3 2.0", "walls.1.ids 7 []", "flags 6 []", "counts 7 [1, 2]",
                  "gains 8 [0.5]", "names 9 [a]", "gaits 9 [run]", "rows.0 8 [1.0]", "rows.1 8 []"));
  EXPECT_FALSE(set.find("speeds"));
  EXPECT_TRUE(set.has("speeds") && set.has("no_walls") && set.has("beams"));
  EXPECT_FALSE(set.has("beam") || set.has("walls.2"));
}

TEST(ParameterSet, DescribesRangesChoicesAndUnits) {
  const ParameterSet set(Everything{});
  const auto of = [&set](std::string_view name) { return set.descriptor(set.find(name).value()); };
  EXPECT_EQ(of("speeds.slow").description, "when people are near [m/s]");
  EXPECT_EQ(of("speeds.slow").double_range, (DoubleRange{0.0, 10.0}));
  EXPECT_EQ(of("speeds.slow").additional_constraints, "");
  EXPECT_EQ(of("speeds.fast").double_range, (DoubleRange{0.0, kMax}));
  EXPECT_EQ(of("speeds.fast").additional_constraints, "must be at least 0 m/s");
  EXPECT_EQ(of("range").double_range, (DoubleRange{0.0, kInfinity}));
  EXPECT_EQ(of("beams").integer_range, (IntegerRange{1, std::numeric_limits<int>::max()}));
  EXPECT_EQ(of("seed").integer_range, (IntegerRange{0, 9}));
  EXPECT_EQ(of("gait").additional_constraints, "must be one of walk, run");
  EXPECT_EQ(of("model").additional_constraints, "must be one of orca, social_force");
  EXPECT_EQ(of("counts").additional_constraints, "each element must be between 0 and 5");
  EXPECT_EQ(of("gains").additional_constraints, "each element must be at most 3");
  EXPECT_FALSE(of("counts").integer_range || of("gains").double_range || of("label").double_range);
}

TEST(ParameterSet, TakesEveryTypeAndKeepsTheRest) {
  ParameterSet set(Everything{});
  Everything expected;
  const auto take = [&set](const std::string& name, ParameterValue value) {
    EXPECT_EQ(change(set, name, value), std::nullopt) << name;
    EXPECT_EQ(set.value(set.find(name).value()), value) << name;
  };
  using Integers = std::vector<std::int64_t>;
  take("react", expected.react = false);
  take("beams", std::int64_t{expected.beams = 5});
  take("seed", expected.seed = 9);
  take("range", expected.range = 0.1 + 0.2);
  take("gait", "run"), expected.gait = Pace::run;
  take("model", expected.model = "social_force");
  take("label", expected.label = "1: \"[a]\" \xc3\xa9");
  take("map", expected.map = "maps/../a.yaml");
  take("speeds.slow", expected.speeds.slow = 2.0);
  take("walls.1.x", expected.walls[1].x = -10.0);
  take("walls.0.ids", expected.walls[0].ids = {7, 8});
  take("flags", expected.flags = {true, false});
  take("counts", Integers{0, 5}), expected.counts = {0, 5};
  take("gains", expected.gains = {-1e300, 3.0});
  take("names", expected.names = {"true", "1"});
  take("gaits", std::vector<std::string>{"walk"}), expected.gaits = {Pace::walk};
  take("rows.1", expected.rows[1] = {1.0, 2.0});
  EXPECT_EQ(set.as<Everything>(), expected);
  Everything copy = set.as<Everything>();
  const std::vector<ParameterEntry> entries = collect_parameters(copy);
  for (std::size_t i = 0; i < entries.size(); ++i) EXPECT_EQ(set.value(i), entries[i].value) << set.name(i);
}

TEST(ParameterSet, TakesAnEmptyListOfAnyType) {
  ParameterSet set(Everything{});
  EXPECT_EQ(change(set, "gains", std::vector<bool>{}),
            std::nullopt);  // as `ros2 param set NODE gains "[]"` sends it
  EXPECT_EQ(change(set, "names", std::vector<double>{}), std::nullopt);
  EXPECT_EQ(change(set, "counts", std::vector<std::string>{}), std::nullopt);
  EXPECT_TRUE(set.as<Everything>().gains.empty() && set.as<Everything>().names.empty());
  EXPECT_EQ(type_of(set.value(set.find("gains").value())), ParameterType::double_list);
}

TEST(ParameterSet, RefusesOtherTypes) {
  EXPECT_EQ(said("speeds.slow", std::int64_t{1}), "speeds.slow expects a double, got an integer: write 1.0");
  EXPECT_EQ(said("beams", 5.0), "beams expects an integer, got a double");
  EXPECT_EQ(said("react", "true"), "react expects a bool, got a string");
  EXPECT_EQ(said("label", true), "label expects a string, got a bool");
  EXPECT_EQ(said("gains", std::vector<std::int64_t>{1}),
            "gains expects a list of doubles, got a list of integers: write 1.0, not 1");
  EXPECT_EQ(said("gains", 1.0), "gains expects a list of doubles, got a double");
  EXPECT_EQ(said("counts", std::vector<std::uint8_t>{1}),
            "counts expects a list of integers, got a list of bytes");
  EXPECT_EQ(said("beams", {}), "beams expects an integer, got nothing: a parameter cannot be deleted");
}

TEST(ParameterSet, RefusesBadValuesWithTheRuleOfTheField) {
  EXPECT_EQ(said("speeds.slow", -1.0), "speeds.slow = -1.0: must be between 0 and 10 m/s");
  EXPECT_EQ(said("speeds.fast", -0.5), "speeds.fast = -0.5: must be at least 0 m/s");
  EXPECT_EQ(said("speeds.slow", std::numeric_limits<double>::quiet_NaN()),
            "speeds.slow = .nan: must be a finite number");
  EXPECT_EQ(said("speeds.fast", kInfinity), "speeds.fast = .inf: must be a finite number");
  EXPECT_EQ(said("range", -kInfinity), "range = -.inf: must be at least 0 m");
  EXPECT_EQ(said("beams", std::int64_t{1} << 31),
            "beams = 2147483648: must be between -2147483648 and 2147483647");
  EXPECT_EQ(said("seed", std::numeric_limits<std::int64_t>::max()),
            "seed = 9223372036854775807: must be between 0 and 9");
  EXPECT_EQ(said("gait", "rum"), "gait = \"rum\": must be one of walk, run; did you mean 'run'?");
  EXPECT_EQ(said("model", ""), "model = \"\": must be one of orca, social_force");
  EXPECT_EQ(said("counts", std::vector<std::int64_t>{1, 6, 2}), "counts.1 = 6: must be between 0 and 5");
  EXPECT_EQ(said("gains", std::vector<double>{1.0, std::numeric_limits<double>::quiet_NaN()}),
            "gains.1 = .nan: must be a finite number");
  EXPECT_EQ(said("gaits", std::vector<std::string>{"walk", "hover"}),
            "gaits.1 = \"hover\": must be one of walk, run");
  EXPECT_EQ(said("walls.0.x", 11.0), "walls.0.x = 11.0: must be between -10 and 10 m");
  EXPECT_EQ(said("gains", std::vector<double>(kMaxListElements + 1)),
            "gains = 20001 elements: must have at most 20000 elements");
  EXPECT_EQ(said("label", std::string("a\0b", 3)),
            "label must be UTF-8 text without control characters, of at most 1 MiB");
  EXPECT_EQ(said("names", std::vector<std::string>{"\xff"}),
            "names must be UTF-8 text without control characters, of at most 1 MiB");
  EXPECT_EQ(said("label", std::string(kMaxYamlBytes + 1, 'a')),
            "label must be UTF-8 text without control characters, of at most 1 MiB");
}

TEST(ParameterSet, RefusesUnknownNamesAndNamesTheNearest) {
  EXPECT_EQ(said("speeds.slwo", 1.0), "unknown parameter 'speeds.slwo'; did you mean 'speeds.slow'?");
  EXPECT_EQ(said("speeds", 1.0), "unknown parameter 'speeds'; did you mean 'seed'?");
  EXPECT_EQ(said("walls.2.x", 1.0), "unknown parameter 'walls.2.x'; did you mean 'walls.0.x'?");
  EXPECT_EQ(said("no_walls.0.x", 1.0), "unknown parameter 'no_walls.0.x'; did you mean 'walls.0.x'?");
  EXPECT_EQ(said("", 1.0), "unknown parameter ''");
  EXPECT_EQ(said("temperature", 1.0), "unknown parameter 'temperature'");
  EXPECT_EQ(said(std::string(256, 'a'), 1.0), "a parameter of this name does not exist");
  EXPECT_EQ(said("\xff", 1.0), "a parameter of this name does not exist");
  ParameterSet none;
  EXPECT_EQ(change(none, "a", 1.0), "unknown parameter 'a'");
}

TEST(ParameterSet, JudgesRulesOverFieldsByTheWhole) {
  EXPECT_EQ(said("speeds.slow", 3.0), "speeds: fast must be at least slow");
  ParameterSet set(Everything{});
  const std::vector<NamedValue> both = {{"speeds.slow", 3.0}, {"speeds.fast", 4.0}};
  EXPECT_EQ(set.change(both), std::nullopt);
  EXPECT_EQ(set.as<Everything>().speeds, (Speeds{3.0, 4.0}));
  const std::vector<NamedValue> one_is_bad = {
      {"speeds.fast", 5.0}, {"beams", std::int64_t{0}}, {"speeds.slow", 11.0}};
  EXPECT_EQ(set.change(one_is_bad),
            "beams = 0: must be at least 1; speeds.slow = 11.0: must be between 0 and 10 m/s");
  EXPECT_EQ(set.as<Everything>().speeds, (Speeds{3.0, 4.0}));
  const std::vector<NamedValue> twice = {{"beams", std::int64_t{2}}, {"beams", std::int64_t{3}}};
  EXPECT_EQ(set.change(twice), std::nullopt);
  EXPECT_EQ(set.as<Everything>().beams, 3);
}

TEST(ParameterSet, LeavesCopiesAlone) {
  ParameterSet set(Everything{});
  const ParameterSet before = set;
  ASSERT_EQ(change(set, "beams", std::int64_t{2}), std::nullopt);
  EXPECT_EQ(before.as<Everything>(), Everything{});
  EXPECT_EQ(before.value(1), ParameterValue(std::int64_t{720}));
}

TEST(ParameterSet, SeesThroughOptionsOfUnknownType) {
  ParameterSet set(AnyOptions{Speeds{}});
  EXPECT_EQ(set.name(1), "fast");
  EXPECT_EQ(change(set, "fast", 0.5), "fast must be at least slow");
  EXPECT_EQ(change(set, "fast", 7.0), std::nullopt);
  EXPECT_EQ(set.as<AnyOptions>().as<Speeds>().fast, 7.0);
}

TEST(ParameterSet, WritesItsChangesForTheNextReading) {
  const std::string yaml = "seed: 3\nwalls: [{x: 4}, {}]\nspeeds: {fast: 5}\nmap: maps/a.yaml\n";
  ConfigNode section = parse_yaml(yaml, "config/g.yaml");
  ParameterSet set(read_parameters<Everything>(section, ""));
  ASSERT_EQ(change(set, "walls.1.x", 6.0), std::nullopt);
  ASSERT_EQ(change(set, "rows.0", std::vector<double>{2.0}), std::nullopt);
  ASSERT_EQ(change(set, "speeds.slow", 3.0), std::nullopt);
  ASSERT_EQ(change(set, "gait", "run"), std::nullopt);
  set.write_changes(section);
  EXPECT_EQ(read_parameters<Everything>(section, ""), set.as<Everything>());
  EXPECT_EQ(set.as<Everything>().map, "config/maps/a.yaml");
  EXPECT_EQ(find_dotted(section, "map")->scalar,
            "maps/a.yaml");  // untouched, and so still relative to its file
  EXPECT_EQ(find_dotted(section, "beams"), nullptr);
}

TEST(ParameterValue, IsReadFromYamlAsRosToolsRead) {
  const auto value = [](const std::string& yaml) { return parameter_value_of(parse_yaml(yaml, "v")); };
  EXPECT_EQ(value("1"), ParameterValue(std::int64_t{1}));
  EXPECT_EQ(value("1.0"), ParameterValue(1.0));
  EXPECT_EQ(value("'1'"), ParameterValue("1"));
  EXPECT_EQ(value("true"), ParameterValue(true));
  EXPECT_EQ(value("eteb"), ParameterValue("eteb"));
  EXPECT_EQ(value("[1, 2]"), ParameterValue(std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(value("[1, 2.5]"), ParameterValue(std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(value("[a, '1']"), ParameterValue(std::vector<std::string>{"a", "1"}));
  EXPECT_EQ(value("[]"), ParameterValue(std::vector<bool>{}));
  for (const char* bad : {"", "{a: 1}", "[1, a]", "[[1]]", "[true, 1]", "[~]"})
    EXPECT_EQ(value(bad), std::nullopt) << bad;
}

}  // namespace
}  // namespace bw
