// Which parameters of a node may change when, and what its component hears of it.
#include "runtime/live_parameters.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

struct Clearance {
  double wall = 0.3;
  double person = 0.6;

  void fields(auto& v) {
    v("wall", wall, {.min = 0, .max = 2});
    v("person", person, {.min = 0, .max = 2});
  }
};

struct Options {
  double rate = 10.0;
  double weight = 1.0;
  Clearance clearance;

  void fields(auto& v) {
    v("rate", rate, {.min = 1, .max = 50});
    v("weight", weight, {.min = 0, .max = 9});
    v("clearance", clearance);
  }
  std::optional<std::string> violated_rule() const {
    if (weight > rate) return "weight must not exceed rate";
    return std::nullopt;
  }
};

struct Clock {
  bool use_sim_time = true;
  void fields(auto& v) { v("use_sim_time", use_sim_time); }
};

/// A node of one component that hears of changes.
struct Node {
  explicit Node(std::vector<std::string> fixed = {"rate"}) {
    live.declare({.values = ParameterSet(Options{}),
                  .on_change =
                      [this](const ParameterSet& set, const Tick& tick) {
                        heard.push_back(set.as<Options>().weight);
                        heard_at = tick.now;
                        if (heard.back() == throws_at) throw std::runtime_error("too heavy");
                      },
                  .fixed = std::move(fixed)});
    live.declare_read_only("robot", ParameterSet(Clearance{}), "components share it");
    live.declare_read_only("", ParameterSet(Clock{}), "--clock decides");
  }
  std::vector<std::string> each(const std::vector<NamedValue>& changes) {
    const LiveParameters::Outcome outcome = live.change_each(changes, {.now = Time{5}});
    changed = outcome.changed;
    return outcome.refusals;
  }
  std::string all(const std::vector<NamedValue>& changes) {
    const LiveParameters::Outcome outcome = live.change_all(changes, {.now = Time{5}});
    changed = outcome.changed;
    return outcome.refusals.at(0);
  }
  ParameterValue now(std::string_view name) const { return live.find(name).value().value; }

  LiveParameters live{"planner"};
  std::vector<double> heard;
  Time heard_at;
  double throws_at = -1.0;
  std::vector<NamedValue> changed;
};

TEST(LiveParameters, ListsItsOwnAndWhatIsShared) {
  const Node node;
  EXPECT_THAT(node.live.names(), ElementsAre("rate", "weight", "clearance.wall", "clearance.person",
                                             "robot.wall", "robot.person", "use_sim_time"));
  const auto read_only = [&node](std::string_view name) {
    return node.live.find(name).value().descriptor.read_only;
  };
  EXPECT_TRUE(read_only("rate") && read_only("robot.wall") && read_only("use_sim_time"));
  EXPECT_FALSE(read_only("weight") || read_only("clearance.wall"));
  EXPECT_EQ(node.now("use_sim_time"), ParameterValue(true));
  for (const char* unknown : {"", "robot", "robot.", "robots.wall", "wall", "clearance"}) {
    EXPECT_FALSE(node.live.find(unknown)) << unknown;
  }
}

TEST(LiveParameters, GivesOneSnapshotToTheComponent) {
  Node node;
  EXPECT_THAT(node.each({{"weight", 3.0}, {"clearance.wall", 0.5}}), ElementsAre("", ""));
  EXPECT_THAT(node.heard, ElementsAre(3.0));
  EXPECT_EQ(node.heard_at, Time{5});
  EXPECT_THAT(node.changed, ElementsAre(NamedValue{"weight", 3.0}, NamedValue{"clearance.wall", 0.5}));
  EXPECT_EQ(node.now("weight"), ParameterValue(3.0));
}

TEST(LiveParameters, JudgesEachWithThoseAcceptedBefore) {
  Node node(std::vector<std::string>{});
  EXPECT_THAT(node.each({{"weight", 20.0}, {"rate", 2.0}, {"weight", 3.0}, {"weight", 2.0}, {"wieght", 1.0}}),
              ElementsAre("weight = 20.0: must be between 0 and 9", "", "weight must not exceed rate", "",
                          "unknown parameter 'wieght'; did you mean 'weight'?"));
  EXPECT_THAT(node.heard, ElementsAre(2.0));
  EXPECT_THAT(node.changed, ElementsAre(NamedValue{"weight", 2.0}, NamedValue{"rate", 2.0}));
}

