#include "tests/interop/nav2_tree/foreign_servers.hpp"

#include <algorithm>
#include <cmath>

namespace nav2 {
namespace {

constexpr double kStep = 0.05;        // [m] between poses of a path
constexpr double kLookahead = 0.6;    // [m]
constexpr double kSpeed = 0.5;        // [m/s]
constexpr double kMaxTurnRate = 1.0;  // [rad/s]
constexpr double kTolerance = 0.25;   // [m] Nav2's xy_goal_tolerance

plain::ServiceType clear_type() { return {"nav2_msgs/srv/ClearEntireCostmap", "", ""}; }

void answer_clear(plain::Server& clear) {
  while (const auto request = clear.take())
    clear.reply(request->from, CdrOut().number(std::uint8_t{0}).bytes());
}

void write_error(CdrOut& out, std::uint16_t code, const std::string& text) { out.number(code).text(text); }

void write_plan(CdrOut& out, const Path& path, std::uint16_t code, const std::string& text) {
  write(out, path);
  out.number(std::int32_t{0}).number(std::uint32_t{0});
  write_error(out, code, text);
}

/// Stamps differ from plan to plan, as a clock's do.
Path straight_path(const Pose& from, const Pose& to, int number) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double yaw = std::atan2(to.y - from.y, to.x - from.x);
  const int steps = std::max(1, static_cast<int>(length / kStep));
  Path path{.header = {.stamp = {.sec = number}}, .poses = {}};
  for (int i = 0; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    path.poses.push_back(
        {path.header, Pose::of(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), yaw)});
  }
  path.poses.push_back({path.header, to});
  return path;
}

CdrIn behind_id(const Bytes& request) {
  CdrIn in(request);
  in.take(std::tuple_size_v<plain::GoalId>);
  return in;
}

double distance(const Pose& a, const Pose& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

ForeignPlanner::ForeignPlanner(plain::Node& node, Frames& frames)
    : frames_(frames),
      to_pose_(node, "/compute_path_to_pose", plain::action_type("nav2_msgs/action/ComputePathToPose"),
               [](CdrOut& out) { write_plan(out, {}, 0, ""); }),
      through_poses_(node, "/compute_path_through_poses",
                     plain::action_type("nav2_msgs/action/ComputePathThroughPoses"),
                     [](CdrOut& out) { write_plan(out, {}, 0, ""); }),
      clear_(node, "/global_costmap/clear_entirely_global_costmap", clear_type()) {}

void ForeignPlanner::poll() {
  answer_clear(clear_);
  answer(to_pose_, seen_to_pose_, [](CdrIn& in) { return read_pose_stamped(in).pose; });
  answer(through_poses_, seen_through_poses_, [](CdrIn& in) {
    Pose last;
    for (auto left = in.number<std::uint32_t>(); left > 0; --left) last = read_pose_stamped(in).pose;
    return last;
  });
}

void ForeignPlanner::answer(plain::ActionServer& server, std::size_t& seen, Pose (*last_of)(CdrIn&)) {
  server.answer();
  for (; seen < server.goals().size(); ++seen) {
    const plain::GoalId id = server.goals()[seen].state.info.id;
    CdrIn in = behind_id(server.goals()[seen].bytes);
    const Pose to = last_of(in);
    const auto from = frames_.pose();
    server.execute(id);
    server.finish(id, from ? plain::GoalStatus::succeeded : plain::GoalStatus::aborted, [&](CdrOut& out) {
      if (from) {
        write_plan(out, straight_path(*from, to, ++plans_), 0, "");
      } else {
        write_plan(out, {}, 202, "no pose of base_link in map");
      }
    });
  }
}

ForeignController::ForeignController(plain::Node& node, Frames& frames, const std::string& topic)
    : frames_(frames),
      server_(node, "/follow_path", plain::action_type("nav2_msgs/action/FollowPath"),
              [](CdrOut& out) { write_error(out.number(std::uint8_t{0}), 0, ""); }),
      clear_(node, "/local_costmap/clear_entirely_local_costmap", clear_type()),
      out_(node.create_writer({.topic = "rt/" + topic,
                               .type = "geometry_msgs::msg::dds_::Twist_",
                               .type_hash = {},
                               .depth = 1})) {
  node.announce();
}

void ForeignController::poll() {
  answer_clear(clear_);
  server_.answer();
  for (; seen_ < server_.goals().size(); ++seen_) {
    const plain::GoalId id = server_.goals()[seen_].state.info.id;
    CdrIn in = behind_id(server_.goals()[seen_].bytes);
    path_ = read_path(in);
    if (goal_) {
      ++preemptions_;
      finish(plain::GoalStatus::aborted);
    }
    goal_ = id;
    server_.execute(id);
  }
  if (goal_ && server_.find(*goal_)->state.status == plain::GoalStatus::canceling) {
    command(0.0, 0.0);
    finish(plain::GoalStatus::canceled);
  }
}

void ForeignController::control() {
  if (!goal_) return;
  const auto pose = frames_.pose();
  if (!pose || path_.poses.empty()) return command(0.0, 0.0);
  if (distance(*pose, path_.poses.back().pose) < kTolerance) {
    command(0.0, 0.0);
    return finish(plain::GoalStatus::succeeded);
  }
  const auto ahead = std::ranges::find_if(
      path_.poses, [&](const PoseStamped& p) { return distance(*pose, p.pose) >= kLookahead; });
  const Pose aim = ahead == path_.poses.end() ? path_.poses.back().pose : ahead->pose;
  const double bearing =
      std::remainder(std::atan2(aim.y - pose->y, aim.x - pose->x) - pose->yaw(), 2.0 * M_PI);
  const double speed = std::abs(bearing) > 1.0 ? 0.0 : kSpeed;
  command(speed,
          std::clamp(2.0 * std::sin(bearing) * kSpeed / distance(*pose, aim), -kMaxTurnRate, kMaxTurnRate));
  server_.feedback(*goal_, CdrOut()
                               .number(static_cast<float>(distance(*pose, path_.poses.back().pose)))
                               .number(static_cast<float>(speed))
                               .bytes());
}

void ForeignController::command(double speed, double angular) {
  CdrOut out;
  for (const double value : {speed, 0.0, 0.0, 0.0, 0.0, angular}) out.number(value);
  Bytes bytes = out.bytes();
  out_->write(&bytes);
}

void ForeignController::finish(plain::GoalStatus status) {
  server_.finish(*goal_, status, [](CdrOut& out) { write_error(out.number(std::uint8_t{0}), 0, ""); });
  goal_.reset();
}

}  // namespace nav2
