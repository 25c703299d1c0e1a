#include "components/lab/bench/people_bag.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/laser.hpp"
#include "components/people/score/sweep_view.hpp"
#include "runtime/recording/bag/known_type.hpp"
#include "runtime/transforms/transform_message.hpp"

namespace bw {
namespace {

constexpr std::string_view kScan = "sensor_msgs/msg/LaserScan";
constexpr std::string_view kOdometry = "nav_msgs/msg/Odometry";
constexpr std::string_view kTransforms = "tf2_msgs/msg/TFMessage";
constexpr std::string_view kTruth = "bandwagon_msgs/msg/GroundTruth";

/// Names of the topics of this type that hold messages, each once.
std::vector<std::string> topics_of(const bag::Bag& recording, std::string_view type) {
  std::vector<std::string> names;
  for (const bag::BagTopic& topic : recording.topics()) {
    const bool is_usable =
        topic.type == type && topic.message_count > 0 && bag::known_type(topic).type != nullptr;
    if (is_usable && std::ranges::find(names, topic.name) == names.end()) names.push_back(topic.name);
  }
  return names;
}

/// The asked one, the usual one, or the only one; empty: none, or the choice is not ours.
std::string choose(const std::vector<std::string>& there, const std::string& asked,
                   const std::string& usual) {
  const std::string& wanted = asked.empty() ? usual : asked;
  if (std::ranges::find(there, wanted) != there.end()) return wanted;
  return asked.empty() && there.size() == 1 ? there.front() : std::string();
}

[[noreturn]] void refuse(const std::string& option, const std::string& wanted, std::string_view type,
                         const std::vector<std::string>& there) {
  const std::string have = there.empty() ? "none of that type" : fmt::format("{}", fmt::join(there, ", "));
  throw std::runtime_error(
      fmt::format("{} {}: no such topic of type {} in the bag, which has {}", option, wanted, type, have));
}

void listen_to(ComponentNode& node, const std::string& declared, const std::string& topic) {
  if (node.topic_of(declared) == topic) return;
  std::erase_if(node.remaps, [&](const Remap& remap) { return remap.from == declared; });
  node.remaps.push_back({.from = declared, .to = topic});
}

/// Reads messages of one type of some topics, each with its own action.
class Reading {
 public:
  Reading(const bag::Bag& recording, std::set<std::string> topics) : recording_(recording) {
    messages_ = recording.messages({.topics = std::move(topics)});
  }
  bool next() {
    bag::Step step = messages_->next(message_);
    while (step == bag::Step::damaged) step = messages_->next(message_);
    return step == bag::Step::message;
  }
  bool is(std::string_view type) const { return recording_.topics()[message_.topic].type == type; }
  const std::string& topic() const { return recording_.topics()[message_.topic].name; }
  template <class Message>
  bool into(Message& message) const {
    return deserialize(message_.data, message);
  }

 private:
  const bag::Bag& recording_;
  std::unique_ptr<bag::BagMessages> messages_;
  bag::BagMessage message_;
};

class FrameReader {
 public:
  explicit FrameReader(const PeopleTopics& topics) : topics_(topics) {}

  void take(const Reading& reading) {
    if (reading.is(kScan)) {
      if (reading.into(scan_)) on_scan();
    } else if (reading.is(kOdometry)) {
      if (reading.into(odometry_)) on_odometry();
    } else if (reading.is(kTransforms)) {
      if (reading.into(transforms_)) on_transforms(reading.topic() == "/tf_static");
    } else if (bandwagon_msgs::msg::GroundTruth truth; reading.into(truth)) {
      TruthSample sample = to_truth(truth);
      if (is_sound(sample)) bag_frames.truth.push_back(std::move(sample));
    }
  }

  PeopleFrames bag_frames;

 private:
  void on_scan() {
    const Time stamp = from_stamp(scan_.header().stamp());
    if (bag_frames.scans++ > 0) return;
    bag_frames.first_scan = stamp;
    bag_frames.laser_frame = scan_.header().frame_id();
  }

  void on_odometry() {
    const Pose2 X_OB = from_pose(odometry_.pose().pose());
    if (is_finite(X_OB))
      set_frame(topics_.base_frame, from_stamp(odometry_.header().stamp()), spatial(X_OB), false);
  }

  void on_transforms(bool is_static) {
    for (const auto& t : transforms_.transforms()) {
      const bool is_base = t.child_frame_id() == topics_.base_frame;
      if (is_base && topics_.odometry != OdometrySource::transforms) continue;  // the odometry tells
      bag_frames.frames.set(t.header().frame_id(), t.child_frame_id(), from_stamp(t.header().stamp()),
                            to_isometry(t.transform()), is_static);
    }
  }

  void set_frame(const std::string& child, Time stamp, const Eigen::Isometry3d& X_OC, bool is_static) {
    bag_frames.frames.set(topics_.odom_frame, child, stamp, X_OC, is_static);
  }