TEST(LiveParameters, ChangesAllOrNone) {
  Node node(std::vector<std::string>{});
  EXPECT_EQ(node.all({{"clearance.wall", 1.0}, {"rate", 2.0}, {"weight", 3.0}}),
            "weight must not exceed rate");
  EXPECT_EQ(node.all({{"clearance.wall", 1.0}, {"robot.wall", 1.0}}),
            "robot.wall is read-only: components share it");
  EXPECT_TRUE(node.heard.empty() && node.changed.empty());
  EXPECT_EQ(node.now("clearance.wall"), ParameterValue(0.3));
  EXPECT_EQ(node.all({{"weight", 2.0}, {"rate", 2.0}, {"clearance.wall", 1.0}}), "");
  EXPECT_THAT(node.heard, ElementsAre(2.0));
  EXPECT_EQ(node.changed.size(), 3U);
}

TEST(LiveParameters, RefusesWhatIsFixedUnlessItStaysAsItIs) {
  Node node({"clearance", "rate"});
  const std::string why = " may not change while planner is active; deactivate and clean up first";
  EXPECT_THAT(
      node.each({{"rate", 20.0}, {"clearance.wall", 1.0}, {"robot.wall", 1.0}, {"use_sim_time", false}}),
      ElementsAre("rate" + why, "clearance.wall" + why, "robot.wall is read-only: components share it",
                  "use_sim_time is read-only: --clock decides"));
  EXPECT_THAT(node.each({{"rate", 10.0}, {"robot.wall", 0.3}, {"use_sim_time", true}, {"weight", 1.0}}),
              ElementsAre("", "", "", ""));
  EXPECT_TRUE(node.heard.empty() && node.changed.empty());
}

TEST(LiveParameters, AreAllFixedForAComponentThatDoesNotListen) {
  LiveParameters live("world");
  live.declare({.values = ParameterSet(Options{}), .on_change = nullptr});
  EXPECT_TRUE(live.find("weight").value().descriptor.read_only);
  const std::vector<NamedValue> change = {{"weight", 2.0}};
  EXPECT_THAT(live.change_each(change, {}).refusals,
              ElementsAre("weight may not change while world is active; deactivate and clean up first"));
}

TEST(LiveParameters, PutsTheOldSnapshotBackWhenTheComponentThrows) {
  Node node;
  node.throws_at = 4.0;
  EXPECT_THAT(node.each({{"weight", 4.0}, {"weight", 30.0}}),
              ElementsAre("planner does not take it: too heavy", "weight = 30.0: must be between 0 and 9"));
  EXPECT_THAT(node.heard, ElementsAre(4.0, 1.0));
  EXPECT_TRUE(node.changed.empty());
  EXPECT_EQ(node.all({{"weight", 4.0}}), "planner does not take it: too heavy");
  EXPECT_EQ(node.now("weight"), ParameterValue(1.0));
}

TEST(LiveParameters, KeepsChangesOfAComponentThatIsNotConfiguredForItsNextStart) {
  Node node;
  node.live.set_configured(false);
  EXPECT_FALSE(node.live.find("rate").value().descriptor.read_only);
  EXPECT_THAT(node.each({{"rate", 20.0}, {"rate", 99.0}, {"robot.wall", 1.0}}),
              ElementsAre("", "rate = 99.0: must be between 1 and 50",
                          "robot.wall is read-only: components share it"));
  EXPECT_TRUE(node.heard.empty());
  ConfigNode section = parse_yaml("weight: 2", "g.yaml");
  node.live.write_changes(section);
  EXPECT_EQ(read_parameters<Options>(section, "").rate, 20.0);
  EXPECT_EQ(read_parameters<Options>(section, "").weight, 2.0);
}

TEST(LiveParameters, RefuseAMistypedFixedName) {
  LiveParameters live("planner");
  EXPECT_THROW(live.declare({.values = ParameterSet(Options{}), .on_change = nullptr, .fixed = {"rat"}}),
               std::logic_error);
}

}  // namespace
}  // namespace bw
