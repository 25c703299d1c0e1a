#include "runtime/transforms/transform_tree.hpp"

#include <algorithm>
#include <limits>

namespace bw {
namespace {

constexpr std::size_t kMaxDepth = 64;  // a longer chain is a loop
constexpr Duration kLatest = Duration::milliseconds(500);
constexpr int kConfirmations = 5;

Eigen::Isometry3d interpolate(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double share) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = (1.0 - share) * a.translation() + share * b.translation();
  result.linear() =
      Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear())).toRotationMatrix();
  return result;
}

}  // namespace

bool TransformTree::set(const std::string& parent, const std::string& child, Time stamp,
                        const Eigen::Isometry3d& X_PC, bool is_static) {
  if (parent.empty() || child.empty() || parent == child || !X_PC.matrix().allFinite()) return false;
  if (std::abs(X_PC.linear().determinant() - 1.0) > 1e-3) return false;
  Link& link = links_[child];
  if (link.parent != parent || link.is_static != is_static)
    link = {.parent = parent, .is_static = is_static, .samples = {}};
  const bool is_behind = !link.samples.empty() && stamp < link.samples.back().stamp - kLatest;
  link.behind = is_behind ? link.behind + 1 : 0;
  if (is_static || link.behind == kConfirmations) {
    link.samples.clear();
    link.behind = 0;
  }
  const auto later = std::ranges::upper_bound(link.samples, stamp, {}, &Stamped::stamp);
  if (later != link.samples.begin() && std::prev(later)->stamp == stamp) {
    std::prev(later)->X_PC = X_PC;
    return true;
  }
  if (!link.samples.empty() && stamp < link.samples.back().stamp - history_) return false;
  link.samples.insert(later, {stamp, X_PC});
  while (link.samples.front().stamp < link.samples.back().stamp - history_) link.samples.pop_front();
  return true;
}

std::vector<std::string> TransformTree::chain_to_root(const std::string& frame) const {
  std::vector<std::string> chain = {frame};
  for (auto link = links_.find(frame); link != links_.end() && chain.size() < kMaxDepth;
       link = links_.find(chain.back())) {
    chain.push_back(link->second.parent);
  }
  return chain;
}

std::optional<Eigen::Isometry3d> TransformTree::pose_in_ancestor(const std::string& frame,
                                                                 const std::string& ancestor,
                                                                 Time time) const {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (std::string at = frame; at != ancestor;) {
    const Link& link = links_.at(at);
    const auto& samples = link.samples;
    if (link.is_static) {
      X = samples.back().X_PC * X;
    } else {
      const auto after = std::ranges::lower_bound(samples, time, {}, &Stamped::stamp);
      if (after == samples.end() || (after == samples.begin() && after->stamp != time)) return std::nullopt;
      if (after->stamp == time) {
        X = after->X_PC * X;
      } else {
        const Stamped& before = *std::prev(after);
        const double share = (time - before.stamp).to_seconds() / (after->stamp - before.stamp).to_seconds();
        X = interpolate(before.X_PC, after->X_PC, share) * X;
      }
    }
    at = link.parent;
  }
  return X;
}

std::optional<TransformTree::Connection> TransformTree::connection(const std::string& target,
                                                                   const std::string& source) const {
  Connection found{.from_target = chain_to_root(target), .from_source = chain_to_root(source)};
  const auto ancestor = std::ranges::find_first_of(found.from_source, found.from_target);
  if (ancestor == found.from_source.end()) return std::nullopt;
  found.ancestor = *ancestor;
  return found;
}

Time TransformTree::newest_common(const Connection& connection) const {
  Time newest{std::numeric_limits<std::int64_t>::max()};
  for (const auto* chain : {&connection.from_target, &connection.from_source}) {
    for (const std::string& frame : *chain) {
      if (frame == connection.ancestor) break;
      const Link& link = links_.at(frame);
      if (!link.is_static) newest = std::min(newest, link.samples.back().stamp);
    }
  }
  return newest;
}

std::optional<Eigen::Isometry3d> TransformTree::lookup(const std::string& target, const std::string& source,
                                                       Time time) const {
  const std::optional<Connection> connected = connection(target, source);
  if (!connected) return std::nullopt;
  if (time == Time{}) time = newest_common(*connected);
  const auto X_AT = pose_in_ancestor(target, connected->ancestor, time);
  const auto X_AS = pose_in_ancestor(source, connected->ancestor, time);
  if (!X_AT || !X_AS) return std::nullopt;
  return X_AT->inverse() * *X_AS;
}

std::optional<Time> TransformTree::newest(const std::string& target, const std::string& source) const {
  const std::optional<Connection> connected = connection(target, source);
  return connected ? std::optional(newest_common(*connected)) : std::nullopt;
}

std::optional<Pose2> TransformTree::lookup_planar(const std::string& target, const std::string& source,
                                                  Time time) const {
  const auto X = lookup(target, source, time);
  if (!X) return std::nullopt;
  return planar(*X);
}

Pose2 planar(const Eigen::Isometry3d& X) {
  return {X.translation().x(), X.translation().y(), std::atan2(X.linear()(1, 0), X.linear()(0, 0))};
}

Eigen::Isometry3d spatial(const Pose2& X) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << X.x, X.y, 0.0;
  result.linear() = Eigen::AngleAxisd(X.theta, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return result;
}

}  // namespace bw
