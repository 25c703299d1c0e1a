#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include <unistd.h>

#include "components/program/drive.hpp"
#include "components/program/run_options.hpp"
#include "components/program/score_card_json.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/own_program.hpp"
#include "runtime/state_folder.hpp"

namespace bw {
namespace {

ClockMode clock_mode(const std::string& name) {
  return name == "lockstep" ? ClockMode::lockstep : name == "topic" ? ClockMode::topic : ClockMode::wall;
}

/// As fast as possible, but in step with the people and programs that set further goals.
double pace_of(const RunOptions& options) { return options.pace.value_or(options.stay ? 1.0 : 0.0); }

/// A run that stays is asked to end; how its goals went is on the card.
bool is_success(const RunOptions& options, const DriveResult& result) {
  if (!result.judged || !result.has_goal) return result.end.ok;
  const bool contact = result.card && result.card->collisions() > 0;
  const bool is_well = options.stay ? result.end.ok : result.json.value("reached", false);
  return is_well && !(options.fail_on_contact && contact);
}

int run(const RunOptions& options) {
  Graph graph = options.load();
  const DriveResult result =
      drive(std::move(graph),
            {.host = {.clock = clock_mode(options.clock),
                      .seed = options.seed,
                      .only_process = options.only,
                      .pace = pace_of(options),
                      .accept_inputs = options.accept_inputs},
             .longest = options.for_s > 0.0 ? std::optional(Duration::seconds(options.for_s)) : std::nullopt,
             .svg = options.svg,
             .html = options.html,
             .record = options.record.record,
             .record_options = options.record.writer_options(),
             .snapshots = true,
             .show_progress = options.progress || isatty(STDERR_FILENO) != 0,
             .contacts = true,
             .stays = options.stay});
  if (!options.json.empty()) write_file_atomically(options.json, result.json.dump(2) + "\n");
  if (result.judged) std::cout << in_words(result.json);
  if (!result.page_fault.empty()) {
    std::cerr << "--html: " << result.page_fault << "\n";
    return 1;
  }
  return is_success(options, result) ? 0 : 1;
}

void add_run(cli::Verb verb) {
  auto options = std::make_shared<RunOptions>();
  verb.option("GRAPH", options->graph, "Graph file, or the name of one (`bandwagon graphs`)").required();
  add_run_options(verb, options);
  verb.run([options] { return run(*options); });
}

/// `options` are what was asked for beside the demo's own.
int run_demo(RunOptions options, const std::filesystem::path& folder, bool has_page) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault)
    throw std::runtime_error(folder.string() + ": " + fault.message() + "; --out FOLDER writes elsewhere");
  const auto file = [&folder](const char* name) { return (folder / name).string(); };
  const auto set = [](std::string& option, const std::string& value) {
    if (option.empty()) option = value;
  };
  options.graph = "hallway";
  if (options.clock.empty()) options.clock = options.stay ? "wall" : "lockstep";
  options.fail_on_contact = true;
  options.progress = true;
  set(options.json, file("score_card.json"));
  set(options.svg, file("drive.svg"));
  if (options.record.record.empty()) std::filesystem::remove(file("drive.mcap"));
  set(options.record.record, file("drive.mcap"));
  if (has_page) set(options.page.page, PageOptions::kAsGiven);
  if (has_page) set(options.page.bags, folder.string());
  std::cout << "A robot crosses a hallway with six walkers and two people who stand ("
            << (options.clock == "lockstep" ? "simulated time" : "real time")
            << (options.stay ? ", until Ctrl-C" : "") << "):" << std::endl;
  const int status = run(options);
  const std::string program = own_program().string();
  std::cout << "\nScore card: " << options.json << "\nPicture:    " << options.svg
            << "\nOn a page:  " << program << " view " << options.record.record
            << "\nRecording:  " << options.record.record
            << ", to be driven again by any of its components:\n  " << program << " replay "
            << options.record.record << " --graph hallway --run local_planner\n";
  return status;
}

void add_demo(cli::Verb verb) {
  auto options = std::make_shared<RunOptions>(RunOptions{.clock = "", .seed = 7, .pace = 4.0});
  auto folder = std::make_shared<std::filesystem::path>();
  auto no_page = std::make_shared<bool>(false);
  verb.option("--out", *folder, "Folder for what it writes (~/.local/state/bandwagon/demo)");
  verb.flag("--no-page", *no_page, "Serves no page");
  add_run_options(verb, options);
  verb.run(
      [=] { return run_demo(*options, folder->empty() ? state_folder() / "demo" : *folder, !*no_page); });
}

}  // namespace

BW_VERB(drive, "run", "Runs a graph, or one process of it", add_run)
BW_VERB(drive, "demo", "Drives through a hallway full of people, on the page; options of run", add_demo)

}  // namespace bw
