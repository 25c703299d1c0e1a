#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <fmt/format.h>

#include "components/lab/bench/bench_people.hpp"
#include "components/lab/bench/odometry_stand_in.hpp"
#include "components/lab/bench/people_bag.hpp"
#include "components/messages/people.hpp"
#include "components/people/files/person_labels.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/recording/replay/bag_run.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

Graph graph_for(const BenchPeopleArguments& arguments) {
  if (!arguments.graph.empty()) return load_graph(arguments.graph, arguments.set);
  Graph graph;
  graph.components.push_back({.name = "people", .type = "people"});
  for (const std::string& text : arguments.set) apply_override(graph, parse_override(text));
  return graph;
}

ComponentNode& component_of(Graph& graph, const std::string& name) {
  std::vector<ComponentNode*> found;
  for (ComponentNode& node : graph.components) {
    if (name.empty() ? node.type == "people" : node.name == name) found.push_back(&node);
  }
  if (found.size() == 1) return *found.front();
  if (!name.empty()) throw std::runtime_error("--component " + name + ": is not in the graph");
  throw std::runtime_error(
      fmt::format("--component: must name one, the graph has {} of type people", found.size()));
}

/// Labels as seen from odom.
std::vector<people::LabelledInstant> in_odom(const people::PersonLabels& labels, const PeopleTopics& topics,
                                             const PeopleFrames& bag_frames, double end) {
  const auto fail = [&](const people::PersonLabel& label, const std::string& what) {
    throw std::runtime_error(fmt::format("{}:{}: {}", labels.file, label.line, what));
  };
  const char* const column = labels.has_stamps ? "stamp" : "time";
  std::vector<people::LabelledInstant> instants;
  for (const people::PersonLabel& label : labels.rows) {
    const Time stamp =
        labels.has_stamps ? Time::seconds(label.time) : bag_frames.first_scan + Duration::seconds(label.time);
    const double time = labels.has_stamps ? (stamp - bag_frames.first_scan).to_seconds() : label.time;
    if (time < -0.5 || time > end + 0.5)
      fail(label,
           fmt::format("column {}: {} is not within the scans, which last {:.3f} s from {:.3f} on", column,
                       label.time, end, labels.has_stamps ? bag_frames.first_scan.to_seconds() : 0.0));
    const auto X_OF = bag_frames.in_odom(topics, label.frame, stamp);
    if (!X_OF)
      fail(label, fmt::format("column frame: no transform from '{}' to '{}' at that time in the bag",
                              label.frame, topics.odom_frame));
    if (instants.empty() || instants.back().time != time) instants.push_back({.time = time});
    instants.back().people.push_back({.id = label.id,
                                      .position = *X_OF * label.position,
                                      .counted = label.is_visible,
                                      .unoccluded = label.is_visible});
  }
  return instants;
}

class PeopleBench {
 public:
  PeopleBench(const bag::Bag& recording, const BenchPeopleArguments& arguments)
      : recording_(recording), arguments_(arguments), graph_(graph_for(arguments)) {
    ComponentNode& node = component_of(graph_, arguments.component);
    topics_ = choose_topics(recording_, graph_, node, arguments.scan, arguments.odom, arguments.is_standing);
    component_ = node.name;
    tracks_ = node.topic_of("tracks");
    for (const std::string& file : arguments.labels) labels_.push_back(people::read_person_labels(file));
  }

  PeopleRun run() {
    frames_ = read_frames(recording_, topics_);
    track();
    label();
    return std::move(run_);
  }

 private:
  void track() {
    std::vector<ExtraComponent> extra;
    if (topics_.odometry != OdometrySource::topic)
      extra.push_back(
          {.name = "odometry_stand_in", .component = make_odometry_stand_in(topics_), .first = true});
    replay::BagRunResult result =
        replay::run_on(recording_, graph_,
                       {.run = {component_}, .extra = std::move(extra), .on_output = [this](auto... sample) {
                          on_output(sample...);
                        }});
    run_.bag = std::filesystem::path(arguments_.bag).filename().string();
    run_.scans = frames_.scans;
    run_.notes = std::move(result.notes);
    if (result.malformed > 0)
      run_.notes.push_back(fmt::format("{} messages of the bag do not fit their type", result.malformed));
    if (run_.sweeps.empty()) throw std::runtime_error("no scan of " + topics_.scan + " could be looked at");
    run_.duration = run_.sweeps.back().time;
  }

  void on_output(const std::string& topic, Time, std::span<const std::uint8_t> cdr) {
    bandwagon_msgs::msg::Tracks message;
    if (topic != tracks_ || !deserialize(cdr, message)) return;
    const Time stamp = from_stamp(message.header().stamp());
    stamps_.insert(stamp);
    run_.sweeps.push_back({(stamp - frames_.first_scan).to_seconds(), people::from_tracks(message)});
    const auto X_OB = frames_.in_odom(topics_, topics_.base_frame, stamp);
    run_.robot.push_back(X_OB ? std::optional(X_OB->position()) : std::nullopt);
  }

  void label() {
    for (const people::PersonLabels& labels : labels_) {
      run_.stretches.push_back({.name = std::filesystem::path(labels.file).filename().string(),
                                .labels = in_odom(labels, topics_, frames_, run_.duration)});
    }
    if (labels_.empty() && arguments_.with_truth && !topics_.truth.empty()) {
      run_.is_truth = true;
      run_.stretches.push_back(
          {.name = topics_.truth,
           .labels = true_instants(recording_, topics_, frames_, arguments_.range, stamps_)});
    }
    for (LabelledStretch& stretch : run_.stretches)
      stretch.score = people::score_stretch(stretch.labels, run_.sweeps, arguments_.scoring);
  }

  const bag::Bag& recording_;
  const BenchPeopleArguments& arguments_;
  Graph graph_;
  PeopleTopics topics_;
  std::string component_;
  std::string tracks_;
  std::vector<people::PersonLabels> labels_;
  PeopleFrames frames_;
  std::set<Time> stamps_;
  PeopleRun run_;
};

}  // namespace

PeopleRun run_people(const bag::Bag& recording, const BenchPeopleArguments& arguments) {
  return PeopleBench(recording, arguments).run();
}

}  // namespace bw
