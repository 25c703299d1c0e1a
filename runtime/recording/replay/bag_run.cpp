#include "runtime/recording/replay/bag_run.hpp"

#include <memory>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "runtime/recording/replay/bag_feed.hpp"
#include "runtime/recording/replay/graph_parts.hpp"

namespace bw::replay {
namespace {

class OutputTap final : public SampleTap {
 public:
  OutputTap(std::set<std::string> components, const BagRunOptions& options)
      : components_(std::move(components)), options_(options) {}
  void connect(const std::vector<const OutputEnd*>&) override {}
  void on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) override {
    if (!is_over_ && components_.contains(output.owner.name)) options_.on_output(output.topic, now, cdr);
  }
  [[nodiscard]] bool wants_everything() const override { return false; }
  void run_is_over() override { is_over_ = true; }

 private:
  std::set<std::string> components_;
  const BagRunOptions& options_;
  bool is_over_ = false;
};

/// Topics of the bag that nobody reads, or that the components write now.
std::set<std::string> left_out(const bag::Bag& recording, const std::map<std::string, Ends>& ends) {
  std::set<std::string> ignored;
  for (const bag::BagTopic& topic : recording.topics()) {
    bool is_read = false;
    bool is_written = false;
    for (const auto& [name, own] : ends) {
      is_read = is_read || own.inputs.contains(topic.name);
      is_written = is_written || own.outputs.contains(topic.name);
    }
    if (!is_read || is_written) ignored.insert(topic.name);
  }
  return ignored;
}

}  // namespace

BagRunResult run_on(const bag::Bag& recording, Graph graph, BagRunOptions options) {
  keep_only(graph, options.run);
  graph.settings.external_lifecycle = false;  // no manager is in the bag
  FeedOptions feed_options{.ignored = left_out(recording, ends_of(graph))};
  OutputComparison nothing(Pairing::in_order, {});
  BagFeed feed(recording, std::move(feed_options), nothing);
  std::vector<ExtraComponent> extra = std::move(options.extra);
  extra.push_back({.name = "bag_player", .component = feed.make_component(), .first = true});
  HostOptions host_options{
      .clock = ClockMode::lockstep,
      .start = recording.start(),
      .source = &feed,
      .alone = true,
      .tap = std::make_shared<OutputTap>(std::set(options.run.begin(), options.run.end()), options)};
  {
    Host host(std::move(graph), host_options, std::move(extra));
    host.run(recording.end() - recording.start());
  }
  BagRunResult result{.published = feed.published(), .malformed = feed.malformed(), .notes = feed.refused()};
  std::vector<bag::BagFault> faults = recording.faults();
  if (const auto damage = feed.damage()) faults.push_back(*damage);
  for (const bag::BagFault& fault : faults)
    result.notes.push_back(fmt::format("{}: byte {}: {}", fault.file.string(), fault.offset, fault.what));
  return result;
}

}  // namespace bw::replay
