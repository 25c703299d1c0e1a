// The robot as a calibration sees it from outside: it is told velocities by `cmd_vel_teleop`, as a hand does,
// and tells its odometry, the angles of its wheels, why it stands, and, if a localization runs, where it is
// on the map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/joint_state.hpp>

#include "components/robot_base/calibration/measured_motion.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"
#include "runtime/ros/typed_topic.hpp"

namespace bw {

class RobotFront {
 public:
  /// `pose_topic`: of the localization; empty: none.
  RobotFront(const std::string& ns, const std::string& pose_topic);
  /// Ends at rest.
  ~RobotFront();
  RobotFront(const RobotFront&) = delete;
  RobotFront& operator=(const RobotFront&) = delete;

  void command(const Twist2& twist);
  /// Takes what has come.
  void hear(Time now);
  /// What keeps it from being driven; empty: nothing.
  std::string fault(Time now) const;

  const Pose2& X_OB() const { return X_OB_; }
  const Twist2& twist() const { return twist_; }
  const WheelRotations& angles() const { return angles_; }  ///< since the start of the base, unwrapped [rad]
  /// The newest one after `since`.
  std::optional<Pose2> pose_since(Time since) const;
  /// Speeds of the wheels over what they were told, of each time that they were told to turn steadily.
  const std::vector<double>& obedience() const { return obedience_; }

 private:
  void hear_base();

  dds::Participant participant_;
  TopicWriter<geometry_msgs::msg::Twist> commands_;
  TopicReader<nav_msgs::msg::Odometry> odometry_;
  TopicReader<sensor_msgs::msg::JointState> joints_;
  TopicReader<bandwagon_msgs::msg::BaseState> states_;
  std::optional<TopicReader<geometry_msgs::msg::PoseWithCovarianceStamped>> poses_;
  Pose2 X_OB_;
  Twist2 twist_;
  WheelRotations angles_;
  std::optional<Time> odometry_heard_, joints_heard_, pose_heard_;
  Pose2 pose_;
  std::optional<bandwagon_msgs::msg::BaseState> state_;
  std::vector<double> obedience_;
};

}  // namespace bw
