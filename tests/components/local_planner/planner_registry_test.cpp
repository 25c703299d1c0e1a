// A planner that this tree does not know: registered by name, with parameters of its own.
#include "components/local_planner/planner_registry.hpp"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <typeinfo>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/local_planner/local_planner_parameters.hpp"
#include "runtime/parameters/parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "tests/components/local_planner/planner_drive.hpp"

namespace bw {
namespace {

enum class Side { left, right };
constexpr auto choice_table(Side) { return choices<Side>({{Side::left, "left"}, {Side::right, "right"}}); }

struct Wheel {
  double grip = 0.5;
  template <class Visitor>
  void fields(Visitor& v) {
    v("grip", grip, {.min = 0, .max = 1});
  }
};

struct CirclerOptions {
  double turn_rate = 0.25;
  int laps = 2;
  bool fast = false;
  std::string label = "round";
  std::vector<double> radii = {1.0};
  Side side = Side::left;
  Wheel wheel;

  template <class Visitor>
  void fields(Visitor& v) {
    v("turn_rate", turn_rate, {.unit = "rad/s", .min = 0, .max = 1, .doc = "of the circle"});
    v("laps", laps, {.min = 1});
    v("fast", fast);
    v("label", label);
    v("radii", radii, {.unit = "m"});
    v("side", side);
    v("wheel", wheel);
  }
  std::optional<std::string> violated_rule() const {
    if (fast && turn_rate > 0.5) return "turn_rate must be at most 0.5 when fast";
    return std::nullopt;
  }
};

class Circler final : public CheckedPlanner {
 public:
  Circler(const CirclerOptions& options, const DrivingOptions& driving)
      : CheckedPlanner(driving), options_(options) {}

 private:
  PlanningResult drive(const PlanningProblem&) override {
    ++cycles_;
    const double sign = options_.side == Side::left ? 1.0 : -1.0;
    return {.status = PlanningStatus::ok, .command = {0.0, sign * options_.turn_rate}, .iterations = cycles_};
  }
  void forget() override { cycles_ = 0; }

