#include "components/local_planner/adaptor/planner_process.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "components/messages/footprint.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/obstacles.hpp"
#include "components/messages/tracks.hpp"

namespace bw {
namespace {

constexpr const char* kFrame = "odom";
constexpr const char* kBase = "base_link";
/// Between two looks at whether it still runs.
constexpr auto kLook = std::chrono::milliseconds(20);

double seconds(std::chrono::milliseconds time) { return std::chrono::duration<double>(time).count(); }

}  // namespace

// Transient local on both sides: nothing is lost, whoever is known to the other first.
PlannerProcess::PlannerProcess(const std::string& program, const PlannerPatience& patience)
    : program_(program),
      patience_(patience),
      participant_({.network = {.domain_id = domain_.domain(), .transport = dds::Transport::localhost}}),
      answers_(participant_, "/cmd_vel", Qos::latched(), [this] { news_.ring(); }),
      odom_(participant_, "/odom", Qos::latched()),
      plan_(participant_, "/plan", Qos::latched()),
      tracks_(participant_, "/tracks", Qos::latched()),
      obstacles_(participant_, "/obstacles", Qos::latched()),
      footprint_(participant_, "/robot_footprint", Qos::latched()),
      speed_limit_(participant_, "/speed_limit", Qos::latched()),
      child_({.command = {program},
              .environment = {{"ROS_DOMAIN_ID", std::to_string(domain_.domain())}},
              .log = folder_.path() / "log.txt",
              .keeps_output = false,
              .is_apart = true}) {}

void PlannerProcess::publish(const PlanningProblem& problem) {
  const std_msgs::msg::Header header = make_header(kFrame, problem.now);
  nav_msgs::msg::Path path;
  path.header(header);
  for (const Pose2& pose : problem.plan) {
    geometry_msgs::msg::PoseStamped stamped;
    stamped.header(header);
    stamped.pose(to_pose(pose));
    path.poses().push_back(std::move(stamped));
  }
  plan_.publish(path);
  tracks_.publish(to_message(problem.movers, kFrame, problem.now));
  obstacles_.publish(to_message(problem.obstacles, Pose2{}, kFrame, problem.now));
  geometry_msgs::msg::PolygonStamped outline;
  outline.header(make_header(kBase, problem.now));
  outline.polygon(to_polygon(problem.footprint));
  footprint_.publish(outline);
  nav2_msgs::msg::SpeedLimit limit;
  limit.header(header);
  limit.speed_limit(problem.limits.v_max);
  speed_limit_.publish(limit);
  nav_msgs::msg::Odometry odometry;
  odometry.header(header);
  odometry.child_frame_id(kBase);
  odometry.pose().pose(to_pose(problem.pose));
  odometry.twist().twist(to_twist_message(problem.twist));
  odom_.publish(odometry);
}

std::optional<Twist2> PlannerProcess::take_answer(Time now) {
  while (const std::optional<geometry_msgs::msg::TwistStamped> answer = answers_.take()) {
    answered_ = from_stamp(answer->header().stamp());
    if (*answered_ != now) continue;
    const Twist2 twist = from_twist(answer->twist());
    if (!std::isfinite(twist.v) || !std::isfinite(twist.omega))
      fail(fmt::format("answered with a velocity that is no number: {} m/s, {} rad/s", twist.v, twist.omega));
    return twist;
  }
  return std::nullopt;
}

Twist2 PlannerProcess::ask(const PlanningProblem& problem) {
  using Clock = std::chrono::steady_clock;
  publish(problem);
  const std::chrono::milliseconds patience = answered_ ? patience_.answer : patience_.first;
  for (const auto limit = Clock::now() + patience; Clock::now() < limit; news_.wait(Clock::now() + kLook)) {
    if (const std::optional<Twist2> twist = take_answer(problem.now)) return *twist;
    if (const std::optional<int> status = child_.status()) fail(status_in_words(*status));
  }
  const std::string before =
      answered_ ? fmt::format("its last answer has {:.3f}", answered_->to_seconds())
      : answers_.writers() == 0
          ? "and it does not publish cmd_vel as geometry_msgs/TwistStamped, transient local"
          : "and nothing before";
  fail(fmt::format("does not answer: nothing with the stamp {:.3f} within {:g} s, {}",
                   problem.now.to_seconds(), seconds(patience), before));
}

void PlannerProcess::fail(const std::string& what) const {
  std::string words = last_words(folder_.path() / "log.txt");
  while (!words.empty() && words.back() == '\n') words.pop_back();
  throw std::runtime_error("planner process " + program_ + " " + what + (words.empty() ? "" : ": ") + words);
}

}  // namespace bw
