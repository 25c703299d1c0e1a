// What actions cost. How long a client waits for the acknowledgement of a goal, and for the answer to its
// cancel, while the component that serves them computes: by itself, and with every core taken by other
// components besides. The client is a process of its own; Nav2's behavior tree waits 20 ms. And processor
// time and memory of nodes that do nothing but offer actions, beside as many that offer none.
//   benchmark_action [--json FILE]
//   benchmark_action --against ACTION      the same latencies of a navigate_to_pose server that runs on the domain: it will drive
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/base/quantile.hpp"
#include "runtime/host/host.hpp"
#include "runtime/process_memory.hpp"

namespace bw {
namespace {

using action_msgs::srv::CancelGoal;
using nav2_msgs::action::NavigateToPose;

/// Computes for `time`, as a planner does.
void compute(Duration time) {
  volatile double sum = 0.0;
  for (const Duration end = steady_time() + time; steady_time() < end;) {
    for (int i = 0; i < 1000; ++i) sum = sum + 1.0 / (1.0 + i);
  }
}

/// Takes its lane for 40 ms, over and over; goals and cancels get their turns in between.
class Planner final : public Component {
 public:
  explicit Planner(bool has_action) : has_action_(has_action) {}
  void configure(Setup& setup) override {
    setup.every(Duration::milliseconds(1), "plan", [](const Tick&) { compute(Duration::milliseconds(40)); });
    if (!has_action_) return;
    setup.action<NavigateToPose>(
        "navigate_to_pose",
        {.on_goal = [](const GoalHandle<NavigateToPose>& goal, const Tick&) { goal.execute(); },
         .on_cancel = [](const GoalHandle<NavigateToPose>& goal, const Tick&) { goal.canceled({}); },
         .abandoned = [](const std::string&) { return NavigateToPose::Result(); }});
  }

 private:
  bool has_action_;
};

/// Sends a goal, cancels it when it is acknowledged, and sends the next 20 ms after the answer.
class Caller final : public Component {
 public:
  Caller(std::string action, std::size_t count, std::vector<double>& waits_ms)
      : action_(std::move(action)), count_(count), waits_ms_(waits_ms) {}

  void configure(Setup& setup) override {
    client_ = setup.action_client<NavigateToPose>(action_, Need::optional);
    cancel_ = setup.client<CancelGoal>(action_ + "/_action/cancel_goal", Need::optional);
    finish_ = setup.finish_run();
    setup.every(Duration::milliseconds(20), "send", [this](const Tick&) {
      if (client_.is_ready() && cancel_.is_ready() && !is_waiting_) send();
    });
  }

 private:
  void send() {
    is_waiting_ = true;
    NavigateToPose::Goal goal;
    goal.pose().header().frame_id("map");
    goal.pose().pose().orientation().w(1.0);
    GoalCallbacks<NavigateToPose> callbacks;
    callbacks.on_acknowledged = [this, sent = steady_time()](bool accepted, const Tick&) {
      if (!accepted) return finish_(false, "a goal was not accepted");
      note(sent);
      cancel();
    };
    id_ = client_.send(goal, Duration::seconds(5.0), std::move(callbacks));
  }
  void cancel() {
    CancelGoal::Request request;
    request.goal_info().goal_id().uuid(id_);
    cancel_.call(request, Duration::seconds(5.0),
                 [this, sent = steady_time()](const CancelGoal::Response* response, const Tick&) {
                   if (response == nullptr) return finish_(false, "a cancel was not answered");
                   note(sent);
                   is_waiting_ = false;
                   if (waits_ms_.size() >= 2 * count_) finish_(true, "done");
                 });
  }
  /// Of goal, cancel, goal, cancel ...
  void note(Duration sent) { waits_ms_.push_back(1e3 * (steady_time() - sent).to_seconds()); }

