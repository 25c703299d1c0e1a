// The project's side of an action, as a process of its own, for tests that sit on the other side:
//   action_graph serve DISTRO [topic]   a node `server` with the scripted actions /together, /preempting (NavigateToPose) and
//                                       /follow (FollowPath), in the layouts of a distribution; `topic`: on
//                                       the time of /clock
//   action_graph call DISTRO            a node `caller` that sends goals to /plain one after the other and prints what becomes
//                                       of each
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "components/messages/nav2_layouts.hpp"
#include "runtime/action_client.hpp"
#include "runtime/host/host.hpp"
#include "tests/runtime/scripted.hpp"
#include "tests/runtime/scripted_actions.hpp"

namespace bw::test {
namespace {

void serve(Setup& setup) {
  with_nav2_layout(setup.ros_distro(), [&](auto layout) {
    using Nav2 = decltype(layout);
    ScriptedActions<typename Nav2::NavigateToPose>::offer(setup, "together", Policy::together);
    ScriptedActions<typename Nav2::NavigateToPose>::offer(setup, "preempting", Policy::preempting);
    ScriptedActions<typename Nav2::FollowPath>::offer(setup, "follow", Policy::preempting);
  });
}

/// Goals `end`, `cancel`, `refuse`, `abort`, `leave`: the text says to the other side what to do with each.
/// `cancel` is canceled at its first feedback.
template <class A>
class Caller {
 public:
  static void run(Setup& setup) {
    auto self = std::make_shared<Caller>();
    self->client_ = setup.action_client<A>("/plain", Need::optional);
    setup.every(Duration::milliseconds(10), "next", [self, finish = setup.finish_run()](const Tick&) {
      if (self->is_waiting_) return;
      if (self->next_ == self->words_.size()) return finish(true, "all goals are over");
      self->send(self, self->words_[self->next_++]);
    });
  }

 private:
  void send(const std::shared_ptr<Caller>& self, const std::string& word) {
    is_waiting_ = true;
    typename A::Goal goal;
    goal.pose().header().frame_id("map");
    goal.pose().pose().position().x(2.5);
    goal.pose().pose().orientation().w(1.0);
    goal.behavior_tree(word);
    GoalCallbacks<A> callbacks;
    auto id = std::make_shared<GoalId>();
    callbacks.on_acknowledged = [self, word](bool is_accepted, const Tick&) {
      print(word, is_accepted ? "accepted" : "refused");
      if (!is_accepted) self->is_waiting_ = false;
    };
    callbacks.on_feedback = [self, word, id](const typename A::Feedback& feedback, const Tick&) {
      print(word, "feedback " + std::to_string(static_cast<int>(feedback.distance_remaining())));
      if (word == "cancel") self->client_.cancel(*id);
    };
    callbacks.on_result = [self, word](GoalStatus status, const typename A::Result* result, const Tick&) {
      std::string text = "status " + std::to_string(static_cast<int>(status));
      if (result == nullptr) text += " without a result";
      if constexpr (requires { result->error_code(); }) {
        if (result != nullptr) text += " " + std::to_string(result->error_code()) + " " + result->error_msg();
      }
      print(word, text);
      self->is_waiting_ = false;
    };
    *id = client_.send(goal, Duration::seconds(20.0), std::move(callbacks));
  }
  static void print(const std::string& word, const std::string& text) {
    std::printf("%s: %s\n", word.c_str(), text.c_str());
    std::fflush(stdout);
  }

  ActionClient<A> client_;
  std::vector<std::string> words_ = {"end", "cancel", "refuse", "abort", "leave"};
  std::size_t next_ = 0;
  bool is_waiting_ = false;
};

int run(const std::string& role, const std::string& distro, bool on_topic) {
  Graph graph;
  graph.settings.ros_distro = distro_named(distro).value();
  if (role == "serve") {
    graph.components.push_back(scripted({.name = "server"}, serve));
  } else {
    graph.components.push_back(scripted({.name = "caller"}, [](Setup& setup) {
      with_nav2_layout(setup.ros_distro(),
                       [&](auto layout) { Caller<typename decltype(layout)::NavigateToPose>::run(setup); });
    }));
  }
  // Ended from outside by SIGTERM, even where time stands still.
  sigset_t end;
  sigemptyset(&end);
  sigaddset(&end, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &end, nullptr);
  Host host(graph, {.clock = on_topic ? ClockMode::topic : ClockMode::wall});
  std::thread ending([&] {
    int signal = 0;
    sigwait(&end, &signal);
    host.finish({.ok = true, .reason = "asked to end"}, true);
  });
  const bool is_ok = host.run(std::nullopt).ok;
  pthread_kill(ending.native_handle(), SIGTERM);
  ending.join();
  return is_ok ? 0 : 1;
}

}  // namespace
}  // namespace bw::test

int main(int argc, char** argv) { return argc >= 3 ? bw::test::run(argv[1], argv[2], argc == 4) : 2; }
