// Mutated graphs and parameter files: whatever the bytes, a graph is read or refused with file, line and key,
// and no allocation follows an unchecked size. Seeds are printed; a failure prints the document.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/model/robot.hpp"
#include "runtime/graph/check_graph.hpp"
#include "runtime/graph/dot.hpp"
#include "runtime/parameters/parameters.hpp"
#include "tests/runtime/largest_allocation.hpp"

namespace bw {
namespace {

constexpr std::size_t kAllocationLimit = 16 << 20;

const std::string kGraphText = R"(# a graph with everything in it
ros_distro: jazzy
namespace: "house"
frame_prefix: robot1/
transport: localhost
plugins: [lib/own.so]
robot: robot.yaml
robots:
  one: {planner: {goal: {x: 3.0}}}
  two:
components:
  world: &world
    shared: true
    process: world+base
    parameters:
      seed: 7
      resolution: 0.05
      size: [20.0, 6.0]
      reacts: true
      walls:
        - {x: 0.0, y: 1.0, name: north}
        - {x: 3.5, y: -1.0, name: "south wall"}
  planner:
    type: local_planner
    process: planning
    lane: planner
    latency: 20ms
    parameters: parameters.yaml
    remap: {cmd_vel_nav: cmd_vel, ~/debug: /debug}
    inputs:
      odom: {max_age: 500 ms, on_stale: stop}
      goal_pose: {external: true}
  motor:
    namespace: /house
    inputs: {cmd_vel: {max_age: 0.2}}
)";

const std::string kParameterText = R"(seed: 3
resolution: 1e-1
size: [1, 2]
robot:
  name: "generic"
  limits: {v_max: 1.0, jerk_max: 5}
walls:
  - x: 1
    y: 2
  - {name: &n east, x: -3}
  - {name: *n}
)";

struct Wall {
  double x = 0.0;
  double y = 0.0;
  std::string name;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e3, .max = 1e3});
    v("y", y, {.unit = "m", .min = -1e3, .max = 1e3});
    v("name", name);
  }
};

struct Parameters {
  std::int64_t seed = 0;
  double resolution = 0.05;
  std::vector<double> size = {1.0, 1.0};
  bool reacts = false;
  std::vector<Wall> walls;
  Robot robot;

  template <class Visitor>
  void fields(Visitor& v) {
    v("seed", seed, {.min = 0});
    v("resolution", resolution, {.unit = "m", .min = 0.001, .max = 1});
    v("size", size, {.unit = "m", .min = 0.1, .max = 1e4});
    v("reacts", reacts);
    v("walls", walls);
    v("robot", robot);
  }
  std::optional<std::string> violated_rule() const {
    if (size.size() != 2) return "size must have two elements";
    return std::nullopt;
  }
};

std::size_t below(std::size_t n, Random& random) {
  return n == 0 ? 0 : static_cast<std::size_t>(random.bits() % n);
}

/// Still YAML, mostly: one key gets another value, or another name.
void change_entry(std::string& text, Random& random) {
  static const std::vector<std::string> kValues = {"-1",
                                                   "0",
                                                   ".nan",
                                                   "-.inf",
                                                   "1e999",
                                                   "1e6",
                                                   "1000000",
                                                   "99999999999999999999",
                                                   "null",
                                                   "''",
                                                   "true",
                                                   "no",
                                                   "1 ms",
                                                   "[]",
                                                   "[1, [2]]",
                                                   "{}",
                                                   "{x: 1}",
                                                   "\"5\"",
                                                   "a b",
                                                   "/a/b",
                                                   "~/a",
                                                   "../robot.yaml",
                                                   "/dev/zero",
                                                   ".",
                                                   "&a 1",
                                                   "east",
                                                   "stop",
                                                   "robot.yaml",
                                                   std::string(300, 'a')};
  const std::size_t colon = text.find(": ", below(text.size() + 1, random));
  if (colon == std::string::npos) return;
  if (below(4, random) == 0) {
    text.insert(text.begin() + static_cast<std::ptrdiff_t>(colon), 'x');
  } else {
    const std::size_t end = std::min(text.find_first_of(",}\n", colon + 2), text.size());
    text.replace(colon + 2, end - colon - 2, kValues[below(kValues.size(), random)]);
  }
}

