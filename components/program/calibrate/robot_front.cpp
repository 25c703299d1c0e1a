#include "components/program/calibrate/robot_front.hpp"

#include <algorithm>
#include <cmath>

#include "components/messages/geometry.hpp"
#include "components/messages/wheel_joints.hpp"
#include "runtime/graph/names.hpp"

namespace bw {
namespace {

std::string below(const std::string& ns, const std::string& topic) {
  return join_namespaces(join_namespaces("/", ns), topic);
}

}  // namespace

RobotFront::RobotFront(const std::string& ns, const std::string& pose_topic)
    : participant_({.network = dds::Network::from_environment(dds::Transport::localhost)}),
      commands_(participant_, below(ns, "cmd_vel_teleop"), Qos::command()),
      odometry_(participant_, below(ns, "odom")),
      joints_(participant_, below(ns, "joint_states")),
      states_(participant_, below(ns, "base_state")) {
  if (!pose_topic.empty()) poses_.emplace(participant_, below(ns, pose_topic));
}

RobotFront::~RobotFront() {
  for (int i = 0; i < 3; ++i) command({});
  commands_.flush(Duration::milliseconds(500));
}

void RobotFront::command(const Twist2& twist) {
  geometry_msgs::msg::Twist message;
  message.linear().x(twist.v);
  message.angular().z(twist.omega);
  commands_.publish(message);
}

void RobotFront::hear(Time now) {
  while (const auto odometry = odometry_.take()) {
    X_OB_ = from_pose(odometry->pose().pose());
    twist_ = {odometry->twist().twist().linear().x(), odometry->twist().twist().angular().z()};
    odometry_heard_ = now;
  }
  while (const auto joints = joints_.take()) {
    const auto& names = joints->name();
    if (joints->position().size() != 2 || names.size() != 2) continue;
    const std::size_t left = names[0] == wheel_joint_names()[0] ? 0 : 1;
    angles_ = {joints->position()[left], joints->position()[1 - left]};
    joints_heard_ = now;
  }
  while (poses_) {
    const auto pose = poses_->take();
    if (!pose) break;
    pose_ = from_pose(pose->pose().pose());
    pose_heard_ = now;
  }
  hear_base();
}

void RobotFront::hear_base() {
  constexpr double kSlowest = 0.1;  // [m/s]
  constexpr double kSteady = 0.03;  // [m/s] between two states
  while (auto state = states_.take()) {
    const bool is_steady = state_ && std::abs(state_->commanded_left() - state->commanded_left()) < kSteady &&
                           std::abs(state_->commanded_right() - state->commanded_right()) < kSteady;
    if (is_steady &&
        std::min(std::abs(state->commanded_left()), std::abs(state->commanded_right())) > kSlowest) {
      obedience_.push_back(state->measured_left() / state->commanded_left());
      obedience_.push_back(state->measured_right() / state->commanded_right());
    }
    state_ = std::move(state);
  }
}

std::string RobotFront::fault(Time now) const {
  constexpr Duration kSilence = Duration::milliseconds(500);
  namespace base = bandwagon_msgs::msg::BaseState_Constants;
  if (commands_.readers() == 0) return "nobody hears cmd_vel_teleop: no robot, or no twist_mux, is running";
  if (!odometry_heard_ || now - *odometry_heard_ > kSilence) return "odom is silent";
  if (!joints_heard_ || now - *joints_heard_ > kSilence) return "joint_states is silent";
  if (state_ && state_->state() >= base::BACKING_OFF) return "the base has stopped: " + state_->reason();
  return {};
}

std::optional<Pose2> RobotFront::pose_since(Time since) const {
  return pose_heard_ && *pose_heard_ > since ? std::optional(pose_) : std::nullopt;
}

}  // namespace bw