  CirclerOptions options_;
  int cycles_ = 0;
};

BW_PLANNER(Circler, CirclerOptions, "circler")

LocalPlannerParameters read(const std::string& yaml) {
  return read_parameters<LocalPlannerParameters>(parse_yaml(yaml, "g.yaml"), "local_planner");
}

std::string refusal(const std::string& yaml) {
  try {
    read(yaml);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PlannerRegistry, NamesThePlannersOfTheTreeAndTheNewOne) {
  EXPECT_THAT(planner_names(), testing::ElementsAre("circler", "dwa", "edwa", "eteb", "hrvo", "mppi", "orca",
                                                    "pteb", "teb", "teb_homotopy"));
}

TEST(PlannerRegistry, MakesItWithItsParameters) {
  const LocalPlannerParameters p = read(
      "algorithm: circler\ncircler: {turn_rate: 0.75, side: right, laps: 3, radii: [2, 3], wheel: {grip: "
      "0.1}}");
  EXPECT_EQ(make_planner(p.algorithm, p.planners)->plan(problem_to({5, 0, 0})).command, (Twist2{0.0, -0.75}));
  EXPECT_EQ(make_planner("circler", {})->plan(problem_to({5, 0, 0})).command, (Twist2{0.0, 0.25}));
  const auto& read_options = p.planners.of<CirclerOptions>("circler");
  EXPECT_EQ(read_options.laps, 3);
  EXPECT_THAT(read_options.radii, testing::ElementsAre(2.0, 3.0));
  EXPECT_EQ(read_options.wheel.grip, 0.1);
}

TEST(PlannerRegistry, ReadsItsSectionAsStrictlyAsAllOthers) {
  EXPECT_EQ(refusal("circler: {turn_rat: 1}"),
            "g.yaml:1: local_planner.circler.turn_rat: unknown key; did you mean 'turn_rate'?");
  EXPECT_EQ(refusal("circler: {turn_rate: 2}"),
            "g.yaml:1: local_planner.circler.turn_rate = 2: must be between 0 and 1 rad/s");
  EXPECT_EQ(refusal("circler: {side: lef}"),
            "g.yaml:1: local_planner.circler.side = lef: must be one of left, right; did you mean 'left'?");
  EXPECT_EQ(refusal("circler: {laps: 0}"), "g.yaml:1: local_planner.circler.laps = 0: must be at least 1");
  EXPECT_EQ(refusal("circler: {wheel: {grip: 2}}"),
            "g.yaml:1: local_planner.circler.wheel.grip = 2: must be between 0 and 1");
  EXPECT_EQ(refusal("circler: {fast: true, turn_rate: 0.75}"),
            "g.yaml:1: local_planner.circler: turn_rate must be at most 0.5 when fast");
  EXPECT_EQ(refusal("circlr: {}"), "g.yaml:1: local_planner.circlr: unknown key; did you mean 'circler'?");
}

TEST(PlannerRegistry, ListsAndWritesItsParameters) {
  LocalPlannerParameters p = read("circler: {laps: 7, side: right}");
  std::vector<std::string> lines;
  for (const ParameterRow& row : list_parameters(p)) {
    if (row.name.starts_with("circler."))
      lines.push_back(row.name + " " + row.type + " " + row.value + " " + row.default_value);
  }
  EXPECT_THAT(lines,
              testing::ElementsAre("circler.turn_rate double 0.25 0.25", "circler.laps integer 7 2",
                                   "circler.fast bool false false", "circler.label string round round",
                                   "circler.radii double list [1.0] [1.0]", "circler.side string right left",
                                   "circler.wheel.grip double 0.5 0.5"));
  EXPECT_THAT(to_yaml(p), testing::HasSubstr("circler:\n  turn_rate: 0.25\n  laps: 7\n  fast: false\n"));
  EXPECT_EQ(to_yaml(read(to_yaml(p))), to_yaml(p));
}

// A path is told from a name by its slash, also beside the file that names it, where none would be left.
TEST(PlannerRegistry, AProgramIsNamedByItsPath) {
  EXPECT_EQ(refusal("algorithm: ./follower.py"),
            "g.yaml:1: local_planner.algorithm = ./follower.py: planner processes are not started here");
  EXPECT_THROW(make_planner("./follower.py", {}), std::runtime_error);
  register_planner_programs(
      {.fault_of = [](std::string_view) { return std::string(); },
       .make = [](std::string_view, const DrivingOptions& driving) -> std::unique_ptr<LocalPlanner> {
         return std::make_unique<Circler>(CirclerOptions{}, driving);
       }});
  const LocalPlannerParameters p = read("algorithm: ./follower.py");
  EXPECT_EQ(p.algorithm, (std::filesystem::current_path() / "follower.py").string());
  EXPECT_EQ(make_planner(p.algorithm, p.planners)->plan(problem_to({5, 0, 0})).command, (Twist2{0.0, 0.25}));
  EXPECT_EQ(planner_label(p.algorithm), "follower.py");
  EXPECT_EQ(planner_label("teb"), "teb");
}

TEST(PlannerRegistry, RefusesASecondPlannerOfOneName) {
  EXPECT_THROW((register_planner_type<Circler, CirclerOptions>("teb")), std::logic_error);
  EXPECT_THROW((register_planner_type<Circler, CirclerOptions>("circler")), std::logic_error);
  EXPECT_THROW((register_planner_type<Circler, CirclerOptions>("homotopy")), std::logic_error) << "a section";
  EXPECT_THROW(register_planner("teb_homotopy", {}, nullptr), std::logic_error);
}

TEST(PlannerRegistry, GivesASectionToWhoeverKnowsItsNameAndType) {
  PlannerOptions options;
  options.of<CirclerOptions>("circler").turn_rate = 0.5;
  EXPECT_EQ(make_planner("circler", options)->plan(problem_to({5, 0, 0})).command, (Twist2{0.0, 0.5}));
  EXPECT_EQ(PlannerOptions{}.of<CirclerOptions>("circler").turn_rate, 0.25);
  EXPECT_THROW(options.of<Wheel>("circler"), std::bad_cast);
  EXPECT_THROW(options.of<CirclerOptions>("circlr"), std::out_of_range);
}

// What every planner gets from CheckedPlanner. Goal tolerance 0.1 m: 0.05 m away it has arrived and rotates
// (command by heading alone); pushed out beyond twice the tolerance it drives again, from the start.
TEST(CheckedPlanner, AnswersForThePlannerWhereThereIsNothingToPlan) {
  const auto planner = make_planner("circler", {});
  EXPECT_EQ(planner->plan(problem_to({5, 0, 0})).iterations, 1);
  EXPECT_EQ(planner->plan(problem_to({5, 0, 0})).iterations, 2);

  PlanningProblem problem = problem_to({5, 0, 0});
  problem.plan.clear();
  EXPECT_EQ(planner->plan(problem).status, PlanningStatus::no_plan);
  EXPECT_EQ(planner->plan(problem_to({5, 0, 0})).iterations, 1) << "no plan: everything forgotten";

  problem = problem_to({5, 0, 0});
  problem.pose.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(planner->plan(problem).status, PlanningStatus::bad_input);
  EXPECT_EQ(planner->plan(problem_to({5, 0, 0})).iterations, 1) << "bad input: everything forgotten";

  EXPECT_EQ(planner->plan(problem_to({0.05, 0, 0})).command, Twist2{});
  EXPECT_EQ(planner->plan(problem_to({0.15, 0, 0})).command, Twist2{}) << "within twice the tolerance";
  EXPECT_EQ(planner->plan(problem_to({0.25, 0, 0})).iterations, 1) << "pushed out: a first call";
  planner->plan(problem_to({0.05, 0, 0}));
  planner->reset();
  EXPECT_EQ(planner->plan(problem_to({0.15, 0, 0})).iterations, 1) << "forgot that it had arrived";
}

}  // namespace
}  // namespace bw