  std::string action_;
  std::size_t count_;
  std::vector<double>& waits_ms_;
  ActionClient<NavigateToPose> client_;
  Client<CancelGoal> cancel_;
  std::function<void(bool, const std::string&)> finish_;
  GoalId id_{};
  bool is_waiting_ = false;
};

std::vector<double> call(const std::string& action, std::size_t count) {
  std::vector<double> waits_ms;
  std::vector<ExtraComponent> components;
  components.push_back({"caller", std::make_unique<Caller>(action, count, waits_ms)});
  Host host(Graph{}, {.clock = ClockMode::wall}, std::move(components));
  const RunEnd end = host.run(Duration::seconds(600.0));
  if (!end.ok || waits_ms.size() != 2 * count)
    throw std::runtime_error(std::to_string(waits_ms.size()) + " answers: " + end.reason);
  return waits_ms;
}

/// With `others` more planners on lanes of their own. Forks: before this process has threads.
std::vector<double> beside_planners(std::size_t count, unsigned others) {
  const pid_t child = fork();
  if (child == 0) {
    std::vector<ExtraComponent> components;
    components.push_back({"planner", std::make_unique<Planner>(true), "planner"});
    for (unsigned i = 0; i < others; ++i) {
      const std::string name = "other" + std::to_string(i);
      components.push_back({name, std::make_unique<Planner>(false), name});
    }
    Host host(Graph{}, {.clock = ClockMode::wall}, std::move(components));
    host.run(std::nullopt);
    _exit(0);
  }
  int pipes[2];
  if (pipe(pipes) != 0) throw std::runtime_error("no pipe");
  const pid_t caller = fork();
  if (caller == 0) {
    const std::vector<double> waits_ms = call("navigate_to_pose", count);
    const char* from = reinterpret_cast<const char*>(waits_ms.data());
    std::size_t left = waits_ms.size() * sizeof(double);
    for (ssize_t size = 0; left > 0 && (size = write(pipes[1], from, left)) > 0;) {
      from += size;
      left -= static_cast<std::size_t>(size);
    }
    _exit(0);
  }
  close(pipes[1]);
  std::vector<double> waits_ms(2 * count);
  char* to = reinterpret_cast<char*>(waits_ms.data());
  std::size_t left = waits_ms.size() * sizeof(double);
  for (ssize_t size = 0; left > 0 && (size = read(pipes[0], to, left)) > 0;) {
    to += size;
    left -= static_cast<std::size_t>(size);
  }
  close(pipes[0]);
  waitpid(caller, nullptr, 0);
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
  if (left > 0) throw std::runtime_error("the caller ended early");
  return waits_ms;
}

class Idle final : public Component {
 public:
  explicit Idle(bool has_action) : has_action_(has_action) {}
  void configure(Setup& setup) override {
    if (!has_action_) return;
    setup.action<NavigateToPose>("~/act",
                                 {.on_goal = [](const GoalHandle<NavigateToPose>&, const Tick&) {},
                                  .on_cancel = [](const GoalHandle<NavigateToPose>&, const Tick&) {},
                                  .abandoned = [](const std::string&) { return NavigateToPose::Result(); }});
  }

 private:
  bool has_action_;
};

struct Cost {
  double cpu_percent = 0.0;
  double memory_mb = 0.0;
};

/// Of a process with ten idle nodes, each with an action or without, over `seconds`.
Cost idle(bool with_actions, double seconds) {
  const pid_t child = fork();
  if (child == 0) {
    std::vector<ExtraComponent> components;
    for (int i = 0; i < 10; ++i)
      components.push_back({"node" + std::to_string(i), std::make_unique<Idle>(with_actions)});
    Host host(Graph{}, {.clock = ClockMode::wall}, std::move(components));
    host.run(std::nullopt);
    _exit(0);
  }
  const std::string folder = "/proc/" + std::to_string(child);
  const auto cpu_seconds = [&] {
    std::ifstream file(folder + "/stat");
    std::string skipped;
    for (int i = 0; i < 13; ++i) file >> skipped;
    double user = 0.0, system = 0.0;
    file >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  };
  std::this_thread::sleep_for(std::chrono::seconds(3));  // set-up is not idleness
  const double before = cpu_seconds();
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const Cost cost{100.0 * (cpu_seconds() - before) / seconds, memory_mb(std::to_string(child))};
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
  return cost;
}

void report(const std::string& name, const std::vector<double>& waits_ms, nlohmann::ordered_json& json) {
  for (std::size_t kind = 0; kind < 2; ++kind) {
    std::vector<double> ms;
    for (std::size_t i = kind; i < waits_ms.size(); i += 2) ms.push_back(waits_ms[i]);
    const double p50 = quantile(ms, 0.5), p99 = quantile(ms, 0.99), p999 = quantile(ms, 0.999);
    const double longest = *std::ranges::max_element(ms);
    const std::string what = name + (kind == 0 ? ", goals" : ", cancels");
    std::printf("%-52s p50 %6.2f ms  p99 %6.2f ms  p99.9 %6.2f ms  longest %6.2f ms  (%zu)\n", what.c_str(),
                p50, p99, p999, longest, ms.size());
    json[what] = {
        {"p50_ms", p50}, {"p99_ms", p99}, {"p999_ms", p999}, {"longest_ms", longest}, {"count", ms.size()}};
  }
}

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  constexpr std::size_t kCount = 2000;
  nlohmann::ordered_json json;
  if (argc == 3 && std::string(argv[1]) == "--against") {
    bw::report(argv[2], bw::call(argv[2], kCount), json);
    return 0;
  }
  const double seconds = 20.0;
  for (const bool with_actions : {false, true}) {
    const bw::Cost cost = bw::idle(with_actions, seconds);
    std::printf("ten idle nodes, %s: %.2f %% of a core, %.1f MB\n",
                with_actions ? "an action each" : "no actions", cost.cpu_percent, cost.memory_mb);
    json[with_actions ? "idle_with_actions" : "idle_without"] = {{"cpu_percent", cost.cpu_percent},
                                                                 {"memory_mb", cost.memory_mb}};
  }
  const unsigned cores = std::thread::hardware_concurrency();
  bw::report("its planner computes", bw::beside_planners(kCount, 0), json);
  bw::report("a planner for each core besides", bw::beside_planners(kCount, cores), json);
  if (argc == 3 && std::string(argv[1]) == "--json") std::ofstream(argv[2]) << json.dump(2) << "\n";
  return 0;
}
