// bandwagon replay BAG --graph G --run COMPONENT...: the bag as the truth. Exit status 0 when every output of
// the named components equals the bag's, 1 when not, 2 on a wrong configuration. bandwagon replay BAG...: the
// bag as topics (replay_topics.hpp).
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/atomic_file.hpp"
#include "runtime/cli/page_writer.hpp"
#include "runtime/cli/replay_topics.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/recording/replay/replay_run.hpp"
#include "runtime/recording/replay/updated_bag.hpp"
#include "runtime/temporary_folder.hpp"

namespace bw::cli {
namespace {

struct ReplayArguments {
  std::vector<std::string> paths;
  std::string graph;
  std::string clock;
  std::vector<std::string> set;
  std::vector<std::string> run;
  std::string json;
  std::string text;
  std::string html;
  bool update = false;
  ReplayTopicsOptions as_topics;
};

constexpr double kUsualClockHz = 40.0;  // as `ros2 bag play`
constexpr std::size_t kToldExchanges = 5;

nlohmann::json to_json(const replay::Exchange& exchange) {
  const auto input = [](const replay::RecordedInput& i) {
    return nlohmann::json{{"topic", i.topic}, {"log_time_s", i.log_time.to_seconds()}, {"message", i.number}};
  };
  return {{"input", input(exchange.moved)},
          {exchange.is_after() ? "after" : "before", input(exchange.past)},
          {"apart_s", exchange.apart().to_seconds()}};
}

nlohmann::json to_json(const replay::OrderVerdict& order) {
  nlohmann::json json = {{"equal_when", nlohmann::json::array()},
                         {"close_together", nlohmann::json::array()},
                         {"tried", order.tried},
                         {"lacks_input", order.lacks_input},
                         {"left", nullptr}};
  for (const replay::Exchange& exchange : order.taken) json["equal_when"].push_back(to_json(exchange));
  for (const replay::Exchange& exchange : order.close) json["close_together"].push_back(to_json(exchange));
  if (order.left) json["left"] = {{"topic", order.left->topic}, {"time_s", order.left->time.to_seconds()}};
  return json;
}

nlohmann::json to_json(const replay::ReplayResult& result) {
  nlohmann::json json = {{"equal", result.is_equal()},
                         {"compared", result.compared},
                         {"published", result.published},
                         {"malformed", result.malformed},
                         {"sha256", result.sha256},
                         {"pairing", result.pairing == replay::Pairing::in_order ? "in_order" : "by_stamp"},
                         {"notes", result.notes},
                         {"topics", nlohmann::json::object()},
                         {"first_difference", nullptr},
                         {"input_order", nullptr}};
  if (result.order) json["input_order"] = to_json(*result.order);
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

std::string to_text(const replay::Exchange& exchange, Time start) {
  const auto at = [start](const replay::RecordedInput& input) {
    return fmt::format("{} at {:.6f} s", input.topic, (input.log_time - start).to_seconds());
  };
  return fmt::format("{} is taken {} {} ({:.3f} ms apart in the bag)", at(exchange.moved),
                     exchange.is_after() ? "after" : "before", at(exchange.past),
                     exchange.apart().to_seconds() * 1e3);
}

void print(const replay::OrderVerdict& order, Time start) {
  for (const replay::Exchange& exchange : order.taken)
    std::cout << "  equal there when " << to_text(exchange, start) << "\n";
  if (!order.left) {
    std::cout << fmt::format("order of inputs: with {} everything is equal; it is not the code\n",
                             order.taken.size() == 1 ? "that order" : "these orders");
    return;
  }
  if (!order.taken.empty())
    std::cout << fmt::format("order of inputs: with that, the first difference is {} at {:.3f} s\n",
                             order.left->topic, (order.left->time - start).to_seconds());
  if (order.lacks_input) {
    std::cout << fmt::format(
        "order of inputs: the bag lacks the input of its stamp, {:.9f} s: the recorder did not hear what it "
        "answers, and what comes later may differ for that\n",
        order.left->stamp.to_seconds());
    return;
  }
  if (order.close.empty()) {
    std::cout << fmt::format("order of inputs: no two arrived within {:.0f} ms of each other around it\n",
                             replay::kCloseTogether.to_seconds() * 1e3);
    return;
  }
  std::cout << fmt::format(
      "order of inputs: {} other orders of two that arrived close together around it, {} tried: none makes it "
      "equal; a timer's phase, more than two inputs, or the code\n",
      order.close.size(), order.tried);
  for (std::size_t i = 0; i < std::min(order.close.size(), kToldExchanges); ++i)
    std::cout << "  not equal when " << to_text(order.close[i], start) << "\n";
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
    if (result.order) print(*result.order, start);
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
  const auto recording = bag::open_bag(arguments.paths.front());
  std::filesystem::path update = arguments.update ? replay::beside(arguments.paths.front()) : "";
  std::optional<TemporaryFolder> aside;  // of what only the page is made of
  if (!arguments.html.empty()) {
    page_writer().require("--html " + arguments.html);
    if (!arguments.update) update = aside.emplace().path() / "replayed.mcap";
  }
  const replay::ReplayResult result =
      replay::replay(*recording, load_graph(arguments.graph, arguments.set),
                     {.run = arguments.run, .update = update, .with_text = !arguments.text.empty()});
  print(result, recording->start());
  if (arguments.update) std::cout << "new outputs: " << update.string() << "\n";
  if (!arguments.text.empty()) write_file_atomically(arguments.text, result.text);
  if (!arguments.json.empty()) write_file_atomically(arguments.json, to_json(result).dump(2) + "\n");
  if (!arguments.html.empty()) {
    const std::string name = std::filesystem::path(arguments.paths.front()).stem().string() + " replayed";
    page_writer().write(update, name, arguments.html);
  }
  return result.is_equal() ? 0 : 1;
}

/// What belongs to one way of replaying is refused beside the other.
void refuse_mixture(Verb verb, const ReplayArguments& arguments, bool as_truth) {
  const std::string alien = given_replay_topics_option(verb);
  if (as_truth && !alien.empty())
    throw std::runtime_error(alien + " is for a replay as topics, without --graph and --run");
  if (as_truth && (arguments.graph.empty() || arguments.run.empty()))
    throw std::runtime_error("--graph and --run go together; without both the bag is played as topics");
  if (as_truth && arguments.paths.size() != 1)
    throw std::runtime_error("with --graph the bag is one: " + arguments.paths.at(1) + " is too many");
  for (const char* name : {"--set", "--json", "--text", "--html", "--update"}) {
    if (!as_truth && verb.has(name))
      throw std::runtime_error(std::string(name) + " is for a replay as the truth, with --graph and --run");
  }
}

/// `--clock`, `--clock 100`; nothing without it.
std::optional<double> clock_hz(Verb verb, const std::string& text) {
  if (!verb.has("--clock")) return std::nullopt;
  if (text.empty()) return kUsualClockHz;
  const std::optional<double> hz = parse_number(text);
  if (!hz || !(*hz > 0.0 && *hz <= 10'000.0))
    throw std::runtime_error(
        "--clock " + text +
        ": without --graph it is how often /clock is published, 40 Hz if no number follows");
  return hz;
}

int run(Verb verb, const ReplayArguments& arguments) {
  const bool as_truth = !arguments.graph.empty() || !arguments.run.empty();
  refuse_mixture(verb, arguments, as_truth);
  if (!as_truth) return replay_topics(arguments.paths, arguments.as_topics, clock_hz(verb, arguments.clock));
  if (verb.has("--clock") && arguments.clock != "lockstep")
    throw std::runtime_error("--clock " + arguments.clock + ": with --graph the clock is lockstep");
  return run_replay(arguments);
}

void add_replay(Verb verb) {
  auto arguments = std::make_shared<ReplayArguments>();
  constexpr const char* kTruth = "As the truth (with --graph)";
  verb.option("BAG", arguments->paths, "Files or folders; several are played together, by their times")
      .required();
  verb.option("--graph", arguments->graph, "Graph file").under(kTruth);
  verb.option("--run", arguments->run, "Components to run; everything else is the bag").under(kTruth);
  verb.option("--set", arguments->set, "component.param=value, as often as needed")
      .one_each_time()
      .under(kTruth);
  verb.option("--json", arguments->json, "Writes the verdict here").under(kTruth);
  verb.option("--text", arguments->text, "Writes the outputs here as text to review, rounded").under(kTruth);
  verb.option(
          "--html", arguments->html,
          "Writes one page here that plays the recording with the new outputs: a file that needs no server")
      .under(kTruth);
  verb.flag("--update", arguments->update,
            "Writes a new bag beside the old one, with the new outputs: drive.replayed.mcap")
      .under(kTruth);
  verb.option(
          "--clock", arguments->clock,
          "As topics: publishes /clock, so many times a second (40); as the truth: lockstep, virtual time")
      .optional_value();
  add_replay_topics_options(verb, arguments->as_topics);
  verb.run([arguments, verb] { return run(verb, *arguments); });
}

}  // namespace

BW_VERB(drive, "replay", "Plays recordings as topics; with --graph runs components again on one and compares",
        add_replay)

}  // namespace bw::cli
