#include "components/program/score_bag.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <fmt/format.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/messages/footprint.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/obstacles.hpp"
#include "components/model/mover_weight.hpp"
#include "runtime/recording/bag/known_type.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::GroundTruth;
using bandwagon_msgs::msg::NavigationStatus;
using bandwagon_msgs::msg::Tracks;
using geometry_msgs::msg::PolygonStamped;
using nav_msgs::msg::Odometry;

constexpr double kTopSpeed = 1.0;                                // only a picture's colours need it [m/s]
constexpr Duration kForgetsPose = Duration::milliseconds(1000);  // a claim is not judged by an older truth
constexpr double kMissedBeginning = 1.0;  // [s] of a drive that are not in the bag, and said
constexpr Duration kForgetsPeople =
    Duration::milliseconds(500);  // tracks older than this are not people any more

bool has_messages(const bag::BagTopic& topic, std::string_view type) {
  return topic.type == type && topic.message_count > 0 && bag::known_type(topic).type != nullptr;
}

/// Number of the topic of this type, of the first of the names that is there, else of any name.
std::optional<std::size_t> find_topic(const bag::Bag& recording, std::string_view type,
                                      const std::vector<std::string>& names = {}) {
  const auto& topics = recording.topics();
  std::optional<std::size_t> any;
  for (std::size_t i = topics.size(); i-- > 0;) {
    if (has_messages(topics[i], type)) any = i;
  }
  for (const std::string& name : names) {
    for (std::size_t i = 0; i < topics.size(); ++i) {
      if (topics[i].name == name && has_messages(topics[i], type)) return i;
    }
  }
  return any;
}

/// Number of the topic of exactly this name and type.
std::optional<std::size_t> find_named(const bag::Bag& recording, std::string_view type,
                                      const std::string& name) {
  const auto found = find_topic(recording, type, {name});
  return found && recording.topics()[*found].name == name ? found : std::nullopt;
}

/// Which topics tell what.
struct Sources {
  std::optional<std::size_t> truth, status, belief, odometry, tracks, footprint, map, true_map, shapes;

  explicit Sources(const bag::Bag& recording)
      : truth(find_topic(recording, "bandwagon_msgs/msg/GroundTruth")),
        status(find_topic(recording, "bandwagon_msgs/msg/NavigationStatus")),
        belief(find_topic(recording, "nav_msgs/msg/Odometry", {"/odometry/filtered", "/odom"})),
        odometry(find_topic(recording, "nav_msgs/msg/Odometry", {"/odom"})),
        tracks(find_topic(recording, "bandwagon_msgs/msg/Tracks")),
        footprint(find_named(recording, "geometry_msgs/msg/PolygonStamped", "/robot_footprint")),
        map(find_named(recording, "nav_msgs/msg/OccupancyGrid", "/map")),
        true_map(find_named(recording, "nav_msgs/msg/OccupancyGrid", "/sim/map")),
        shapes(find_named(recording, "bandwagon_msgs/msg/Obstacles", "/sim/obstacles")) {}
};

class Scorer {
 public:
  Scorer(const bag::Bag& recording, const Footprint& robot, const std::optional<Limits>& limits)
      : recording_(recording), from_(recording), judge_({}, robot, kTopSpeed) {
    if (limits) judge_.recorder().set_limits(*limits);
    if (!from_.truth && !from_.belief)
      throw std::runtime_error(
          "the bag holds neither a ground truth nor an odometry: nothing tells where the robot was");
    const auto name = [&](std::size_t topic) { return recording.topics()[topic].name; };
    if (from_.truth) {
      score_.judged_by = "ground truth " + name(*from_.truth);
    } else {
      score_.judged_by =
          "the robot's own " + name(*from_.belief) + (from_.tracks ? " and " + name(*from_.tracks) : "");
      score_.notes.emplace_back(
          "without a ground truth: distances are estimates, walls and the error of the pose are not judged");
      if (!from_.tracks) score_.notes.emplace_back("no tracks: people are not judged");
    }
    for (const bag::BagTopic& topic : recording.topics()) {
      if (const bag::KnownType known = bag::known_type(topic); !known.why.empty())
        score_.notes.push_back(topic.name + " is not used: " + known.why);
    }
    if (!from_.status)
      score_.notes.emplace_back("no navigation status: the whole bag is one drive, without a goal");
  }

