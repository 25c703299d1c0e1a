// Components that follow another's states, in lock-step: orders are those of Nav2's servers, which configure
// and activate the costmap inside them first and stop it last.
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/lifecycle/scripted_graph.hpp"

namespace bw::test {
namespace {

using testing::ElementsAre;

/// A server with a costmap and a detector behind it.
struct Server {
  Events events;
  ScriptedGraph g;
  Server() {
    add({.name = "server"});
    add({.name = "costmap", .follows = "server"});
    add({.name = "people", .follows = "server"});
  }
  void add(ComponentNode node) {
    const std::string name = node.name;
    g.add(std::move(node), [this, name] { return talker(events, name); });
  }
  Events answers_to(std::vector<Asker::Request> requests) { return run(g.graph, 0.1, std::move(requests)); }
};

TEST(Followers, ComeUpFirstAndGoDownLastWithTheirLeader) {
  Server s;
  EXPECT_THAT(s.answers_to({{10, "server", "deactivate"},
                            {20, "server", "cleanup"},
                            {30, "server", "configure"},
                            {40, "server", "activate"},
                            {50, "server", "shutdown"}}),
              ElementsAre("deactivate server: ok", "cleanup server: ok", "configure server: ok",
                          "activate server: ok", "shutdown server: ok"));
  EXPECT_THAT(s.events,
              ElementsAre("configure server", "configure costmap", "configure people",  // as they are loaded
                          "activate costmap", "activate people", "activate server",     //
                          "deactivate server", "deactivate people", "deactivate costmap", "cleanup server",
                          "cleanup people", "cleanup costmap",                          //
                          "configure costmap", "configure people", "configure server",  //
                          "activate costmap", "activate people", "activate server",     //
                          "deactivate server", "deactivate people", "deactivate costmap", "cleanup server",
                          "cleanup people", "cleanup costmap"));
}

TEST(Followers, NobodyStaysFartherUpThanALeaderThatFails) {
  const std::vector<Asker::Request> down = {{10, "server", "deactivate"}, {11, "server", "cleanup"}};
  const auto after = [&](const std::string& failing, std::vector<Asker::Request> up) {
    // The same call succeeds as the run comes up, so it fails from the second time on.
    int times = 0;
    ScriptedGraph g;
    Events events;
    for (const char* name : {"server", "costmap"}) {
      g.add(ComponentNode{.name = name, .follows = std::string(name) == "costmap" ? "server" : ""},
            [&, name = std::string(name)] {
              const auto step = [&, name](const std::string& what) {
                events.push_back(what + " " + name);
                if (failing == events.back() && ++times == 2) throw std::runtime_error("told to");
              };
              return Script{.configure = [step](bw::Setup&) { step("configure"); },
                            .activate = [step](const Tick&) { step("activate"); },
                            .deactivate = [step](const Tick&) { step("deactivate"); },
                            .cleanup = [step] { step("cleanup"); }};
            });
    }
    std::vector<Asker::Request> requests = down;
    requests.insert(requests.end(), up.begin(), up.end());
    Events answers = run(g.graph, 0.1, requests);
    const auto begin = std::ranges::find(events, "cleanup costmap") + 1;
    return std::pair(Events(answers.begin() + 2, answers.end()), Events(begin, events.end()));
  };
  const auto configure = after("configure server", {{20, "server", "configure"}});
  EXPECT_THAT(configure.first, ElementsAre("configure server: no"));
  EXPECT_THAT(configure.second, ElementsAre("configure costmap", "configure server", "cleanup costmap"));

  const auto activate = after("activate server", {{20, "server", "configure"}, {30, "server", "activate"}});
  EXPECT_THAT(activate.first, ElementsAre("configure server: ok", "activate server: no"));
  EXPECT_THAT(activate.second, ElementsAre("configure costmap", "configure server", "activate costmap",
                                           "activate server", "deactivate costmap",
                                           // the run's end
                                           "cleanup server", "cleanup costmap"));

  const auto follower = after("activate costmap", {{20, "server", "configure"}, {30, "server", "activate"}});
  EXPECT_THAT(follower.first, ElementsAre("configure server: ok", "activate server: no"));
  EXPECT_THAT(follower.second, ElementsAre("configure costmap", "configure server", "activate costmap",
                                           "cleanup server", "cleanup costmap"));
}

TEST(Followers, MayBeAskedThemselves) {
  Server s;
  EXPECT_THAT(s.answers_to({{10, "costmap", "deactivate"}, {20, "costmap", "activate"}}),
              ElementsAre("deactivate costmap: ok", "activate costmap: ok"));
}

}  // namespace
}  // namespace bw::test
