// bandwagon replay BAG --graph G --run COMPONENT...: the bag as the truth. Exit status 0 when every output of the named
// components equals the bag's, 1 when not, 2 on a wrong configuration.
#include <iostream>
#include <memory>
#include <stdexcept>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/atomic_file.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/replay/replay_run.hpp"
#include "runtime/replay/updated_bag.hpp"

namespace bw::cli {
namespace {

struct ReplayArguments {
  std::string path;
  std::string graph;
  std::string clock = "lockstep";
  std::vector<std::string> set;
  std::vector<std::string> run;
  std::string json;
  std::string text;
  bool update = false;
};

nlohmann::json to_json(const replay::ReplayResult& result) {
  nlohmann::json json = {{"equal", result.is_equal()},
                         {"compared", result.compared},
                         {"published", result.published},
                         {"malformed", result.malformed},
                         {"sha256", result.sha256},
                         {"pairing", result.pairing == replay::Pairing::in_order ? "in_order" : "by_stamp"},
                         {"notes", result.notes},
                         {"topics", nlohmann::json::object()},
                         {"first_difference", nullptr}};
  for (const auto& [topic, verdict] : result.topics) {
    json["topics"][topic] = {{"type", verdict.type},           {"equal", verdict.equal},
                             {"differing", verdict.differing}, {"missing", verdict.missing},
                             {"extra", verdict.extra},         {"apart_s", verdict.apart},
                             {"largest", verdict.largest},     {"largest_field", verdict.largest_field}};
  }
  if (!result.first_topic.empty()) {
    const replay::Difference& d = *result.topics.at(result.first_topic).first;
    json["first_difference"] = {{"topic", result.first_topic},
                                {"time_s", d.time.to_seconds()},
                                {"field", d.field},
                                {"recorded", d.recorded},
                                {"replayed", d.replayed}};
  }
  return json;
}

void print(const replay::ReplayResult& result, Time start) {
  for (const std::string& note : result.notes) std::cout << "note: " << note << "\n";
  if (result.malformed > 0)
    std::cout << fmt::format("note: {} messages of the bag do not fit their type\n", result.malformed);
  if (result.is_equal()) {
    std::cout << fmt::format("equal: {} messages on {} topics, by {} recorded ones; sha256 {}\n",
                             result.compared, result.topics.size(), result.published, result.sha256);
    return;
  }
  if (!result.first_topic.empty()) {
    const replay::Difference& d = *result.topics.at(result.first_topic).first;
    std::cout << fmt::format("first difference: {} at {:.3f} s{}{}\n  recorded {}\n  replayed {}\n",
                             result.first_topic, (d.time - start).to_seconds(), d.field.empty() ? "" : ", ",
                             d.field, d.recorded, d.replayed);
  }
  std::size_t width = 5;
  for (const auto& [topic, verdict] : result.topics) width = std::max(width, topic.size());
  std::cout << fmt::format("{:{}} {:>8} {:>9} {:>8} {:>8}  largest\n", "topic", width, "equal", "differing",
                           "missing", "extra");
  for (const auto& [topic, v] : result.topics) {
    const std::string largest =
        v.largest > 0.0 ? fmt::format("{:.3g} in {}", v.largest, v.largest_field) : "-";
    std::cout << fmt::format("{:{}} {:>8} {:>9} {:>8} {:>8}  {}\n", topic, width, v.equal, v.differing,
                             v.missing, v.extra, largest);
  }
}

int run_replay(const ReplayArguments& arguments) {
  const auto recording = bag::open_bag(arguments.path);
  const std::filesystem::path update = arguments.update ? replay::beside(arguments.path) : "";
  const replay::ReplayResult result =
      replay::replay(*recording, load_graph(arguments.graph, arguments.set),
                     {.run = arguments.run, .update = update, .with_text = !arguments.text.empty()});
  print(result, recording->start());
  if (arguments.update) std::cout << "new outputs: " << update.string() << "\n";
  if (!arguments.text.empty()) write_file_atomically(arguments.text, result.text);
  if (!arguments.json.empty()) write_file_atomically(arguments.json, to_json(result).dump(2) + "\n");
  return result.is_equal() ? 0 : 1;
}

CLI::App* add_replay(CLI::App& app, int& status) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* verb =
      app.add_subcommand("replay", "Runs components again on a recording and compares what they write");
  verb->add_option("BAG", arguments->path, "File or folder")->required();
  verb->add_option("--graph", arguments->graph, "Graph file")->required();
  verb->add_option("--run", arguments->run, "Components to run; everything else is the bag")->required();
  verb->add_option("--clock", arguments->clock, "lockstep (virtual time, repeatable)")
      ->check(CLI::IsMember({"lockstep"}));
  verb->add_option("--set", arguments->set, "component.param=value, as often as needed")
      ->allow_extra_args(false);
  verb->add_option("--json", arguments->json, "Writes the verdict here");
  verb->add_option("--text", arguments->text, "Writes the outputs here as text to review, rounded");
  verb->add_flag("--update", arguments->update,
                 "Writes a new bag beside the old one, with the new outputs: drive.replayed.mcap");
  verb->callback([arguments, &status] { status = run_replay(*arguments); });
  return verb;
}

}  // namespace

BW_VERB(drive, "replay", add_replay)

}  // namespace bw::cli
