// Tells ten times a second how near the robot is to people: by the world's truth, and where nobody ever told
// that, as on a real robot, by the tracks of people and the robot's odometry.
#pragma once

#include <optional>
#include <string>

#include <bandwagon_msgs/msg/comfort.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/evaluation/truth_sample.hpp"
#include "components/messages/current_footprint.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Lives in the component whose setup it is given.
class ComfortOutput {
 public:
  /// `robot` must outlive it.
  void offer(Setup& setup, const CurrentFootprint& robot);
  void on_truth(const TruthSample& sample);
  /// Where the robot believes to be in map.
  void on_pose(const nav_msgs::msg::Odometry& odometry) { filtered_ = odometry; }
  /// What is new since the last call; nothing without news. `contacts`: of the drive.
  void tell(int contacts);

 private:
  /// Robot and people in the frame of the tracks, at the time of the odometry in that frame. Nothing while
  /// either is missing or much older than the other.
  std::optional<TruthSample> believed() const;

  const CurrentFootprint* robot_ = nullptr;
  std::string map_frame_;
  bool has_truth_ = false;
  std::optional<TruthSample> truth_;  ///< not told yet
  std::optional<Time> told_;          ///< time of the tracks told last
  std::optional<nav_msgs::msg::Odometry> filtered_;
  Latest<nav_msgs::msg::Odometry> odometry_;
  Latest<bandwagon_msgs::msg::Tracks> tracks_;
  Output<bandwagon_msgs::msg::Comfort> output_;
};

}  // namespace bw
