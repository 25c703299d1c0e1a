// A program that plans, as a process of its own: it is told of each control cycle on ROS 2's usual topics, in a DDS
// domain that nobody else is on, and answers with a velocity of the same stamp. Who asks waits for the answer, so that
// simulated time does too. Topics: components/local_planner/README.md.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <geometry_msgs/msg/polygon_stamped.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <nav2_msgs/msg/speed_limit.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/msg/path.hpp>

#include "components/model/planning.hpp"
#include "runtime/child_process.hpp"
#include "runtime/domain_lease.hpp"
#include "runtime/ros/notifier.hpp"
#include "runtime/ros/typed_topic.hpp"
#include "runtime/temporary_folder.hpp"

namespace bw {

/// In real time, whatever clock the drive is on: what takes longer counts as hung.
struct PlannerPatience {
  std::chrono::milliseconds first =
      std::chrono::seconds(60);  ///< for the first answer, with all that it loads
  std::chrono::milliseconds answer = std::chrono::seconds(10);  ///< for each after that
};

class PlannerProcess {
 public:
  /// Starts `program`, a path, with ROS_DOMAIN_ID. Throws std::runtime_error, as ask() does.
  explicit PlannerProcess(const std::string& program, const PlannerPatience& patience = {});

  /// The velocity that it answers with, finite. Throws std::runtime_error that says what happened when it ends, does
  /// not answer in time, or answers with what is no number; after that it is not to be asked again.
  Twist2 ask(const PlanningProblem& problem);

 private:
  void publish(const PlanningProblem& problem);
  /// The answer of the cycle that begins at `now`, if it has come.
  std::optional<Twist2> take_answer(Time now);
  [[noreturn]] void fail(const std::string& what) const;

  std::string program_;
  PlannerPatience patience_;
  DomainLease domain_;
  TemporaryFolder folder_;
  Notifier news_;
  dds::Participant participant_;
  TopicReader<geometry_msgs::msg::TwistStamped> answers_;
  TopicWriter<nav_msgs::msg::Odometry> odom_;
  TopicWriter<nav_msgs::msg::Path> plan_;
  TopicWriter<bandwagon_msgs::msg::Tracks> tracks_;
  TopicWriter<bandwagon_msgs::msg::Obstacles> obstacles_;
  TopicWriter<geometry_msgs::msg::PolygonStamped> footprint_;
  TopicWriter<nav2_msgs::msg::SpeedLimit> speed_limit_;
  std::optional<Time> answered_;  ///< the cycle that its last answer was for
  ChildProcess child_;
};

}  // namespace bw
