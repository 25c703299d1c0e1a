// What of a bag people are tracked in again: its scans, what tells where the robot was, and what its world
// knows of them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "components/evaluation/truth_sample.hpp"
#include "components/people/score/labelled_paths.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

enum class OdometrySource {
  topic,       ///< nav_msgs/Odometry
  transforms,  ///< the robot's base in odom, in /tf
  standing,    ///< the robot does not move
};

struct PeopleTopics {
  std::string scan;
  std::string odom;   ///< where the component hears it
  std::string truth;  ///< bandwagon_msgs/GroundTruth; empty: there is none
  OdometrySource odometry = OdometrySource::topic;
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
};

/// The topics of the bag for `node`, which is made to listen to them. `scan`, `odom`: names in the bag;
/// empty: the component's own, or the only one of its type. Throws std::runtime_error naming what is missing
/// and what is there.
PeopleTopics choose_topics(const bag::Bag& recording, Graph& graph, ComponentNode& node,
                           const std::string& scan, const std::string& odom, bool is_standing);

/// Frames over the whole bag, and the truth.
struct PeopleFrames {
  TransformTree frames;
  Time first_scan;
  std::size_t scans = 0;
  std::string laser_frame;
  std::vector<TruthSample> truth;  ///< by time

  /// X_OF at `time`; a laser that nobody placed is at the robot's base. Nothing when it is not known.
  std::optional<Pose2> in_odom(const PeopleTopics& topics, const std::string& frame, Time time) const;
};

/// Throws std::runtime_error for a bag without a single scan.
PeopleFrames read_frames(const bag::Bag& recording, const PeopleTopics& topics);

/// Everybody at the sweeps of these stamps, in odom, as the world knew them; who counts: `look_for`
/// (sweep_view.hpp).
std::vector<people::LabelledInstant> true_instants(const bag::Bag& recording, const PeopleTopics& topics,
                                                   const PeopleFrames& bag_frames, double range,
                                                   const std::set<Time>& stamps);

}  // namespace bw
