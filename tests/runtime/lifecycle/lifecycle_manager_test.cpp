// Our two managers, asked as rviz's Nav2 panel asks them. Numbers of commands:
// nav2_msgs/ManageLifecycleNodes.
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/srv/manage_lifecycle_nodes.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "tests/runtime/lifecycle/scripted_graph.hpp"

namespace bw::test {
namespace {

using nav2_msgs::srv::ManageLifecycleNodes;
using std_srvs::srv::Trigger;
using testing::ElementsAre;

constexpr std::uint8_t kStartup = 0, kPause = 1, kResume = 2, kReset = 3, kShutdown = 4;

/// Gives a manager a command each 10 ms, and asks 5 ms later whether it is active: "ok, yes", "no, b is
/// inactive".
class Panel final : public Component {
 public:
  Panel(std::string manager, std::vector<std::uint8_t> commands, Events& answers)
      : manager_(std::move(manager)), commands_(std::move(commands)), answers_(answers) {}

  void configure(Setup& setup) override {
    setup.every(Duration::milliseconds(10), "command",
                [this, c = setup.client<ManageLifecycleNodes>(manager_ + "/manage_nodes", Need::optional)](
                    const Tick& tick) {
                  if (tick.sequence >= commands_.size()) return;
                  ManageLifecycleNodes::Request request;
                  request.command(commands_[tick.sequence]);
                  c.call(request, Duration::milliseconds(4), [this](const auto* response, const Tick&) {
                    answers_.emplace_back(response == nullptr ? "none" : response->success() ? "ok" : "no");
                  });
                });
    setup.every(Duration::milliseconds(5), "ask",
                [this, c = setup.client<Trigger>(manager_ + "/is_active", Need::optional)](const Tick& tick) {
                  if (tick.sequence % 2 == 1 || tick.sequence < 2) return;
                  c.call({}, Duration::milliseconds(4), [this](const auto* response, const Tick&) {
                    answers_.back() += response == nullptr   ? ", none"
                                       : response->success() ? ", yes"
                                                             : ", " + response->message();
                  });
                });
  }

 private:
  std::string manager_;
  std::vector<std::uint8_t> commands_;
  Events& answers_;
};

Events command(const Graph& graph, const std::string& manager, const std::vector<std::uint8_t>& commands) {
  Events answers;
  std::vector<ExtraComponent> extra = with(std::make_unique<Panel>(manager, commands, answers));
  Host host(graph, {.clock = ClockMode::lockstep}, std::move(extra));
  host.run(Duration::milliseconds(10 * static_cast<std::int64_t>(commands.size()) + 7));
  return answers;
}

struct Nav {
  Events events;
  ScriptedGraph g;
  Nav() {
    add("map_server", Manager::localization);
    add("world", Manager::none);
    add("planner", Manager::navigation);
    add("navigator", Manager::navigation);
  }
  void add(const std::string& name, Manager manager) {
    g.add(ComponentNode{.name = name, .manager = manager}, [this, name] { return talker(events, name); });
  }
  /// After the run came up, until it goes down.
  Events while_running() const {
    const auto begin = std::ranges::find(events, "activate navigator") + 1;
    return {begin, std::ranges::find(begin, events.end(), "deactivate world")};
  }
};

TEST(Manager, PausesAndResumesWhatIsItsOwn) {
  Nav nav;
  EXPECT_THAT(command(nav.g.graph, "/lifecycle_manager_navigation", {kPause, kResume}),
              ElementsAre("ok, planner is inactive", "ok, yes"));
  EXPECT_THAT(nav.while_running(),
              ElementsAre("deactivate navigator", "deactivate planner", "activate planner",
                          "activate navigator", "deactivate navigator", "deactivate planner"));
}

TEST(Manager, WhoFollowsGoesWithItsLeader) {
  Nav nav;
  nav.g.add(ComponentNode{.name = "costmap", .follows = "planner"},
            [&nav] { return talker(nav.events, "costmap"); });
  EXPECT_THAT(command(nav.g.graph, "/lifecycle_manager_navigation", {kPause, kResume}),
              ElementsAre("ok, planner is inactive", "ok, yes"));
  EXPECT_THAT(nav.while_running(),
              ElementsAre("deactivate navigator", "deactivate planner", "deactivate costmap",
                          "activate costmap", "activate planner", "activate navigator",
                          "deactivate navigator", "deactivate planner", "deactivate costmap"));
}

TEST(Manager, ResetAndStartupMakeNewInstances) {
  Nav nav;
  EXPECT_THAT(command(nav.g.graph, "/lifecycle_manager_localization", {kReset, kStartup, kStartup}),
              ElementsAre("ok, map_server is unconfigured", "ok, yes", "ok, yes"));
  EXPECT_THAT(nav.while_running(),
              ElementsAre("deactivate map_server", "cleanup map_server", "configure map_server",
                          "activate map_server", "deactivate navigator", "deactivate planner"));
}

TEST(Manager, ShutdownIsTheEnd) {
  Nav nav;
  EXPECT_THAT(command(nav.g.graph, "/lifecycle_manager_navigation", {kShutdown, kStartup}),
              ElementsAre("ok, planner is finalized", "no, planner is finalized"));
}

TEST(Manager, AFailureOnTheWayUpLeavesNobodyDriving) {
  Nav nav;
  int activations = 0;
  nav.g.add("follower", [&nav, &activations] {
    Script script = talker(nav.events, "follower");
    script.activate = [&activations](const Tick&) {
      if (++activations == 2) throw std::runtime_error("no map");
    };
    return script;
  });
  EXPECT_THAT(command(nav.g.graph, "/lifecycle_manager_navigation", {kPause, kResume, kResume}),
              ElementsAre("ok, planner is inactive", "no, planner is inactive", "ok, yes"));
}

TEST(Manager, UnknownCommandsAreRefused) {
  Nav nav;
  EXPECT_THAT(command(nav.g.graph, "/lifecycle_manager_navigation", {7}), ElementsAre("no, yes"));
}

TEST(Manager, IsNotThereWhenOneComesFromOutside) {
  Nav nav;
  nav.g.graph.settings.external_lifecycle = true;
  Events answers;
  Host host(nav.g.graph, {.clock = ClockMode::lockstep, .accept_inputs = true},
            with(std::make_unique<Panel>("/lifecycle_manager_navigation", std::vector<std::uint8_t>{kStartup},
                                         answers)));
  host.run(Duration::milliseconds(15));
  EXPECT_THAT(answers, ElementsAre("none"));
}

}  // namespace
}  // namespace bw::test
