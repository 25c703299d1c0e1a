#include "runtime/recording/replay/replay_run.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/build_identity.hpp"
#include "runtime/host/host.hpp"
#include "runtime/recording/replay/bag_feed.hpp"
#include "runtime/recording/replay/change_text.hpp"
#include "runtime/recording/replay/graph_parts.hpp"
#include "runtime/recording/replay/updated_bag.hpp"

namespace bw::replay {
namespace {

/// Every process says these for itself.
const std::set<std::string> kOfTheProcess = {"/rosout", "/diagnostics", "/clock", "/parameter_events"};

/// Topics with the nodes that write them.
using Outputs = std::set<std::pair<std::string, std::string>>;

/// Gives the feed what the running components write, until they are deactivated.
class LiveTap final : public SampleTap {
 public:
  /// `text` may be null.
  LiveTap(BagFeed& feed, Outputs live, ChangeText* text) : feed_(feed), live_(std::move(live)), text_(text) {}
  void connect(const std::vector<const OutputEnd*>&) override {}
  void on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) override {
    const std::string& node = output.owner.name;
    if (is_over_ || !live_.contains({output.topic, node})) return;
    feed_.on_live(output.topic, node, now, cdr);
    if (text_ != nullptr) text_->add(output.topic, std::string(output.type.ros_name), now, cdr);
  }
  void run_is_over() override { is_over_ = true; }

