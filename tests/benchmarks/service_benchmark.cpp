// What services cost. The round trip of a call between two components, from Client::call to the callback with
// the response: in one process and across two, on lanes of their own, at rest (1 kHz) and one call after the
// other. Compare with `benchmark_executor`, whose messages go one way. And nodes that do nothing but offer
// the services that every node has: processor and memory of a process with 12 of them, and with none.
//   benchmark_service [--json FILE]
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/base/quantile.hpp"
#include "runtime/host/host.hpp"
#include "runtime/process_memory.hpp"

namespace bw {
namespace {

using std_srvs::srv::Trigger;

class Server final : public Component {
 public:
  void configure(Setup& setup) override {
    setup.service<Trigger>("ask", [](const Trigger::Request&, const Tick&) {
      Trigger::Response response;
      response.success(true);
      return response;
    });
  }
};

/// `at_rest`: a call each millisecond; else the next when the last has been answered.
class Caller final : public Component {
 public:
  Caller(std::size_t count, bool at_rest, std::vector<double>& round_trips_us)
      : count_(count), at_rest_(at_rest), round_trips_us_(round_trips_us) {}

  void configure(Setup& setup) override {
    client_ = setup.client<Trigger>("ask", Need::optional);
    finish_ = setup.finish_run();
    setup.every(Duration::milliseconds(1), "call", [this](const Tick&) {
      if (!client_.is_ready() || is_waiting_) return;
      if (at_rest_ || !is_started_) call();
    });
  }

 private:
  void call() {
    is_started_ = is_waiting_ = true;
    client_.call({}, Duration::seconds(1.0),
                 [this, sent = steady_time()](const Trigger::Response* response, const Tick&) {
                   is_waiting_ = false;
                   if (response == nullptr) return finish_(false, "a call was lost");
                   round_trips_us_.push_back(1e6 * (steady_time() - sent).to_seconds());
                   if (round_trips_us_.size() == count_) return finish_(true, "done");
                   if (!at_rest_) call();
                 });
  }

  std::size_t count_;
  bool at_rest_;
  std::vector<double>& round_trips_us_;
  Client<Trigger> client_;
  std::function<void(bool, const std::string&)> finish_;
  bool is_started_ = false;
  bool is_waiting_ = false;
};

std::vector<double> call(std::vector<ExtraComponent> components, std::size_t count, bool at_rest) {
  std::vector<double> round_trips_us;
  components.push_back({"caller", std::make_unique<Caller>(count, at_rest, round_trips_us), "caller"});
  Host host(Graph{}, {.clock = ClockMode::wall}, std::move(components));
  const RunEnd end = host.run(Duration::seconds(60.0));
  if (!end.ok || round_trips_us.size() != count) {
    throw std::runtime_error(std::to_string(round_trips_us.size()) + " calls: " + end.reason);
  }
  return round_trips_us;
}

std::vector<ExtraComponent> server(const std::string& lane) {
  std::vector<ExtraComponent> components;
  components.push_back({"server", std::make_unique<Server>(), lane});
  return components;
}

/// What `measure` returns, in a process of its own. Forks: before this process has threads.
template <class Measure>
std::vector<double> in_a_process(std::size_t count, Measure measure) {
  int pipes[2];
  if (pipe(pipes) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    const std::vector<double> measured = measure();
    const ssize_t written = write(pipes[1], measured.data(), measured.size() * sizeof(double));
    _exit(written > 0 ? 0 : 1);
  }
  close(pipes[1]);
  std::vector<double> measured(count);
  char* to = reinterpret_cast<char*>(measured.data());
  std::size_t left = count * sizeof(double);
  for (ssize_t size = 0; left > 0 && (size = read(pipes[0], to, left)) > 0;) {
    to += size;
    left -= static_cast<std::size_t>(size);
  }
  close(pipes[0]);
  waitpid(child, nullptr, 0);
  if (left > 0) throw std::runtime_error("a process ended early");
  return measured;
}

std::vector<double> across(std::size_t count, bool at_rest) {
  const pid_t child = fork();
  if (child == 0) {
    Host host(Graph{}, {.clock = ClockMode::wall}, server("server"));
    host.run(Duration::seconds(120.0));
    _exit(0);
  }
  std::vector<double> round_trips_us = in_a_process(count, [&] { return call({}, count, at_rest); });
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
  return round_trips_us;
}

double cpu_seconds() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

class Nothing final : public Component {
  void configure(Setup&) override {}
};

BW_COMPONENT(Nothing, "nothing")

/// Percent of a core, and MB, of a process with so many idle nodes.
std::vector<double> idle(int nodes) {
  Graph graph;
  for (int i = 0; i < nodes; ++i)
    graph.components.push_back({.name = "node" + std::to_string(i), .type = "nothing"});
  Host host(graph, {.clock = ClockMode::wall});
  std::vector<double> measured;
  std::thread measuring([&] {
    constexpr double kSeconds = 10.0;
    std::this_thread::sleep_for(std::chrono::seconds(2));  // set-up is not idleness
    const double before = cpu_seconds();
    std::this_thread::sleep_for(std::chrono::duration<double>(kSeconds));
    measured = {100.0 * (cpu_seconds() - before) / kSeconds, memory_mb()};
    host.finish({.ok = true, .reason = "measured"}, true);
  });
  host.run(std::nullopt);
  measuring.join();
  return measured;
}

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  constexpr std::size_t kCount = 5000;
  nlohmann::ordered_json json;
  const auto report = [&](const std::string& name, const std::vector<double>& us) {
    const double median = bw::quantile(us, 0.5), p99 = bw::quantile(us, 0.99);
    std::printf("%-44s median %6.1f us  p99 %7.1f us  (%zu calls)\n", name.c_str(), median, p99, us.size());
    json[name] = {{"median_us", median}, {"p99_us", p99}, {"calls", us.size()}};
  };
  for (const int nodes : {0, 12}) {
    const std::vector<double> idle = bw::in_a_process(2, [nodes] { return bw::idle(nodes); });
    std::printf("%2d idle nodes: %.2f %% of a core, %.1f MB\n", nodes, idle[0], idle[1]);
    json["idle_nodes_" + std::to_string(nodes)] = {{"cpu_percent", idle[0]}, {"memory_mb", idle[1]}};
  }
  report("two processes, 1 kHz", bw::across(kCount, true));
  report("two processes, one after the other", bw::across(kCount, false));
  report("one process, 1 kHz", bw::call(bw::server("server"), kCount, true));
  report("one process, one after the other", bw::call(bw::server("server"), kCount, false));
  report("one process, one lane, one after the other", bw::call(bw::server("caller"), kCount, false));
  if (argc == 3 && std::string(argv[1]) == "--json") std::ofstream(argv[2]) << json.dump(2) << "\n";
  return 0;
}
