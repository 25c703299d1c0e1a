// `bandwagon explore`: has the robot make its map by itself, tells how it fares, and stops it on Ctrl-C.
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/string.hpp>

#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/ros/notifier.hpp"
#include "runtime/ros/typed_topic.hpp"

namespace bw {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kAgain = std::chrono::seconds(1);      // until it is said again
constexpr auto kPatience = std::chrono::seconds(10);  // for somebody who explores
constexpr auto kToStop = std::chrono::seconds(5);

class Exploring {
 public:
  explicit Exploring(const std::string& ns)
      : participant_({.network = dds::Network::from_environment(dds::Transport::localhost)}),
        resume_(participant_, join_namespaces(ns, "explore/resume"), Qos::standard()),
        status_(participant_, join_namespaces(ns, "explore/status"), Qos::latched(),
                [this] { notifier_.ring(); }) {}

  /// Until it is complete, somebody else stops it, or Ctrl-C does; the exit status.
  int run() {
    if (!tell(true, "exploration_paused", kPatience)) {
      std::cerr << (last_.empty() ? "Nobody explores: bringup.sh ROBOT.yaml --slam has who does\n"
                                  : "It does not begin: " + last_ + "\n");
      return 1;
    }
    while (!cli::interrupted()) {
      hear(Clock::now() + kAgain);
      if (last_.starts_with("exploration_complete")) return 0;
      if (last_.starts_with("exploration_paused")) return 1;
    }
    std::cout << "Stopping ..." << std::endl;
    if (!tell(false, "exploration_in_progress", kToStop))
      std::cerr << "It does not say that it stopped: use the emergency stop\n";
    return 1;
  }

 private:
  /// Says so until the status is another than `before`; false when it stays that.
  bool tell(bool go, const std::string& before, Clock::duration patience) {
    std_msgs::msg::Bool message;
    message.data(go);
    for (const auto end = Clock::now() + patience; Clock::now() < end;) {
      if (go && cli::interrupted()) return false;
      if (resume_.readers() > 0 && !last_.empty()) resume_.publish(message);
      hear(Clock::now() + kAgain);
      const bool is_returning = last_.starts_with("returning_to_origin");
      if (!last_.empty() && !last_.starts_with(before) && (go || !is_returning)) return true;
    }
    return false;
  }

  void hear(Clock::time_point end) {
    notifier_.wait(end);
    while (const auto message = status_.take()) {
      if (message->data() == last_) continue;
      last_ = message->data();
      std::cout << last_ << std::endl;
    }
  }

  Notifier notifier_;
  dds::Participant participant_;
  TopicWriter<std_msgs::msg::Bool> resume_;
  TopicReader<std_msgs::msg::String> status_;
  std::string last_;
};

void add_explore(cli::Verb verb) {
  auto ns = std::make_shared<std::string>();
  verb.option("--namespace", *ns, "Of the robot, among several");
  verb.run([ns] {
    cli::catch_interrupts();
    return Exploring(join_namespaces("/", *ns)).run();
  });
}

BW_VERB(drive, "explore",
        "The robot drives about until its map is closed; Ctrl-C stops it. Exit status 0 when it is complete",
        add_explore)

}  // namespace
}  // namespace bw