 private:
  BagFeed& feed_;
  Outputs live_;
  ChangeText* text_;
  bool is_over_ = false;
};

/// What the components of the graph write, by their declarations.
Outputs outputs_of(const Graph& graph) {
  Outputs topics;
  for (const auto& [name, ends] : ends_of(graph)) {
    for (const std::string& topic : ends.outputs) topics.insert({topic, name});
  }
  return topics;
}

std::string entry(const std::map<std::string, std::map<std::string, std::string>>& metadata,
                  const char* record, const char* key) {
  const auto found = metadata.find(record);
  if (found == metadata.end()) return {};
  const auto value = found->second.find(key);
  return value == found->second.end() ? std::string() : value->second;
}

/// Build ids are long, and their beginning tells them apart.
std::string shortened(const std::string& text) {
  return text.size() <= 48 ? text : text.substr(0, 12) + "...";
}

std::vector<std::string> notes_on(const bag::Bag& recording) {
  std::vector<std::string> notes;
  const auto metadata = recording.metadata();
  const auto compare = [&](const char* key, const std::string& here, const char* what) {
    const std::string there = entry(metadata, "bandwagon", key);
    if (there.empty()) {
      notes.push_back(fmt::format("the bag does not say which {} made it", what));
    } else if (there != here) {
      notes.push_back(fmt::format("another {} made the bag ({}, this is {}): bytes may differ for that alone",
                                  what, shortened(there), shortened(here)));
    }
  };
  compare("build_id", build_id(), "build");
  compare("cpu", cpu_type(), "CPU type");
  for (const bag::BagFault& fault : recording.faults()) {
    notes.push_back(fmt::format("{}: byte {}: {}", fault.file.string(), fault.offset, fault.what));
  }
  return notes;
}

void tell_tolerances(ReplayResult& result, const Tolerances& tolerances, const Outputs& live) {
  if (result.pairing == Pairing::by_stamp) {
    result.notes.emplace_back(
        "the bag is of real time: messages are compared with the nearest by stamp, within half a period");
    result.notes.emplace_back(
        "it does not say in which order inputs were taken: they are taken as its recorder heard them");
  }
  for (const auto& [topic, fields] : tolerances) {
    if (std::ranges::none_of(live, [&](const auto& output) { return output.first == topic; })) continue;
    if (!fields.left_out.empty())
      result.notes.push_back(fmt::format("not compared: {} of {}", fmt::join(fields.left_out, ", "), topic));
    for (const auto& [field, value] : fields.absolute)
      result.notes.push_back(fmt::format("may differ by {}: {} of {}", value, field, topic));
  }
}

/// What stays the same when the components run in another order of inputs.
struct Plan {
  const bag::Bag& recording;
  Graph graph;
  FeedOptions feed;
  Tolerances tolerances;
  Pairing pairing = Pairing::in_order;
  std::uint64_t seed = 1;
};

Plan plan_of(const bag::Bag& recording, Graph graph, const std::vector<std::string>& run) {
  keep_only(graph, run);
  const auto metadata = recording.metadata();
  const bool is_lockstep = entry(metadata, "bandwagon", "clock") == "lockstep";
  if (!is_lockstep) graph.settings.external_lifecycle = false;  // what its manager said is not in the bag
  std::set<std::string> recorded;
  for (const bag::BagTopic& topic : recording.topics()) {
    // In real time, what nobody reads is not sent.
    if (is_lockstep || topic.message_count > 0) recorded.insert(topic.name);
  }
  FeedOptions feed{.ignored = kOfTheProcess};
  for (const auto& [topic, node] : outputs_of(graph)) {
    if (recorded.contains(topic) && !kOfTheProcess.contains(topic)) feed.live.insert({topic, node});
  }
  if (feed.live.empty()) throw std::runtime_error("nothing that these components write is in the bag");
  if (const std::string count = entry(metadata, "result", "messages_of_run"); !count.empty())
    feed.messages = std::stoull(count);
  const std::string seed = entry(metadata, "bandwagon", "seed");
  Tolerances tolerances = read_tolerances(graph.tolerances, recording.topics());
  return {.recording = recording,
          .graph = std::move(graph),
          .feed = std::move(feed),
          .tolerances = std::move(tolerances),
          .pairing = is_lockstep ? Pairing::in_order : Pairing::by_stamp,
          .seed = seed.empty() ? 1 : std::stoull(seed)};
}

/// Runs the components to `end`. `text` may be null. Returns their parameters as YAML.
std::string run_components(const Plan& plan, BagFeed& feed, ChangeText* text, Time end, bool alone) {
  std::vector<ExtraComponent> extra;
  extra.push_back({.name = "bag_player", .component = feed.make_component(), .first = true});
  const HostOptions options{.clock = ClockMode::lockstep,
                            .seed = plan.seed,
                            .start = plan.recording.start(),
                            .source = &feed,
                            .alone = alone,
                            .tap = std::make_shared<LiveTap>(feed, plan.feed.live, text)};
  Host host(plan.graph, options, std::move(extra));
  std::string parameters;
  for (const auto& [name, report] : host.parameters())
    parameters += fmt::format("# {}\n{}\n", name, report.yaml);
  host.run(end - plan.recording.start());
  return parameters;
}

std::optional<FirstDifference> first_of(const OutputComparison& comparison) {
  const auto topic = comparison.first_topic();
  if (!topic) return std::nullopt;
  const TopicVerdict& verdict = comparison.verdicts().at(*topic);
  FirstDifference difference{.topic = *topic,
                             .time = verdict.first->time,
                             .stamped_topic = *topic,
                             .stamp = verdict.first->stamp,
                             .period = verdict.period};
  // Markers are written beside what they show, and carry no stamp of their own.
  for (const auto& [name, other] : comparison.verdicts()) {
    if (difference.stamp != difference.time) break;
    if (!other.first || other.first->stamp == other.first->time) continue;
    if ((other.first->time - difference.time) * 2 > other.period) continue;
    difference.stamped_topic = name;
    difference.stamp = other.first->stamp;
  }
  return difference;
}

OrderVerdict explain(const Plan& plan, const FirstDifference& first) {
  std::set<std::string> inputs;
  for (const auto& [name, ends] : ends_of(plan.graph)) inputs.insert(ends.inputs.begin(), ends.inputs.end());
  for (const auto& [topic, node] : plan.feed.live) inputs.erase(topic);
  return explain_by_order(plan.recording, inputs, first, kOrderBudget,
                          [&plan](const std::vector<Delay>& delays, std::optional<Time> end) {
                            const Time last = plan.recording.end();
                            OutputComparison comparison(plan.pairing, plan.tolerances);
                            FeedOptions options = plan.feed;
                            options.delays = delays;
                            BagFeed feed(plan.recording, std::move(options), comparison);
                            run_components(plan, feed, nullptr, std::min(end.value_or(last), last), true);
                            feed.finish();
                            comparison.finish(last);
                            return first_of(comparison);
                          });
}

void tell(ReplayResult& result, const OutputComparison& comparison, const BagFeed& feed) {
  result.topics = comparison.verdicts();
  result.first_topic = comparison.first_topic().value_or("");
  result.compared = comparison.compared();
  result.published = feed.published();
  result.malformed = feed.malformed();
  result.sha256 = comparison.sha256();
  result.notes.insert(result.notes.end(), feed.refused().begin(), feed.refused().end());
  if (const auto damage = feed.damage()) {
    result.notes.push_back(
        fmt::format("{}: byte {}: {}", damage->file.string(), damage->offset, damage->what));
  }
}

}  // namespace

ReplayResult replay(const bag::Bag& recording, Graph graph, const ReplayOptions& options) {
  const Plan plan = plan_of(recording, std::move(graph), options.run);
  ReplayResult result{.pairing = plan.pairing, .notes = notes_on(recording)};
  tell_tolerances(result, plan.tolerances, plan.feed.live);
  FeedOptions feed_options = plan.feed;
  std::optional<UpdatedBag> updated;
  if (!options.update.empty()) {
    updated.emplace(recording, options.update);
    feed_options.on_message = [&updated](auto... message) { updated->write(message...); };
  }
  OutputComparison comparison(plan.pairing, plan.tolerances);
  BagFeed feed(recording, std::move(feed_options), comparison);
  ChangeText text(recording.start());
  const std::string parameters =
      run_components(plan, feed, options.with_text ? &text : nullptr, recording.end(), false);
  feed.finish();
  comparison.finish(recording.end());
  if (updated) updated->finish(parameters);

  tell(result, comparison, feed);
  result.text = text.text();
  if (const auto first = first_of(comparison); first && plan.pairing == Pairing::by_stamp)
    result.order = explain(plan, *first);
  return result;
}

}  // namespace bw::replay