  BagScore run() {
    const auto messages = recording_.messages({});
    bag::BagMessage m;
    for (bag::Step step = messages->next(m); step != bag::Step::end; step = messages->next(m)) {
      if (step == bag::Step::damaged) {
        const bag::BagFault fault = messages->fault();
        score_.notes.push_back(fmt::format("{}: byte {}: {}", fault.file.string(), fault.offset, fault.what));
      } else {
        take(m);
      }
    }
    finish();
    return std::move(score_);
  }

 private:
  void take(const bag::BagMessage& m) {
    now_ = m.log_time;
    if (m.topic == from_.truth)
      read<GroundTruth>(m, [&](const auto& message) { on_truth(to_truth(message)); });
    if (m.topic == from_.map || m.topic == from_.true_map || m.topic == from_.shapes) hear_map(m);
    if (m.topic == from_.footprint)
      read<PolygonStamped>(m, [&](const auto& message) { on_footprint(message); });
    if (m.topic == from_.status) read<NavigationStatus>(m, [&](const auto& message) { on_status(message); });
    if (m.topic == from_.tracks && !from_.truth)
      read<Tracks>(m, [&](const auto& message) { on_tracks(message); });
    if (m.topic == from_.odometry || m.topic == from_.belief)
      read<Odometry>(m, [&](const auto& message) { on_odometry(m.topic, message); });
  }

  template <class Message, class Action>
  void read(const bag::BagMessage& m, Action action) {
    Message message;
    if (deserialize(m.data, message)) {
      action(message);
    } else {
      ++malformed_;
    }
  }

  /// What stands about; of use beside the truth, which is in map too.
  void hear_map(const bag::BagMessage& m) {
    if (!from_.truth) return;
    if (m.topic == from_.shapes) {
      read<bandwagon_msgs::msg::Obstacles>(
          m, [&](const auto& message) { judge_.recorder().set_shapes(to_obstacles(message, Pose2{})); });
      return;
    }
    read<nav_msgs::msg::OccupancyGrid>(m, [&](const auto& message) {
      OccupancyGrid map;
      if (!read_grid(message, map).empty()) return;
      if (m.topic == from_.true_map) judge_.recorder().set_true_map(map);
      if (m.topic == from_.map) judge_.recorder().set_map(map);
    });
  }

  void on_footprint(const PolygonStamped& message) {
    const FootprintResult told = to_polygon_or_disc(message.polygon());
    if (told.fault.empty()) judge_.on_footprint(told.footprint);
  }

  void on_status(const NavigationStatus& message) {
    const GoalNews news = to_goal_news(message);
    if (!std::exchange(heard_status_, true) && !news.is_over) tell_of_missed_beginning(message);
    if (judge_.is_preempting(news)) end_unfinished(fmt::format("preempted by goal {}", news.goal_id));
    if (now_ - sampled_at_ > kForgetsPose || !is_in_frame_of(message)) judge_.lose_pose();
    if (judge_.on_goal(news, now_)) keep();
  }

  /// The status is latched: the first one may be of a drive that began before the bag.
  void tell_of_missed_beginning(const NavigationStatus& message) {
    const double driven = message.navigation_time().sec() + 1e-9 * message.navigation_time().nanosec();
    if (driven > kMissedBeginning)
      score_.notes.push_back(fmt::format(
          "the bag begins {:.1f} s into the drive to goal {}: what was before is not judged, and in no figure",
          driven, message.goal_id()));
  }

  /// A position in odom tells nothing of a goal in map. The truth is in map.
  bool is_in_frame_of(const NavigationStatus& message) {
    const std::string& frame = message.header().frame_id();
    if (from_.truth || frame.empty() || belief_frame_.empty() || frame == belief_frame_) return true;
    foreign_goal_frame_ = frame;
    return false;
  }