/// Bytes, pieces and tokens that YAML treats in its own way, anywhere.
void change_bytes(std::string& text, const std::string& other, Random& random) {
  static const std::vector<std::string> kTokens = {"[",
                                                   "]",
                                                   "{",
                                                   "}",
                                                   "[[[[[[[[",
                                                   "- ",
                                                   "? ",
                                                   ": ",
                                                   ":",
                                                   ",",
                                                   "&a ",
                                                   "*a",
                                                   "*world",
                                                   "<<: *world",
                                                   "!!binary ",
                                                   "!x ",
                                                   "%YAML 9.9\n",
                                                   "---\n",
                                                   "...\n",
                                                   "|\n",
                                                   ">-\n",
                                                   "\"",
                                                   "'",
                                                   "#",
                                                   "\t",
                                                   "\r",
                                                   "\n",
                                                   "  ",
                                                   "\\x",
                                                   "\xff\xfe",
                                                   "\xe2\x80\xa8",
                                                   "\xef\xbb\xbf",
                                                   std::string(1, '\0'),
                                                   std::string(40, '['),
                                                   std::string(200, ' ')};
  const std::size_t at = below(text.size() + 1, random);
  const std::size_t length = std::min(below(40, random), text.size() - at);
  switch (below(7, random)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, text.substr(below(text.size() + 1, random), length));
      break;
    case 2:
      text.insert(at, kTokens[below(kTokens.size(), random)]);
      break;
    case 3:
      text.replace(at, length, kTokens[below(kTokens.size(), random)]);
      break;
    case 4:
      text.insert(at, 1, static_cast<char>(random.bits() & 0xff));
      break;
    case 5:
      text.resize(at);
      break;
    default:
      text.insert(at, other.substr(below(other.size(), random), below(200, random)));
      break;
  }
}

/// Every second document is changed in its entries only, so that it gets past the parser.
std::string mutated(std::string text, const std::string& other, Random& random) {
  const bool is_gentle = below(2, random) == 0;
  for (std::size_t step = 1 + below(3, random); step > 0; --step) {
    is_gentle ? change_entry(text, random) : change_bytes(text, other, random);
  }
  return text;
}

std::vector<ComponentDeclaration> declarations() {
  const std::string twist = "geometry_msgs/msg/Twist", odometry = "nav_msgs/msg/Odometry";
  std::vector<ComponentDeclaration> all = {
      {"world", {}, {{"one/odom", odometry, Qos::standard()}, {"two/odom", odometry, Qos::standard()}}}};
  for (const std::string robot : {"one", "two"}) {
    all.push_back(
        {robot + "/planner",
         {{"odom", odometry, Qos::sensor()}, {"goal_pose", "geometry_msgs/msg/PoseStamped", Qos::standard()}},
         {{"cmd_vel_nav", twist, Qos::command(), true}, {"~/debug", twist, Qos::standard()}}});
    all.push_back({robot + "/motor", {{"cmd_vel", twist, Qos::command()}}, {}});
  }
  return all;
}

/// What is wrong with a document as a whole, or with the key itself, has no key.
bool concerns_document(const std::string& rule) {
  static const std::array<std::string, 7> kRules = {
      "not YAML",           "not UTF-8", "must be a map",     "only one YAML document",
      "a key must be text", "tags",      "must have the form"};
  return std::any_of(kRules.begin(), kRules.end(),
                     [&rule](const std::string& r) { return rule.starts_with(r); });
}

struct Outcome {
  int accepted = 0;
  int refused = 0;
};

