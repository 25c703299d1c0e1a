#include "components/local_planner/follow_path/received_path.hpp"

#include <cmath>

namespace bw {
namespace {

constexpr double kSpacing = 0.01;  // [m]

bool has_position(const Pose2& X) { return std::isfinite(X.x) && std::isfinite(X.y); }

std::string fault_in(const std::vector<Pose2>& path) {
  if (path.empty()) return "the path is empty";
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!has_position(path[i])) return "pose " + std::to_string(i) + " of the path is not finite";
  }
  if (!is_finite(path.back())) return "the last pose of the path has no orientation";
  return {};
}

}  // namespace

ReceivedPath received_path(const std::vector<Pose2>& path) {
  ReceivedPath received{.poses = {}, .index = {}, .fault = fault_in(path)};
  if (!received.fault.empty()) return received;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vector2 here = path[i].position();
    const bool is_near_last =
        !received.poses.empty() && (here - received.poses.back().position()).norm() < kSpacing;
    const bool is_near_goal = (path.back().position() - here).norm() < kSpacing;
    if (is_near_last || is_near_goal) continue;
    received.poses.push_back(path[i]);
    received.index.push_back(i);
  }
  received.poses.push_back(path.back());
  received.index.push_back(path.size() - 1);
  for (std::size_t i = 0; i + 1 < received.poses.size(); ++i) {
    const Vector2 along = received.poses[i + 1].position() - received.poses[i].position();
    received.poses[i].theta = std::atan2(along.y(), along.x());
  }
  return received;
}

PathOffset path_offset(const std::vector<Pose2>& poses, std::size_t index, const Pose2& X_PB) {
  const Vector2 beside = rotate(inverse(poses[index]), X_PB.position() - poses[index].position());
  return {beside.y(), wrap_angle(poses[index].theta - X_PB.theta)};
}

}  // namespace bw
