// `bandwagon launch`: a graph with one process per `process:`, looked after by this one, or by systemd.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include "components/program/run_options.hpp"
#include "components/program/systemd_units.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/dds/participant.hpp"
#include "runtime/graph/config_file.hpp"
#include "runtime/host/host.hpp"
#include "runtime/parameters/own_program.hpp"
#include "runtime/state_folder.hpp"
#include "runtime/supervisor/supervisor.hpp"

namespace bw {
namespace {

namespace fs = std::filesystem;

struct LaunchOptions {
  std::shared_ptr<RunOptions> run = std::make_shared<RunOptions>();
  fs::path logs;
  fs::path systemd;
};

/// Of this graph on this domain.
fs::path socket_of(const std::string& graph) {
  const int domain = dds::Network::from_environment(dds::Transport::localhost).domain_id;
  return supervisor_socket(
      fmt::format("{} {}", fs::canonical(config_file("graphs", graph)).string(), domain));
}

void refuse_what_is_of_one_process(const RunOptions& run) {
  if (!run.html.empty())
    throw std::runtime_error(
        "--html is of one process: record with --record FILE, then `bandwagon view FILE`");
  if (run.clock == "lockstep")
    throw std::runtime_error("--clock lockstep is of one process: `bandwagon run`");
  if (!run.only.empty()) throw std::runtime_error("--only is of one process: `bandwagon run`");
  static_cast<void>(run.record.writer_options());
}

/// What was given on the command line, for each process of the graph and for the recorder.
struct Words {
  std::vector<std::string> run, record;
};

Words words_of(const cli::Verb& verb) {
  Words words;
  for (const auto& [name, word] : verb.given()) {
    if (name == "--logs" || name == "--systemd") continue;
    const bool is_writing =
        std::ranges::find(cli::BagWriting::kOptions, name) != std::end(cli::BagWriting::kOptions);
    if (is_writing) {
      words.record.push_back(word);
    } else if (name != "--record") {
      words.run.push_back(word);
    }
  }
  return words;
}

/// drive.mcap, drive_2.mcap: a recorder that was killed does not write over what it has.
std::string numbered(const fs::path& path, int number) {
  if (number == 1) return path.string();
  return (path.parent_path() /
          fmt::format("{}_{}{}", path.stem().string(), number, path.extension().string()))
      .string();
}

std::vector<SupervisedProgram> programs_of(const Graph& graph, const RunOptions& run, const Words& words,
                                           const fs::path& logs) {
  const std::string program = own_program().string();
  std::vector<SupervisedProgram> programs;
  if (!run.record.record.empty()) {
    std::vector<std::string> command = {program, "record", "--all"};
    command.insert(command.end(), words.record.begin(), words.record.end());
    programs.push_back({.name = "recorder",
                        .command =
                            [command, out = run.record.record](int start) {
                              auto whole = command;
                              whole.push_back("--out=" + numbered(out, start));
                              return whole;
                            },
                        .ends_last = true});
  }
  for (const std::string& process : graph.processes()) {
    std::vector<std::string> command = {program, "run", fs::absolute(graph.path).string(),
                                        "--only=" + process};
    command.insert(command.end(), words.run.begin(), words.run.end());
    if (run.json.empty() && !logs.empty())
      command.push_back("--json=" + (logs / (process + ".json")).string());
    SupervisedProgram& added = programs.emplace_back(
        SupervisedProgram{.name = process, .command = [command](int) { return command; }});
    if (const auto limits = graph.limits.find(process); limits != graph.limits.end()) {
      added.memory = limits->second.memory;
      if (limits->second.cpu) added.cores = static_cast<int>(std::ceil(*limits->second.cpu));
    }
  }
  return programs;
}

fs::path make_log_folder(const LaunchOptions& options, const Graph& graph) {
  fs::path folder = options.logs;
  if (folder.empty())
    folder =
        state_folder() / "runs" /
        fmt::format("{}-{:%Y%m%d-%H%M%S}", graph.path.stem().string(), fmt::localtime(std::time(nullptr)));
  fs::create_directories(folder);
  return fs::absolute(folder);
}

/// What was run: by which program, with which words and parameters.
void write_manifest(const Host& host, const Words& words, const fs::path& logs) {
  std::ofstream(logs / "manifest.yaml")
      << fmt::format("version: {}\nrevision: {}\ngraph: {}\narguments: {}\n", program_version(),
                     source_revision().empty() ? "unknown" : source_revision(), host.graph().path.string(),
                     fmt::join(words.run, " "));
  std::ofstream(logs / "graph.yaml") << std::ifstream(host.graph().path).rdbuf();
  std::ofstream parameters(logs / "parameters.yaml");
  for (const auto& [component, report] : host.parameters()) {
    parameters << component << ":\n";
    std::istringstream lines(report.yaml);
    for (std::string line; std::getline(lines, line);) parameters << "  " << line << "\n";
  }
}

int launch(const LaunchOptions& options, const cli::Verb& verb) {
  if (options.run->graph.empty())
    throw std::runtime_error("GRAPH is required: a graph file, or the name of one");
  refuse_what_is_of_one_process(*options.run);
  const Host checked(options.run->load(), {});
  const Words words = words_of(verb);
  if (!options.systemd.empty()) {
    write_units(options.systemd, checked.graph(), programs_of(checked.graph(), *options.run, words, {}));
    return 0;
  }
  umask(077);  // logs hold the page's token, recordings who was where
  const SupervisorLock lock(socket_of(options.run->graph));
  const fs::path logs = make_log_folder(options, checked.graph());
  write_manifest(checked, words, logs);
  cli::catch_interrupts();
  std::signal(SIGPIPE, SIG_IGN);  // who reads us may go first
  const int status = supervise(lock, {.programs = programs_of(checked.graph(), *options.run, words, logs),
                                      .logs = logs,
                                      .interrupted = cli::interrupted});
  std::cout << "Logs: " << logs.string() << std::endl;
  return status;
}

void add_question(cli::Verb verb, const std::string& question, bool has_process) {
  auto graph = std::make_shared<std::string>();
  auto process = std::make_shared<std::string>();
  verb.option("GRAPH", *graph, "As it was launched").required();
  if (has_process) verb.option("PROCESS", *process, "Only this one");
  verb.run([=] {
    std::cout << ask_supervisor(socket_of(*graph), process->empty() ? question : question + " " + *process);
  });
}

void add_launch(cli::Verb verb) {
  auto options = std::make_shared<LaunchOptions>();
  verb.option("GRAPH", options->run->graph, "Graph file, or the name of one (`bandwagon graphs`)");
  verb.option("--logs", options->logs, "Folder for logs, score cards and a manifest of the run");
  verb.option("--systemd", options->systemd, "Starts nothing: writes units of systemd into this folder");
  add_run_options(verb, options->run);
  add_question(verb.verb("status", "How its processes are, and what became of those before them"), "status",
               false);
  add_question(verb.verb("restart", "Starts its processes again, once they are at rest"), "restart", true);
  add_question(verb.verb("stop", "Brings it to rest, and ends it"), "stop", false);
  verb.stands_alone_too();
  verb.run([options, verb] { return launch(*options, verb); });
}

}  // namespace

BW_VERB(drive, "launch",
        "Runs a graph with one process per `process:`, watched and started again; options of run", add_launch)

}  // namespace bw