  void on_truth(const TruthSample& sample) {
    sampled_at_ = now_;
    if (!from_.status && !judge_.running()) judge_.begin_run(now_);
    judge_.on_truth(sample);
  }

  void on_odometry(std::size_t topic, const Odometry& message) {
    const Pose2 X_FB = from_pose(message.pose().pose());
    X_FB_[message.header().frame_id()] = X_FB;
    if (topic != from_.belief) return;
    const Time stamp = from_stamp(message.header().stamp());
    if (from_.truth) {
      judge_.on_pose(stamp, X_FB);
      return;
    }
    belief_frame_ = message.header().frame_id();
    TruthSample sample;
    sample.time = stamp;
    sample.X_MB = X_FB;
    sample.twist = from_twist(message.twist().twist());
    sample.wall_gap = std::numeric_limits<double>::infinity();
    if (now_ - tracked_at_ <= kForgetsPeople) sample.people = people_in(message.header().frame_id());
    on_truth(sample);
  }

  void on_tracks(const Tracks& message) {
    tracks_ = message;
    tracked_at_ = now_;
  }

  /// The tracks in another frame, by way of the robot, whose pose is known in both.
  std::vector<TruePerson> people_in(const std::string& frame) {
    const auto there = X_FB_.find(tracks_.header().frame_id());
    const auto here = X_FB_.find(frame);
    if (there == X_FB_.end() || here == X_FB_.end()) {
      lost_frame_ = tracks_.header().frame_id();
      return {};
    }
    const Pose2 X_HT = here->second * inverse(there->second);
    std::vector<TruePerson> people;
    for (const auto& track : tracks_.tracks()) {
      if (!is_confirmed(track.confidence())) continue;
      people.push_back({track.id(), X_HT * Vector2(track.position().x(), track.position().y()),
                        Eigen::Rotation2Dd(X_HT.theta) * Vector2(track.velocity().x(), track.velocity().y()),
                        track.radius()});
    }
    return people;
  }

  void keep() {
    const RunRecording& recording = judge_.recorder().recording();
    score_.drives.push_back({judge_.card(), judge_.pose_errors(), judge_contacts(recording),
                             from_.status.has_value(), !recording.moments.empty()});
  }

  void end_unfinished(const std::string& reason) {
    judge_.end_run(now_);
    keep();
    if (from_.status) score_.drives.back().card.reason = reason;
  }

  void finish() {
    if (judge_.running()) {
      end_unfinished("the bag ends before the drive");
      score_.drives.back().card.is_outcome_known = !from_.status;
    }
    if (malformed_ > 0) score_.notes.push_back(fmt::format("{} messages do not fit their types", malformed_));
    if (lost_frame_)
      score_.notes.push_back("tracks are in frame '" + *lost_frame_ +
                             "', which no odometry tells of: people are not judged");
    if (foreign_goal_frame_)
      score_.notes.push_back(
          fmt::format("{} is in frame '{}', goals are in '{}': whether they were reached is not known",
                      recording_.topics()[*from_.belief].name, belief_frame_, *foreign_goal_frame_));
  }

  const bag::Bag& recording_;
  Sources from_;
  DriveJudge judge_;
  BagScore score_;
  Time now_;
  std::map<std::string, Pose2> X_FB_;  ///< by frame: base_link in it
  Tracks tracks_;
  Time tracked_at_{std::numeric_limits<std::int64_t>::min() / 2};
  std::optional<std::string> lost_frame_;
  std::uint64_t malformed_ = 0;
  Time sampled_at_{std::numeric_limits<std::int64_t>::min() / 2};
  bool heard_status_ = false;
  std::string belief_frame_;
  std::optional<std::string> foreign_goal_frame_;
};

}  // namespace

BagScore score_bag(const bag::Bag& recording, const Footprint& robot, const std::optional<Limits>& limits) {
  return Scorer(recording, robot, limits).run();
}

}  // namespace bw