  const PeopleTopics& topics_;
  sensor_msgs::msg::LaserScan scan_;
  nav_msgs::msg::Odometry odometry_;
  tf2_msgs::msg::TFMessage transforms_;
};

/// The truth between two looks at it; nothing outside of them.
std::optional<TruthSample> truth_at(const std::vector<TruthSample>& truth, Time time) {
  const auto next = std::ranges::lower_bound(truth, time, {}, &TruthSample::time);
  if (next == truth.end()) return std::nullopt;
  if (next->time == time) return *next;
  if (next == truth.begin()) return std::nullopt;
  const TruthSample& a = *(next - 1);
  const double share = (time - a.time).to_seconds() / (next->time - a.time).to_seconds();
  TruthSample sample = a;
  sample.time = time;
  sample.X_MB = {a.X_MB.x + share * (next->X_MB.x - a.X_MB.x), a.X_MB.y + share * (next->X_MB.y - a.X_MB.y),
                 wrap_angle(a.X_MB.theta + share * wrap_angle(next->X_MB.theta - a.X_MB.theta))};
  for (TruePerson& person : sample.people) {
    const auto later = std::ranges::find(next->people, person.id, &TruePerson::id);
    if (later == next->people.end()) continue;
    person.position += share * (later->position - person.position);
    person.velocity += share * (later->velocity - person.velocity);
  }
  return sample;
}

}  // namespace

PeopleTopics choose_topics(const bag::Bag& recording, Graph& graph, ComponentNode& node,
                           const std::string& scan, const std::string& odom, bool is_standing) {
  const std::string prefix = graph.settings.frame_prefix + (node.robot.empty() ? "" : node.robot + "/");
  PeopleTopics topics{.odom_frame = prefix + "odom", .base_frame = prefix + "base_link"};
  const std::vector<std::string> scans = topics_of(recording, kScan);
  topics.scan = choose(scans, scan, node.topic_of("scan"));
  if (topics.scan.empty()) refuse("--scan", scan.empty() ? node.topic_of("scan") : scan, kScan, scans);
  listen_to(node, "scan", topics.scan);

  const std::vector<std::string> odometries = topics_of(recording, kOdometry);
  topics.odom = is_standing ? "" : choose(odometries, odom, node.topic_of("odom"));
  if (is_standing) {
    topics.odometry = OdometrySource::standing;
  } else if (!topics.odom.empty()) {
    listen_to(node, "odom", topics.odom);
  } else if (odom.empty() && odometries.empty() && !topics_of(recording, kTransforms).empty()) {
    topics.odometry = OdometrySource::transforms;
  } else {
    refuse("--odom", odom.empty() ? node.topic_of("odom") : odom, kOdometry, odometries);
  }
  // What stands in for it speaks where nothing of the bag is heard.
  if (topics.odometry != OdometrySource::topic) listen_to(node, "odom", topics.odom = "/bench/odom");
  if (const auto truths = topics_of(recording, kTruth); !truths.empty())
    topics.truth = choose(truths, "", node.topic_of("sim/ground_truth"));
  return topics;
}

std::optional<Pose2> PeopleFrames::in_odom(const PeopleTopics& topics, const std::string& frame,
                                           Time time) const {
  if (frame == topics.odom_frame) return Pose2{};
  if (topics.odometry == OdometrySource::standing && frame == topics.base_frame) return Pose2{};
  if (const auto X_OF = frames.lookup_planar(topics.odom_frame, frame, time)) return X_OF;
  const bool is_unplaced = frame == laser_frame && !frames.lookup_planar(topics.base_frame, frame);
  return is_unplaced ? in_odom(topics, topics.base_frame, time) : std::nullopt;
}

PeopleFrames read_frames(const bag::Bag& recording, const PeopleTopics& topics) {
  FrameReader reader(topics);
  const Duration whole = recording.end() - recording.start() + Duration::seconds(1.0);
  reader.bag_frames.frames = TransformTree(whole);
  if (topics.odometry == OdometrySource::standing)
    reader.bag_frames.frames.set(topics.odom_frame, topics.base_frame, recording.start(),
                                 Eigen::Isometry3d::Identity(), true);
  Reading reading(recording, {topics.scan, topics.odom, topics.truth, "/tf", "/tf_static"});
  while (reading.next()) reader.take(reading);
  if (reader.bag_frames.scans == 0) throw std::runtime_error("no scan of " + topics.scan + " can be read");
  std::ranges::stable_sort(reader.bag_frames.truth, {}, &TruthSample::time);
  return std::move(reader.bag_frames);
}

std::vector<people::LabelledInstant> true_instants(const bag::Bag& recording, const PeopleTopics& topics,
                                                   const PeopleFrames& bag_frames, double range,
                                                   const std::set<Time>& stamps) {
  std::vector<people::LabelledInstant> instants;
  Reading reading(recording, {topics.scan});
  sensor_msgs::msg::LaserScan scan;
  while (reading.next()) {
    if (!reading.into(scan)) continue;
    const Time time = time_of(scan);
    const auto truth = truth_at(bag_frames.truth, time);
    const auto X_OB = bag_frames.in_odom(topics, topics.base_frame, time);
    const auto X_OL = bag_frames.in_odom(topics, scan.header().frame_id(), time);
    if (!stamps.contains(time) || !truth || !X_OB || !X_OL) continue;
    const Pose2 X_OM = *X_OB * inverse(truth->X_MB);
    people::LabelledInstant instant{.time = (time - bag_frames.first_scan).to_seconds()};
    for (const TruePerson& person : truth->people)
      instant.people.push_back({person.id, X_OM * person.position, rotate(X_OM, person.velocity)});
    people::look_for(to_sweep(scan, *X_OL), range, instant.people);
    instant.judged = Disc{X_OL->position(), range};
    instants.push_back(std::move(instant));
  }
  std::ranges::stable_sort(instants, {}, &people::LabelledInstant::time);
  return instants;
}

}  // namespace bw
