#include "components/lab/battery/soak.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "components/lab/battery/injection_plan.hpp"
#include "components/lab/battery/launched.hpp"
#include "components/lab/battery/process_growth.hpp"
#include "components/lab/battery/soak_watch.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/host/host.hpp"

namespace bw {
namespace {

constexpr double kWarm = 1200.0;       // [s] until all that is bounded is full: pictures take ten minutes
constexpr double kMostGrowth = 1.0;    // [MB/h]
constexpr double kFaultsApart = 30.0;  // [s] of processes

/// To and fro for as long as it runs, whatever becomes of one goal.
std::vector<std::string> errand() {
  return {"navigator.goal.enabled=false",
          "navigator.goals=[{x: 19.0, y: 0.0, theta: 0.0}, {x: 1.0, y: 0.0, theta: 3.1416}]",
          "navigator.number_of_loops=1000000", "navigator.stop_on_failure=false"};
}

/// Samples of each process by name; one that is started again goes on under the same name.
using Processes = std::map<std::string, std::vector<ProcessSample>>;

class Logbook {
 public:
  Logbook(const SoakOptions& options, double period)
      : out_(options.out), period_(period), count_(std::make_shared<SoakCount>()) {
    std::filesystem::create_directories(out_);
  }

  [[nodiscard]] std::shared_ptr<SoakCount> count() const { return count_; }

  void add(double now, const std::map<std::string, pid_t>& processes) {
    for (const auto& [name, id] : processes) {
      if (const auto sample = sample_process(id, now)) processes_[name].push_back(*sample);
    }
    if (now < said_ + period_) return;
    said_ = now;
    std::cout << line(now) << std::endl;
    write(now, "");
  }

  /// `grows`: the processes that nobody killed.
  bool finish(double now, const std::string& trouble, const std::vector<std::string>& grows) {
    bool is_good = trouble.empty() && count_->caused() == 0 && count_->reached > 0;
    std::cout << line(now) << "\n";
    for (const std::string& name : grows) {
      const auto& samples = processes_[name];
      const double slope = growth(samples, kWarm);
      const Spread flat = spread(samples, kWarm);
      std::cout << fmt::format(
          "{}: {:+.2f} MB/h after {:.0f} minutes, descriptors within {}, threads within {}\n", name, slope,
          kWarm / 60.0, flat.descriptors, flat.threads);
      is_good = is_good && slope <= kMostGrowth && flat.descriptors <= 1 && flat.threads == 0;
    }
    if (!trouble.empty()) std::cout << trouble << "\n";
    write(now, trouble);
    return is_good;
  }

 private:
  [[nodiscard]] std::string line(double now) const {
    int missed = 0, contacts = 0;
    for (const auto& [reason, n] : count_->missed) missed += n;
    for (const auto& [who, n] : count_->contacts) contacts += n;
    std::string text = fmt::format(
        "{:6.2f} h: {} goals reached, {} missed, {:.1f} km; contacts with people {}, that the robot caused {}, "
        "with anything {};",
        now / 3600.0, count_->reached, missed, 1e-3 * count_->path, contacts, count_->caused(),
        count_->touched);
    for (const auto& [name, samples] : processes_)
      text += fmt::format(" {} {:.1f} MB, {} descriptors, {} threads", name, samples.back().rss,
                          samples.back().descriptors, samples.back().threads);
    return text;
  }

  void write(double now, const std::string& trouble) const {
    nlohmann::ordered_json json = {
        {"time_s", now},          {"reached", count_->reached},          {"missed", count_->missed},
        {"path_m", count_->path}, {"caused_contacts", count_->caused()}, {"touched", count_->touched},
        {"trouble", trouble}};
    for (const auto& [who, n] : count_->contacts) json["contacts"][text_of(who)] = n;
    for (const auto& [name, samples] : processes_) {
      for (const ProcessSample& one : samples)
        json["processes"][name].push_back({one.t, one.rss, one.descriptors, one.threads});
    }
    write_file_atomically(out_ / "soak.json", json.dump(2) + "\n");
  }

  std::filesystem::path out_;
  double period_;
  std::shared_ptr<SoakCount> count_;
  Processes processes_;
  double said_ = 0.0;
};

bool soak_a_virtual_day(const SoakOptions& options) {
  Logbook book(options, 3600.0);
  std::vector<std::string> changes = errand();
  if (!options.faults.empty()) changes.push_back("faults=" + options.faults);
  Host* running = nullptr;
  const auto on_minute = [&](double now) {
    book.add(now, {{"all", getpid()}});
    if (cli::interrupted()) running->finish({.ok = true, .reason = "interrupted"}, false);
  };
  std::vector<ExtraComponent> extra;
  extra.push_back({.name = "soak_watch", .component = std::make_unique<SoakWatch>(book.count(), on_minute)});
  Host host(load_graph(kInjectedGraph, changes),
            {.clock = ClockMode::lockstep, .seed = options.seed, .alone = true}, std::move(extra));
  running = &host;
  const RunEnd end = host.run(Duration::seconds(3600.0 * options.hours));
  const double elapsed = host.elapsed_seconds();
  const bool is_over = elapsed >= 3600.0 * options.hours - 60.0;
  return book.finish(elapsed, is_over ? "" : "ended early: " + end.reason, {"all"}) && is_over;
}

bool soak_in_real_time(const SoakOptions& options) {
  Logbook book(options, 600.0);
  const double longest = 3600.0 * options.hours;
  const InjectionPlan plan{
      .processes = processes_that_come_back(), .first = kFaultsApart, .apart = kFaultsApart, .within = 10.0};
  const auto count = static_cast<int>(longest / kFaultsApart) - 1;
  const std::filesystem::path faults = std::filesystem::absolute(options.out / "faults.yaml");
  write_file_atomically(faults, faults_text(injections_of(plan, options.seed, count), plan));
  std::vector<std::string> words = {fmt::format("--seed={}", options.seed), "--stay",
                                    "--set=faults=" + faults.string()};
  for (const std::string& change : errand()) words.push_back("--set=" + change);
  Launched launched(kInjectedGraph, words, options.out / "logs");
  std::string trouble;
  Host* running = nullptr;
  const auto on_minute = [&](double now) {
    std::map<std::string, pid_t> processes = launched.processes();
    processes["launch"] = launched.id();
    book.add(now, processes);
    if (!launched.wait(0.0) && !cli::interrupted()) return;
    if (!cli::interrupted()) trouble = "the launch ended by itself:\n" + launched.log();
    running->finish({.ok = true, .reason = "over"}, false);
  };
  Graph nobody = load_graph(kInjectedGraph);
  nobody.components.clear();
  std::vector<ExtraComponent> extra;
  extra.push_back({.name = "soak_watch", .component = std::make_unique<SoakWatch>(book.count(), on_minute)});
  Host host(std::move(nobody), {.is_partial = true}, std::move(extra));
  running = &host;
  host.run(Duration::seconds(longest));
  launched.interrupt();
  if (!launched.wait(30.0)) trouble += "the launch did not end";
  return book.finish(host.elapsed_seconds(), trouble, {"world+base", "launch"});
}

}  // namespace

bool soak(const SoakOptions& options) {
  cli::catch_interrupts();
  return options.is_real ? soak_in_real_time(options) : soak_a_virtual_day(options);
}

}  // namespace bw
