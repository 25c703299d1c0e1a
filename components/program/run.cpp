#include "components/program/run.hpp"

#include <atomic>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "components/program/run_observer.hpp"
#include "components/program/score_card_json.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/host/host.hpp"

namespace bw {
namespace {

struct RunOptions {
  std::string graph;
  std::string clock = "wall";
  std::uint64_t seed = 1;
  std::vector<std::string> set;
  std::string only;
  double for_s = 0.0;
  double pace = 0.0;
  std::string json;
  std::string svg;
  bool progress = false;
  bool fail_on_contact = false;
};

ClockMode clock_mode(const std::string& name) {
  return name == "lockstep" ? ClockMode::lockstep : name == "topic" ? ClockMode::topic : ClockMode::wall;
}

const ComponentNode* find_type(const Graph& graph, const std::string& type, const std::string& only) {
  for (const ComponentNode& node : graph.components) {
    if (node.type == type && (only.empty() || node.process == only)) return &node;
  }
  return nullptr;
}

/// The planner's own name, from the parameter that selects it.
std::string algorithm_of(const Host& host, const std::string& component) {
  for (const auto& [name, report] : host.parameters()) {
    if (name != component) continue;
    for (const ParameterRow& row : report.rows) {
      if (row.name == "algorithm") return row.value;
    }
  }
  return component;
}

double planner_median_ms(const Host& host, const std::string& component) {
  for (const CallbackStatistics& s : host.statistics()) {
    if (s.component == component && s.callback == "control_cycle") return s.run.quantile_ms(0.5);
  }
  return 0.0;
}

/// Asks the host to end when a person does.
class InterruptWatch {
 public:
  explicit InterruptWatch(Host& host)
      : thread_([this, &host] {
          while (!done_) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            if (!cli::interrupted()) continue;
            host.finish({.ok = true, .reason = "interrupted"}, false);
            return;
          }
        }) {}
  ~InterruptWatch() {
    done_ = true;
    thread_.join();
  }
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

int run(const RunOptions& options) {
  Graph graph = load_graph(options.graph, options.set);
  const ComponentNode* evaluation = find_type(graph, "evaluation", options.only);
  const ComponentNode* planner = find_type(graph, "local_planner", options.only);
  const std::string planner_name = planner == nullptr ? "" : planner->name;
  std::vector<std::string> set = options.set;
  if (evaluation != nullptr && !options.svg.empty()) {
    set.push_back(evaluation->name + ".svg=" + std::filesystem::absolute(options.svg).string());
    graph = load_graph(options.graph, set);
    evaluation = find_type(graph, "evaluation", options.only);
  }

  auto seen = std::make_shared<Observation>();
  Host* running = nullptr;
  std::vector<ExtraComponent> extra;
  if (evaluation != nullptr) {
    extra.push_back({"run_observer",
                     std::make_unique<RunObserver>(seen, options.progress || isatty(STDERR_FILENO) != 0, [&] {
                       return running == nullptr ? 0.0 : planner_median_ms(*running, planner_name);
                     })});
  }
  const bool judged = evaluation != nullptr;
  Host host(std::move(graph),
            {.clock = clock_mode(options.clock),
             .seed = options.seed,
             .only_process = options.only,
             .pace = options.pace},
            std::move(extra));
  running = &host;
  cli::catch_interrupts();
  const InterruptWatch watch(host);
  const Duration started = steady_time();
  const RunEnd end =
      host.run(options.for_s > 0.0 ? std::optional(Duration::seconds(options.for_s)) : std::nullopt);
  const double real_s = (steady_time() - started).to_seconds();

  const RunFacts facts{.graph = options.graph,
                       .seed = options.seed,
                       .planner_component = planner_name,
                       .planner_name = planner_name.empty() ? "" : algorithm_of(host, planner_name),
                       .realtime_factor = host.elapsed_seconds() / real_s,
                       .samples_sha256 = host.samples_sha256(),
                       .end_reason = end.reason};
  const nlohmann::json json = to_json(seen->card, facts, host.statistics());
  if (!options.json.empty()) write_file_atomically(options.json, json.dump(2) + "\n");
  if (!judged) return end.ok ? 0 : 1;
  std::cout << in_words(json);
  const bool contact = seen->card && seen->card->collisions() > 0;
  return json.value("reached", false) && !(options.fail_on_contact && contact) ? 0 : 1;
}

}  // namespace

void add_run(CLI::App& app, int& status) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb = app.add_subcommand("run", "Runs a graph, or one process of it");
  verb->add_option("GRAPH", options->graph, "Graph file")->required();
  verb->add_option("--clock", options->clock,
                   "wall, lockstep (virtual time, repeatable) or topic (/clock from outside)")
      ->check(CLI::IsMember({"wall", "lockstep", "topic"}));
  verb->add_option("--seed", options->seed, "Of everything random");
  verb->add_option("--set", options->set, "component.param=value, as often as needed")
      ->allow_extra_args(false);
  verb->add_option("--only", options->only, "Only this process of the graph");
  verb->add_option("--for", options->for_s, "Ends after so many seconds of the component clock")
      ->check(CLI::PositiveNumber);
  verb->add_option("--pace", options->pace,
                   "Lock-step: virtual seconds per real second; 0 as fast as possible")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--json", options->json, "Writes the score card here");
  verb->add_option("--svg", options->svg, "Writes a picture of the run here");
  verb->add_flag("--progress", options->progress, "Progress line even when stderr is no terminal");
  verb->add_flag("--fail-on-contact", options->fail_on_contact, "Exit status 1 after any contact");
  verb->callback([options, &status] { status = run(*options); });
}

}  // namespace bw