class Fuzz : public testing::TestWithParam<std::uint64_t> {
 protected:
  Fuzz() : folder_(std::filesystem::path(testing::TempDir()) / ("bw_fuzz_" + std::to_string(GetParam()))) {
    std::filesystem::create_directories(folder_);
    write("robot.yaml", "radius: 0.3\n");
    write("parameters.yaml", kParameterText);
  }
  ~Fuzz() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  void run(const std::string& document, const std::vector<std::string>& overrides, Outcome& outcome) const {
    largest_allocation = 0;
    std::vector<Violation> violations;
    try {
      Graph graph = load_graph(folder_ / "graph.yaml", overrides);
      for (const ComponentNode& node : graph.components) {
        Parameters parameters;
        read_into(parameters, node.parameters, node.name, violations);
        to_yaml(parameters);
        list_parameters(parameters, node.name);
      }
      for (const Violation& violation : check_graph(declarations(), graph)) violations.push_back(violation);
      to_dot(declarations(), graph);
    } catch (const ConfigError& error) {
      violations = error.violations();
      EXPECT_FALSE(violations.empty());
      EXPECT_STRNE(error.what(), "");
    }
    ++(violations.empty() ? outcome.accepted : outcome.refused);
    for (const Violation& violation : violations) {
      const bool is_located = violation.where.line >= 1 || violation.where.file == kOverrideFile ||
                              violation.rule == "is not a component of this graph";
      EXPECT_FALSE(violation.where.file.empty()) << violation.text() << "\nin\n" << document;
      EXPECT_TRUE(is_located) << violation.text() << "\nin\n" << document;
      EXPECT_TRUE(!violation.key.empty() || concerns_document(violation.rule)) << violation.text() << "\nin\n"
                                                                               << document;
      EXPECT_FALSE(violation.rule.empty()) << "in\n" << document;
    }
    EXPECT_LE(largest_allocation, kAllocationLimit) << "in\n" << document;
  }

  std::filesystem::path folder_;
};

TEST_P(Fuzz, GraphsAreReadOrRefusedInWords) {
  Random random(GetParam());
  Outcome outcome;
  for (int i = 0; i < 1000; ++i) {
    const std::string document = mutated(kGraphText, kParameterText, random);
    write("graph.yaml", document);
    run(document, {}, outcome);
  }
  std::cout << "seed " << GetParam() << ": " << outcome.accepted << " accepted, " << outcome.refused
            << " refused\n";
  EXPECT_GT(outcome.refused, 300);
}

TEST_P(Fuzz, ParameterFilesAreReadOrRefusedInWords) {
  Random random(GetParam());
  Outcome outcome;
  write("graph.yaml", kGraphText);
  for (int i = 0; i < 1000; ++i) {
    const std::string document = mutated(kParameterText, kGraphText, random);
    write("parameters.yaml", document);
    run(document, {}, outcome);
  }
  std::cout << "seed " << GetParam() << ": " << outcome.accepted << " accepted, " << outcome.refused
            << " refused\n";
  EXPECT_GT(outcome.refused, 300);
}

TEST_P(Fuzz, OverridesAreAppliedOrRefusedInWords) {
  Random random(GetParam());
  Outcome outcome;
  write("graph.yaml", kGraphText);
  for (int i = 0; i < 1000; ++i) {
    std::string text = mutated("world.walls.1={x: 20.5, y: 1}", "planner.robot.limits.v_max=1", random);
    run(text, {text}, outcome);
  }
  std::cout << "seed " << GetParam() << ": " << outcome.accepted << " accepted, " << outcome.refused
            << " refused\n";
  EXPECT_GT(outcome.refused, 300);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Fuzz, testing::Values(1, 2, 3, 4));

TEST(FuzzSeeds, TheUnchangedGraphIsAccepted) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "bw_fuzz_none";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "graph.yaml") << kGraphText;
  std::ofstream(folder / "parameters.yaml") << kParameterText;
  std::ofstream(folder / "robot.yaml") << "radius: 0.3\n";
  const Graph graph = load_graph(folder / "graph.yaml");
  EXPECT_EQ(graph.components.size(), 5U) << "a world, and two components of each robot";
  EXPECT_TRUE(check_graph(declarations(), graph).empty());
  EXPECT_EQ(read_parameters<Parameters>(graph.find("one/planner")->parameters, "planner").walls.size(), 3U);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace bw
