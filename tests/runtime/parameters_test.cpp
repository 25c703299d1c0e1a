// Parameter reading, listing and writing. Expected texts are the message form of config_error.hpp filled in
// by hand.
#include "runtime/parameters/parameters.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/model/robot.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

struct Scan {
  double rate = 10.0;
  int beams = 720;
  double max_range = std::numeric_limits<double>::infinity();

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 0.1, .max = 100, .doc = "scans per second"});
    v("beams", beams, {.min = 1, .max = 10'000, .doc = "beams per scan"});
    v("max_range", max_range, {.unit = "m", .min = 0, .infinity = true, .doc = "longest range"});
  }
  bool operator==(const Scan&) const = default;
};

struct Edge {
  double x = 0.0;
  double y = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m"});
    v("y", y, {.unit = "m"});
  }
  bool operator==(const Edge&) const = default;
};

struct World {
  bool react = true;
  std::int64_t seed = 1;
  std::string model = "orca";
  std::string label;
  Scan scan;
  std::vector<Edge> walls = {{1.0, 2.0}};
  std::vector<double> gains = {0.5};
  std::vector<bool> flags;
  std::vector<std::vector<std::int64_t>> cells;
  double slow = 1.0;
  double fast = 2.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("react", react);
    v("seed", seed, {.min = 0});
    v("model", model, {.choices = {"orca", "social_force"}});
    v("label", label);
    v("scan", scan);
    v("walls", walls);
    v("gains", gains, {.max = 3});
    v("flags", flags);
    v("cells", cells);
    v("slow", slow);
    v("fast", fast);
  }
  std::optional<std::string> violated_rule() const {
    if (fast < slow) return "fast must be at least slow";
    return std::nullopt;
  }
  bool operator==(const World&) const = default;
};

struct Map {
  std::string file;

  template <class Visitor>
  void fields(Visitor& v) {
    v("file", file, {.path = true});
  }
};

World read(const std::string& yaml) { return read_parameters<World>(parse_yaml(yaml, "w.yaml"), "world"); }

