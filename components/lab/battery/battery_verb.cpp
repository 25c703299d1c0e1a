// bandwagon-lab battery, injections, loops and soak.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "components/lab/battery/battery.hpp"
#include "components/lab/battery/injections.hpp"
#include "components/lab/battery/loops.hpp"
#include "components/lab/battery/soak.hpp"
#include "components/lab/shards/child_pool.hpp"
#include "components/lab/shards/kept.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/own_program.hpp"

namespace bw {
namespace {

namespace fs = std::filesystem;

struct BatteryOptions {
  fs::path table = "tests/README.md";
  fs::path programs;
  fs::path out = "battery";
  std::string rows;
  int trials = 0;
  bool real_time = false;
};

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

int run_one(const std::vector<std::string>& command, const fs::path& log) {
  return run_children({{.name = command.front(), .command = command, .log = log}}, 1, cli::interrupted,
                      [](const ChildProgress&) {})
      .front();
}

/// Tests by program, of those that are built.
std::map<std::string, std::vector<std::string>> tests_of(const fs::path& programs, const fs::path& folder) {
  constexpr int kAtOnce = 8;  // each is a moment's work
  std::vector<ChildJob> jobs;
  for (const auto& entry : fs::directory_iterator(programs)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("test_"))
      jobs.push_back({.name = name,
                      .command = {entry.path().string(), "--gtest_list_tests"},
                      .log = folder / (name + ".txt")});
  }
  const std::vector<int> statuses =
      run_children(jobs, kAtOnce, cli::interrupted, [](const ChildProgress&) {});
  std::map<std::string, std::vector<std::string>> tests;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (statuses[i] == 0) tests[jobs[i].name] = tests_listed(content(jobs[i].log));
  }
  return tests;
}

/// With its path and the repetitions; empty: it is not built.
std::vector<std::string> command_line(const BatteryCommand& command, const BatteryOptions& options,
                                      int trials) {
  std::vector<std::string> words = command.words;
  words.front() = (options.programs / words.front()).string();
  if (!fs::exists(words.front())) return {};
  for (std::string& word : words) {
    if (word == "{n}") word = std::to_string(trials);
  }
  if (command.words.front() == "bandwagon-lab") {
    words.insert(words.end(), {"--out", (options.out / fmt::format("row_{}", command.row)).string()});
  }
  // What is no test program has no domain of its own.
  const fs::path wrap = options.programs / "in_test_environment";
  if (command.in_real_time && fs::exists(wrap)) words.insert(words.begin(), wrap.string());
  return words;
}

nlohmann::json to_json(const BatteryFigures& figures) {
  return {{"n", figures.n},
          {"has_trials", figures.has_trials},
          {"failures", figures.failures},
          {"worst", figures.worst}};
}

BatteryFigures from_json(const nlohmann::json& json) {
  return {.n = json.at("n").get<int>(),
          .has_trials = json.at("has_trials").get<bool>(),
          .failures = json.at("failures").get<int>(),
          .worst = json.at("worst").get<std::string>()};
}

class Battery {
 public:
  explicit Battery(const BatteryOptions& options)
      : options_(options), kept_(options.out / "rows"), named_(rows_named(options.rows)) {
    if (options_.programs.empty()) options_.programs = own_program().parent_path();
    fs::create_directories(options_.out);
  }

  int run() {
    cli::catch_interrupts();
    const std::vector<BatteryRow> rows = rows_of(content(options_.table));
    std::vector<BatteryCommand> commands =
        test_commands(rows, tests_of(options_.programs, options_.out / "listings"));
    const std::vector<BatteryCommand> more = real_time_commands();
    commands.insert(commands.end(), more.begin(), more.end());
    std::vector<BatteryResult> results;
    for (const BatteryRow& row : rows) {
      BatteryResult& result = results.emplace_back(BatteryResult{row, {}});
      for (const BatteryCommand& command : commands) {
        if (command.row == row.number) add(command, result);
      }
    }
    std::cout << battery_table(results);
    return failed_rows(results) == 0 && !cli::interrupted() ? 0 : 1;
  }

