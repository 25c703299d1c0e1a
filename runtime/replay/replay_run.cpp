#include "runtime/replay/replay_run.hpp"

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
#include "runtime/replay/bag_feed.hpp"
#include "runtime/replay/change_text.hpp"
#include "runtime/replay/graph_parts.hpp"
#include "runtime/replay/updated_bag.hpp"

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
  }
  for (const auto& [topic, fields] : tolerances) {
    if (std::ranges::none_of(live, [&](const auto& output) { return output.first == topic; })) continue;
    if (!fields.left_out.empty())
      result.notes.push_back(fmt::format("not compared: {} of {}", fmt::join(fields.left_out, ", "), topic));
    for (const auto& [field, value] : fields.absolute)
      result.notes.push_back(fmt::format("may differ by {}: {} of {}", value, field, topic));
  }
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
  keep_only(graph, options.run);
  const auto metadata = recording.metadata();
  const bool is_lockstep = entry(metadata, "bandwagon", "clock") == "lockstep";
  if (!is_lockstep) graph.settings.external_lifecycle = false;  // what its manager said is not in the bag
  std::set<std::string> recorded;
  for (const bag::BagTopic& topic : recording.topics()) {
    // In real time, what nobody reads is not sent.
    if (is_lockstep || topic.message_count > 0) recorded.insert(topic.name);
  }
  FeedOptions feed_options{.ignored = kOfTheProcess};
  for (const auto& [topic, node] : outputs_of(graph)) {
    if (recorded.contains(topic) && !kOfTheProcess.contains(topic)) feed_options.live.insert({topic, node});
  }
  if (feed_options.live.empty())
    throw std::runtime_error("nothing that these components write is in the bag");
  const Outputs live = feed_options.live;
  ReplayResult result{.pairing = is_lockstep ? Pairing::in_order : Pairing::by_stamp,
                      .notes = notes_on(recording)};
  if (const std::string count = entry(metadata, "result", "messages_of_run"); !count.empty()) {
    feed_options.messages = std::stoull(count);
  }
  const std::string seed = entry(metadata, "bandwagon", "seed");

  const Tolerances tolerances = read_tolerances(graph.tolerances, recording.topics());
  tell_tolerances(result, tolerances, live);
  std::optional<UpdatedBag> updated;
  if (!options.update.empty()) {
    updated.emplace(recording, options.update);
    feed_options.on_message = [&updated](auto... message) { updated->write(message...); };
  }
  OutputComparison comparison(result.pairing, tolerances);
  BagFeed feed(recording, std::move(feed_options), comparison);
  ChangeText text(recording.start());
  const auto tap = std::make_shared<LiveTap>(feed, live, options.with_text ? &text : nullptr);
  std::vector<ExtraComponent> extra;
  extra.push_back({.name = "bag_player", .component = feed.make_component(), .first = true});
  HostOptions host_options{.clock = ClockMode::lockstep,
                           .seed = seed.empty() ? 1 : std::stoull(seed),
                           .start = recording.start(),
                           .source = &feed,
                           .tap = tap};
  std::string parameters;
  {
    Host host(std::move(graph), host_options, std::move(extra));
    for (const auto& [name, report] : host.parameters())
      parameters += fmt::format("# {}\n{}\n", name, report.yaml);
    host.run(recording.end() - recording.start());
  }
  feed.finish();
  comparison.finish(recording.end());
  if (updated) updated->finish(parameters);

  tell(result, comparison, feed);
  result.text = text.text();
  return result;
}

}  // namespace bw::replay