std::string refusal(const std::string& yaml) {
  try {
    read(yaml);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadParameters, KeepsDefaultsOfMissingKeys) {
  World expected;
  expected.scan.beams = 360;
  expected.seed = 9'007'199'254'740'993;  // 2^53 + 1 has no double
  EXPECT_EQ(read("scan: {beams: 360}\nseed: 9007199254740993\n"), expected);
  EXPECT_EQ(read(""), World{});
  EXPECT_EQ(read("scan:\n"), World{});
}

TEST(ReadParameters, ReadsEveryKindOfField) {
  const World world = read(
      "react: false\nmodel: social_force\nlabel: 'true'\nscan: {rate: 1, max_range: .inf}\n"
      "walls:\n  - {x: -1.5e1}\n  - {x: .5, y: +2}\ngains: [1, -2.5]\nflags: [true, false]\ncells: [[1, 2], "
      "[]]\n");
  EXPECT_FALSE(world.react);
  EXPECT_EQ(world.label, "true");
  EXPECT_EQ(world.scan.rate, 1.0);
  EXPECT_EQ(world.walls, (std::vector<Edge>{{-15.0, 0.0}, {0.5, 2.0}}));
  EXPECT_THAT(world.gains, ElementsAre(1.0, -2.5));
  EXPECT_THAT(world.flags, ElementsAre(true, false));
  EXPECT_THAT(world.cells, ElementsAre(ElementsAre(1, 2), ElementsAre()));
}

TEST(ReadParameters, SaysFileLineKeyValueAndRule) {
  EXPECT_EQ(refusal("scan:\n  rate: -1\n"), "w.yaml:2: world.scan.rate = -1: must be between 0.1 and 100 Hz");
  EXPECT_EQ(refusal("seed: -3"), "w.yaml:1: world.seed = -3: must be at least 0");
  EXPECT_EQ(refusal("gains: [1, 4]"), "w.yaml:1: world.gains.1 = 4: must be at most 3");
  EXPECT_EQ(refusal("seed: 1.0"), "w.yaml:1: world.seed = 1.0: must be a whole number");
  EXPECT_EQ(refusal("seed: 99999999999999999999"),
            "w.yaml:1: world.seed = 99999999999999999999: must be a whole number");
  EXPECT_EQ(refusal("react: yes"), "w.yaml:1: world.react = yes: must be true or false");
  EXPECT_EQ(refusal("fast: \"3\""), "w.yaml:1: world.fast = \"3\": must be a number");
  EXPECT_EQ(refusal("scan: {rate: [1]}"), "w.yaml:1: world.scan.rate = a list: must be a number of Hz");
  EXPECT_EQ(refusal("fast:"), "w.yaml:1: world.fast = nothing: must be a number");
  EXPECT_EQ(refusal("fast: 0x10"), "w.yaml:1: world.fast = 0x10: must be a number");
  EXPECT_EQ(refusal("model: orc"),
            "w.yaml:1: world.model = orc: must be one of orca, social_force; did you mean 'orca'?");
  EXPECT_EQ(refusal("label: {}"), "w.yaml:1: world.label = a map: must be text");
  EXPECT_EQ(refusal("walls: {x: 1}"), "w.yaml:1: world.walls = a map: must be a list");
  EXPECT_EQ(refusal("scan: 3"), "w.yaml:1: world.scan = 3: must be a map of parameters");
  EXPECT_EQ(refusal("- 3"), "w.yaml:1: world = a list: must be a map of parameters");
}

TEST(ReadParameters, TakesOnlyFiniteNumbersUnlessTheFieldSaysSo) {
  EXPECT_EQ(refusal("fast: .nan"), "w.yaml:1: world.fast = .nan: must be a finite number");
  EXPECT_EQ(refusal("fast: .inf"), "w.yaml:1: world.fast = .inf: must be a finite number");
  EXPECT_EQ(refusal("fast: inf"), "w.yaml:1: world.fast = inf: must be a number");
  EXPECT_EQ(refusal("fast: 1e999"), "w.yaml:1: world.fast = 1e999: must be a number");
  EXPECT_EQ(refusal("scan: {max_range: .nan}"),
            "w.yaml:1: world.scan.max_range = .nan: must be a finite number");
  EXPECT_EQ(refusal("scan: {max_range: -.inf}"),
            "w.yaml:1: world.scan.max_range = -.inf: must be at least 0 m");
}

TEST(ReadParameters, NamesTheNearestKnownKey) {
  EXPECT_EQ(refusal("scan:\n  raet: 1\n"), "w.yaml:2: world.scan.raet: unknown key; did you mean 'rate'?");
  EXPECT_EQ(refusal("scan:\n  colour: 1\n"),
            "w.yaml:2: world.scan.colour: unknown key; known: rate, beams, max_range");
}

TEST(ReadParameters, ReportsAllViolationsAndRulesOverFields) {
  EXPECT_EQ(refusal("slow: 3\nlabel: x"), "w.yaml:1: world: fast must be at least slow");
  EXPECT_EQ(refusal("slow: 3\nscan: {rate: 0, beams: 0}\ncolour: 1\n"),
            "w.yaml:2: world.scan.rate = 0: must be between 0.1 and 100 Hz\n"
            "w.yaml:2: world.scan.beams = 0: must be between 1 and 10000\n"
            "w.yaml:3: world.colour: unknown key; known: react, seed, model, label, scan, walls, gains, "
            "flags, cells, slow, fast");
  const ConfigNode limits = parse_yaml("limits:\n  acc_max: 3\n", "robot.yaml");
  EXPECT_THAT([&] { read_parameters<Robot>(limits, "robot"); },
              testing::ThrowsMessage<ConfigError>(
                  "robot.yaml:2: robot.limits: stop_deceleration must be at least acc_max"));
}

TEST(ReadParameters, LeavesTheValueAloneWhenItThrows) {
  World world;
  EXPECT_THROW(read_into(world, parse_yaml("react: false\nseed: x", "w.yaml"), ""), ConfigError);
  EXPECT_EQ(world, World{});
}

TEST(ReadParameters, LimitsTheLengthOfLists) {
  std::string yaml = "gains: [";
  for (std::size_t i = 0; i <= kMaxListElements; ++i) yaml += "1,";
  EXPECT_EQ(refusal(yaml + "]"), "w.yaml:1: world.gains = 20001 elements: must have at most 20000 elements");
}

TEST(ReadParameters, ResolvesPathsAgainstTheFileThatNamesThem) {
  EXPECT_EQ(read_parameters<Map>(parse_yaml("file: ../maps/a.yaml", "config/graphs/g.yaml"), "").file,
            "config/maps/a.yaml");
  EXPECT_EQ(read_parameters<Map>(parse_yaml("file: /m/a.yaml", "config/g.yaml"), "").file, "/m/a.yaml");
  EXPECT_EQ(read_parameters<Map>(parse_yaml("file: maps/a.yaml", "--set"), "").file, "maps/a.yaml");
  EXPECT_EQ(read_parameters<Map>(parse_yaml("file: ''", "config/g.yaml"), "").file, "");
}

TEST(WriteParameters, ReadsBackEqual) {
  World world;
  world.react = false;
  world.seed = std::numeric_limits<std::int64_t>::max();
  world.label = "a \"b\" \\ c: [1] #\n\t\x01 \xc3\xa9";
  world.scan.rate = 0.1 + 0.2;
  world.walls = {{1e-300, -0.0}, {123456789.125, 5.0}};
  world.gains = {};
  world.flags = {true, false};
  world.cells = {{1, 2}, {}, {-3}};
  EXPECT_EQ(read(to_yaml(world)), world);
  EXPECT_EQ(to_yaml(world.scan), "rate: 0.30000000000000004\nbeams: 720\nmax_range: .inf\n");
  for (const std::string label :
       {"true", "no", "1", "1e3", ".inf", "~", "", "null", "-", "a b", "x", "NaN", "<<"}) {
    world.label = label;
    EXPECT_EQ(read(to_yaml(world)).label, label);
  }
}

TEST(ListParameters, GivesOneRowPerFieldInOrder) {
  World world;
  world.walls = {{3.0, 4.0}, {5.0, 6.0}};
  const std::vector<ParameterRow> rows = list_parameters(world, "world");
  std::vector<std::string> lines;
  lines.reserve(rows.size());
  for (const ParameterRow& row : rows) {
    lines.push_back(row.name + " " + row.type + " " + row.value + " " + row.default_value);
  }
  EXPECT_THAT(lines, ElementsAre("world.react bool true true", "world.seed integer 1 1",
                                 "world.model string orca orca", "world.label string \"\" \"\"",
                                 "world.scan.rate double 10.0 10.0", "world.scan.beams integer 720 720",
                                 "world.scan.max_range double .inf .inf", "world.walls.0.x double 3.0 1.0",
                                 "world.walls.0.y double 4.0 2.0", "world.walls.1.x double 5.0 ",
                                 "world.walls.1.y double 6.0 ", "world.gains double list [0.5] [0.5]",
                                 "world.flags bool list [] []", "world.cells integer list list [] []",
                                 "world.slow double 1.0 1.0", "world.fast double 2.0 2.0"));
  EXPECT_EQ(rows[4].unit, "Hz");
  EXPECT_EQ(rows[4].min, 0.1);
  EXPECT_EQ(rows[4].doc, "scans per second");
  EXPECT_THAT(rows[2].choices, ElementsAre("orca", "social_force"));
}

// Fields of a list of structs once, though the list is empty.
TEST(ParameterNames, AreThoseThatCanBeSet) {
  World world;
  EXPECT_THAT(parameter_names(FieldRef::of(world)),
              ElementsAre("react", "seed", "model", "label", "scan.rate", "scan.beams", "scan.max_range",
                          "walls.x", "walls.y", "gains", "flags", "cells", "slow", "fast"));
}

struct Renamed {
  double max_age = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("max_age", max_age, {.unit = "s", .first = true, .doc = "oldest that counts"});
    v.retired({"age", "timeout"}, "set max_age");
  }
};

