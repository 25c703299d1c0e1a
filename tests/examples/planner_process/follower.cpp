// A planner as a process of its own: follows the plan on arcs (pure pursuit, Coulter 1992), slower behind people and
// before them. follower.py is the same in Python. All that has one stamp is of one control cycle; the answer is a
// velocity with that stamp.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <components/messages/geometry.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/msg/path.hpp>
#include <runtime/ros/notifier.hpp>
#include <runtime/ros/typed_topic.hpp>

namespace {

constexpr double kSpeed = 0.7;      // [m/s]
constexpr double kLookahead = 1.2;  // [m]
constexpr double kTurnRate = 1.0;   // [rad/s]
constexpr double kBraking = 0.5;    // [m/s^2]
constexpr double kHalfWidth = 0.5;  // of the robot with room beside it [m]
constexpr double kGap = 0.5;        // kept before people [m]

/// From which braking ends within the gap.
double speed_for(double gap) { return std::sqrt(2.0 * kBraking * std::max(gap, 0.0)); }

bw::Vector2 point_of(const geometry_msgs::msg::PoseStamped& pose) {
  return {pose.pose().position().x(), pose.pose().position().y()};
}

/// Everything in one frame; the plan is not empty.
bw::Twist2 velocity(const nav_msgs::msg::Odometry& odom, const nav_msgs::msg::Path& plan,
                    const bandwagon_msgs::msg::Tracks& tracks) {
  const bw::Pose2 robot = bw::from_pose(odom.pose().pose());
  const auto is_far = [&](const auto& pose) {
    return (point_of(pose) - robot.position()).norm() > kLookahead;
  };
  const auto found = std::ranges::find_if(plan.poses(), is_far);
  const bw::Vector2 end = point_of(plan.poses().back());
  const bw::Vector2 aim = bw::inverse(robot) * (found == plan.poses().end() ? end : point_of(*found));
  if (aim.x() <= 0.0) return {0.0, std::copysign(kTurnRate, aim.y())};
  // The arc from the robot's heading through a point of its frame.
  const double curvature = 2.0 * aim.y() / aim.squaredNorm();
  double speed = std::min(
      {kSpeed, kTurnRate / std::max(std::abs(curvature), 1e-6), speed_for((end - robot.position()).norm())});
  for (const auto& track : tracks.tracks()) {
    const bw::Vector2 place = bw::inverse(robot) * bw::Vector2(track.position().x(), track.position().y());
    const double approach =
        bw::direction(robot.theta).dot(bw::Vector2(track.velocity().x(), track.velocity().y()));
    if (track.confidence() < 0.5 || place.x() <= 0.0 || std::abs(place.y()) >= kHalfWidth + track.radius())
      continue;
    const double in_a_second = place.x() - track.radius() + std::min(approach, 0.0);
    speed = std::min(speed, speed_for(in_a_second - kHalfWidth - kGap));
  }
  return {speed, speed * curvature};
}

/// The newest message of a topic.
template <class M>
struct Newest {
  Newest(bw::dds::Participant& participant, const std::string& topic, bw::Notifier& news)
      : reader(participant, topic, bw::Qos::latched(), [&news] { news.ring(); }) {}

  void look() {
    if (std::optional<M> next = reader.take_newest()) message = next;
  }
  bool is_of(const builtin_interfaces::msg::Time& stamp) const {
    return message && bw::from_stamp(message->header().stamp()) == bw::from_stamp(stamp);
  }

  bw::TopicReader<M> reader;
  std::optional<M> message;
};

void serve() {
  bw::Notifier news;
  bw::dds::ParticipantOptions options;
  options.network = bw::dds::Network::from_environment(bw::dds::Transport::localhost);
  bw::dds::Participant participant(options);
  Newest<nav_msgs::msg::Odometry> odom(participant, "/odom", news);
  Newest<nav_msgs::msg::Path> plan(participant, "/plan", news);
  Newest<bandwagon_msgs::msg::Tracks> tracks(participant, "/tracks", news);
  bw::TopicWriter<geometry_msgs::msg::TwistStamped> cmd_vel(participant, "/cmd_vel", bw::Qos::latched());
  geometry_msgs::msg::TwistStamped answer;
  answer.header().frame_id("base_link");
  while (true) {
    news.wait(std::chrono::steady_clock::now() + std::chrono::seconds(1));
    odom.look();
    plan.look();
    tracks.look();
    if (!odom.message || odom.is_of(answer.header().stamp())) continue;  // answered already
    const builtin_interfaces::msg::Time now = odom.message->header().stamp();
    if (!plan.is_of(now) || !tracks.is_of(now)) continue;
    answer.header().stamp(now);
    answer.twist(bw::to_twist_message(velocity(*odom.message, *plan.message, *tracks.message)));
    cmd_vel.publish(answer);
  }
}

}  // namespace

int main() {
  try {
    serve();
  } catch (const std::exception& error) {
    std::cerr << "follower: " << error.what() << "\n";
    return 1;
  }
}