 private:
  /// Runs it, or takes what an earlier run kept of it.
  void add(const BatteryCommand& command, BatteryResult& result) {
    const int trials = options_.trials > 0 ? options_.trials : asked_of(command.row);
    const std::vector<std::string> words = command_line(command, options_, trials);
    if (words.empty()) return;
    const std::string program = command.words.front();
    const std::string name = file_name_of(
        fmt::format("row_{} {} {}", command.row, program, command.in_real_time ? command.words[1] : ""));
    const std::string made_by =
        fmt::format("{} {} {} {}", fmt::join(words, " "), trials, build_id(),
                    fs::last_write_time(options_.programs / program).time_since_epoch().count());
    const std::string typed =
        (command.in_real_time ? "" : fmt::format("BANDWAGON_FAULT_TRIALS={} ", trials)) +
        fmt::format("{}", fmt::join(words, " "));
    if (const auto piece = kept_.find(name, made_by)) {
      result.commands.emplace_back(typed, from_json(*piece));
      return;
    }
    const bool is_wanted = named_.empty() || std::ranges::find(named_, command.row) != named_.end();
    if (!is_wanted || (command.in_real_time && !options_.real_time) || cli::interrupted()) return;
    setenv("BANDWAGON_FAULT_TRIALS", std::to_string(trials).c_str(), 1);
    const fs::path log = options_.out / (name + ".txt");
    const int status = run_one(words, log);
    if (cli::interrupted()) return;
    const BatteryFigures figures = figures_of(content(log), status);
    std::cerr << fmt::format("row {}: {}: {}\n", command.row, program,
                             figures.failures == 0 ? "as it should be" : "FAILED, see " + log.string());
    if (figures.failures == 0) kept_.put(name, made_by, to_json(figures));
    result.commands.emplace_back(typed, figures);
  }

  BatteryOptions options_;
  Kept kept_;
  std::vector<int> named_;
};

void add_battery(cli::Verb verb) {
  auto options = std::make_shared<BatteryOptions>();
  verb.option("--rows", options->rows,
              "Of these rows alone, as 1,2,6-8; what earlier runs kept is shown too");
  verb.option("--trials", options->trials, "Repetitions; as many as are asked for, unless given")
      .within(1, 100'000);
  verb.flag("--real-time", options->real_time,
            "Also programs that measure: their figures need a machine that does nothing else");
  verb.option("--out", options->out,
              "Folder for logs and finished pieces: the same command goes on from there");
  verb.option("--table", options->table, "The table of hazards");
  verb.option("--programs", options->programs, "Folder of the test programs; this program's, unless given");
  verb.run([options] { return Battery(*options).run(); });
}

void add_injections(cli::Verb verb) {
  auto options = std::make_shared<InjectionsOptions>();
  verb.option("--injections", options->injections, "How many in all").within(1, 100'000);
  verb.option("--each", options->each, "In one drive").within(1, 5);
  verb.option("--seed", options->seed, "Of the first drive; each has the next one");
  verb.option("--out", options->out, "Folder for drives: the same command goes on from there");
  verb.option("--longest", options->longest, "A drive [s]").positive();
  verb.run([options] {
    const InjectionsReport report = drive_injections(*options);
    std::cout << report.text;
    return report.is_good ? 0 : 1;
  });
}

void add_loops(cli::Verb verb) {
  auto options = std::make_shared<LoopsOptions>();
  verb.option("GRAPH", options->graph, "Graph file, or the name of one (hallway)");
  verb.option("--loops", options->loops, "Starts and stops").within(1, 1'000'000);
  verb.flag("--kill", options->kill, "All are killed, in place of being asked to end");
  verb.option("--out", options->out, "Folder for logs of a loop that fails");
  verb.run([options] {
    const LoopsResult result = run_loops(*options);
    std::cout << fmt::format("{} loops, {} failures; up after {:.2f} s at the latest, ended after {:.2f} s\n",
                             result.loops, result.failures, result.slowest_start, result.slowest_end);
    return result.loops == options->loops && result.failures == 0 ? 0 : 1;
  });
}

void add_soak(cli::Verb verb) {
  auto options = std::make_shared<SoakOptions>();
  verb.option("--hours", options->hours, "For how long [h]").positive();
  verb.option("--faults", options->faults, "In virtual time: which, as `--set faults=`; empty: none");
  verb.option("--seed", options->seed, "Of the run");
  verb.flag("--real-time", options->is_real, "In real time, and each half minute a process fails");
  verb.option("--out", options->out, "Folder for what was sampled, and for logs");
  verb.run([options] { return soak(*options) ? 0 : 1; });
}

}  // namespace

BW_VERB(measure, "battery", "The table of hazards: n, failures and worst figure of each row", add_battery)
BW_VERB(measure, "injections", "Processes killed, stopped, spinning and leaking during drives among people",
        add_injections)
BW_VERB(measure, "loops", "A graph started and stopped again and again", add_loops)
BW_VERB(measure, "soak", "Hours among people while something fails each half minute", add_soak)

}  // namespace bw