TEST(RetiredNames, AreRefusedWithWhatToDo) {
  std::vector<Violation> violations;
  Renamed renamed;
  read_into(renamed, parse_yaml("{max_age: 2.0, age: 3.0}", "d.yaml"), "scan", violations);
  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0].text(), "d.yaml:1: scan.age = 3.0: is no parameter any more: set max_age");
  EXPECT_EQ(renamed.max_age, 2.0);
  EXPECT_TRUE(list_parameters(renamed).at(0).first);
}

std::string yaml_refusal(const std::string& yaml) {
  try {
    parse_yaml(yaml, "d.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ParseYaml, RefusesWhatAConfigurationDoesNotNeed) {
  EXPECT_EQ(yaml_refusal("a: 1\nb:\n  c: 1\n  c: 2\n"), "d.yaml:4: b.c: this key is given twice");
  EXPECT_EQ(yaml_refusal("a: !!str 1"), "d.yaml:1: a: tags such as !!str are not used here");
  EXPECT_EQ(yaml_refusal("a: 1\n---\nb: 2"), "d.yaml:2: only one YAML document is allowed in a file");
  EXPECT_EQ(yaml_refusal("a: 1\n? [b]\n: 2"), "d.yaml:2: a key must be text");
  EXPECT_EQ(yaml_refusal("a: 1\n~: 2"), "d.yaml:2: a key must be text");
  EXPECT_EQ(yaml_refusal("a: &x [*x]"), "d.yaml:1: a.0: an alias must not stand inside its own anchor");
  EXPECT_EQ(yaml_refusal(std::string("a: 1\nb: \0", 9)), "d.yaml:2: not UTF-8 text");
  EXPECT_EQ(yaml_refusal("a: \xff"), "d.yaml:1: not UTF-8 text");
  EXPECT_EQ(yaml_refusal("a: \xe2\x82"), "d.yaml:1: not UTF-8 text");
  EXPECT_EQ(yaml_refusal("a:\n  b: [1, 2\n"), "d.yaml:3: a.b.2: not YAML: end of sequence flow not found");
  // yaml-cpp 0.8 names the anchor, 0.7 does not.
  EXPECT_THAT(
      yaml_refusal("a: *nowhere"),
      testing::MatchesRegex("d.yaml:1: a: not YAML: the referenced anchor is not defined(: nowhere)?"));
}

TEST(ParseYaml, LimitsDepthValuesAndBytes) {
  EXPECT_EQ(yaml_refusal(std::string(32, '[') + std::string(32, ']')), "accepted");
  EXPECT_EQ(
      yaml_refusal(std::string(33, '[') + std::string(33, ']')), "d.yaml:1: " + [] {
        std::string key = "0";
        for (int i = 1; i < 32; ++i) key += ".0";
        return key;
      }() + ": nested deeper than 32 levels");
  EXPECT_EQ(yaml_refusal(std::string(kMaxYamlBytes + 1, ' ')), "d.yaml: larger than 1048576 bytes");

  std::string values = "x: &x [0,0,0,0,0,0,0,0,0,0]\n";  // each line holds ten times the one before
  std::string bytes = "a: &a " + std::string(100'000, 'a') + "\nb: [";
  std::string last = "x";
  for (const std::string name : {"y", "z", "u", "v", "w"}) {
    values.append(name).append(": &").append(name).append(" [");
    for (int i = 0; i < 10; ++i) values.append("*").append(last).append(",");
    values += "]\n";
    last = name;
  }
  for (int i = 0; i < 50; ++i) bytes += "*a,";
  EXPECT_THAT(yaml_refusal(values), testing::MatchesRegex("d.yaml:[0-9]: .*: more than 100000 values"));
  EXPECT_THAT(yaml_refusal(bytes + "]"),
              testing::MatchesRegex("d.yaml:2: b\\..*: more than 4194304 bytes of values"));
  EXPECT_EQ(yaml_refusal("a: &a {b: 1}\nc: [*a, *a]\n"), "accepted");
}

TEST(LoadYaml, SaysWhyAFileCannotBeRead) {
  EXPECT_THAT([] { load_yaml("/nowhere/g.yaml"); },
              testing::ThrowsMessage<ConfigError>("/nowhere/g.yaml: no such file"));
  EXPECT_THAT([] { load_yaml("/dev/zero"); }, testing::ThrowsMessage<ConfigError>("/dev/zero: not a file"));
  EXPECT_THAT([] { load_yaml("/"); }, testing::ThrowsMessage<ConfigError>("/: not a file"));
}

std::string override_refusal(const std::string& yaml, const std::string& text) {
  try {
    ConfigNode root = parse_yaml(yaml, "w.yaml");
    apply_override(root, parse_override(text));
    read_parameters<World>(root, "");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Overrides, ChangeOneValue) {
  ConfigNode root = parse_yaml("walls: [{x: 1}]\nseed: 4", "w.yaml");
  for (const std::string text : {"scan.rate=20", "walls.0.y=7", "walls.1={x: 3, y: 4}", "gains=[1, 2]",
                                 "label=a=b", "seed=5", "seed=6"}) {
    apply_override(root, parse_override(text));
  }
  const World world = read_parameters<World>(root, "");
  EXPECT_EQ(world.scan.rate, 20.0);
  EXPECT_EQ(world.walls, (std::vector<Edge>{{1.0, 7.0}, {3.0, 4.0}}));
  EXPECT_THAT(world.gains, ElementsAre(1.0, 2.0));
  EXPECT_EQ(world.label, "a=b");
  EXPECT_EQ(world.seed, 6);
}

TEST(Overrides, SayWhatIsWrong) {
  EXPECT_EQ(override_refusal("", "scan.rate=-1"), "--set: scan.rate = -1: must be between 0.1 and 100 Hz");
  EXPECT_EQ(override_refusal("", "scan.rat=1"), "--set: scan.rat: unknown key; did you mean 'rate'?");
  EXPECT_EQ(override_refusal("", "scan.rate"), "--set: scan.rate: must have the form component.param=value");
  EXPECT_EQ(override_refusal("", "scan..rate=1"),
            "--set: scan..rate: must have the form component.param=value");
  EXPECT_EQ(override_refusal("", "=1"), "--set: must have the form component.param=value");
  EXPECT_EQ(override_refusal("", "seed=[1 2}"),
            "--set: seed = [1 2}: must be a YAML value; not YAML: illegal flow end");
  EXPECT_EQ(override_refusal("seed: 1", "seed.x=1"), "--set: seed.x = 1: 'seed' has no parts, it is 1");
  EXPECT_EQ(override_refusal("walls: [{x: 1}]", "walls.2.x=1"),
            "--set: walls.2.x = 1: '2' must be a list index between 0 and 1");
  EXPECT_EQ(override_refusal("", "walls.0.x=1"),
            "--set: walls.0.x = 1: no list to index is given here; set the whole list, as name=[...]");
}

TEST(FindDotted, WalksMapsAndLists) {
  const ConfigNode root = parse_yaml("a: {b: [1, {c: 2}]}", "w.yaml");
  EXPECT_EQ(find_dotted(root, "a.b.1.c")->scalar, "2");
  EXPECT_EQ(find_dotted(root, "a.b.2"), nullptr);
  EXPECT_EQ(find_dotted(root, "a.x.y"), nullptr);
  EXPECT_EQ(find_dotted(root, "a.b.-1"), nullptr);
}

TEST(ScalarText, ReadsDurations) {
  EXPECT_EQ(parse_duration("20ms"), Duration::milliseconds(20));
  EXPECT_EQ(parse_duration("250 ms"), Duration::milliseconds(250));
  EXPECT_EQ(parse_duration("0.02s"), Duration::milliseconds(20));
  EXPECT_EQ(parse_duration("0.02"), Duration::milliseconds(20));
  EXPECT_EQ(parse_duration("5 us"), Duration{5'000});
  EXPECT_EQ(parse_duration("2min"), Duration::milliseconds(120'000));
  for (const char* bad : {"", "ms", "20 parsecs", "1 2 s", ".inf", ".nan s", "1e300 s", "--1s"}) {
    EXPECT_EQ(parse_duration(bad), std::nullopt) << bad;
  }
}

TEST(ScalarText, ReadsSizes) {
  EXPECT_EQ(parse_size("100MB"), 100'000'000U);
  EXPECT_EQ(parse_size("1.5 GiB"), 3U << 29U);
  EXPECT_EQ(parse_size("500 kB"), 500'000U);
  EXPECT_EQ(parse_size("4096"), 4096U);
  EXPECT_EQ(parse_size("0B"), 0U);
  for (const char* bad : {"", "MB", "100 MX", "100mb", "-1MB", ".inf", "1e30GB", "1 2 MB"}) {
    EXPECT_EQ(parse_size(bad), std::nullopt) << bad;
  }
}

TEST(Nearest, CountsInsertionsDeletionsChangesAndSwaps) {
  EXPECT_EQ(nearest_of("raet", {"beams", "rate"}), "rate");
  EXPECT_EQ(nearest_of("max_speed", {"v_max", "speed_max"}), std::nullopt);
  EXPECT_EQ(nearest_of("wheel_radios", {"wheel_radius", "radius"}), "wheel_radius");
  EXPECT_EQ(nearest_of("", {"a"}), std::nullopt);
}

}  // namespace
}  // namespace bw
