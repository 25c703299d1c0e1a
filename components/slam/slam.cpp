#include "components/slam/slam.hpp"

namespace bw::slam {

Slam::Slam(const SlamOptions& options)
    : tracking_(options), nodes_(std::make_unique<std::deque<Node>>()), closing_(options, *nodes_) {}

Tracked Slam::add(const Scan& scan, const Pose2& X_OB) {
  ++counts_.scans;
  Tracked tracked = tracking_.add(scan, X_OB, nodes_->size());
  if (!tracked.matched && counts_.scans > 1) ++counts_.unmatched;
  if (tracked.enters_map) nodes_->push_back({scan.time, tracked.placement, scan.ranges});
  if (tracked.finished) closing_.add(*tracked.finished);
  return tracked;
}

void Slam::finish() {
  for (const Submap& submap : tracking_.finish(nodes_->size())) closing_.add(submap);
  while (advance()) {
  }
  closing_.settle();
  while (advance()) {
  }
}

Pose2 Slam::pose(const Placement& placement) const {
  const std::vector<Pose2>& X_MS = closing_.X_MS();
  const std::size_t k = placement.submap;
  if (k >= X_MS.size()) {
    // Submaps that wait or are under way continue from the last one.
    Pose2 X = X_MS.empty() ? Pose2{} : X_MS.back();
    std::size_t at = X_MS.size();
    for (const Submap& submap : closing_.waiting()) {
      if (at > k) break;
      X = X * submap.X_PS.X;
      ++at;
    }
    for (const UncertainPose& X_PS : tracking_.under_way(at, k)) X = X * X_PS.X;
    return X * placement.X_SB;
  }
  const Pose2 by_this = X_MS[k] * placement.X_SB;
  if (k + 1 >= X_MS.size() || placement.share <= 0.0) return by_this;
  const Pose2 by_next = X_MS[k + 1] * (inverse(closing_.submaps()[k + 1].X_PS.X) * placement.X_SB);
  const Eigen::Vector3d d = difference(by_next, by_this);
  return {by_this.x + placement.share * d.x(), by_this.y + placement.share * d.y(),
          wrap_angle(by_this.theta + placement.share * d.z())};
}

Eigen::Matrix3d Slam::covariance(const Tracked& tracked) const {
  // Of the newest submap that was searched for loops; from there the way that was tracked.
  UncertainPose X = closing_.newest_in_first();
  const std::size_t from = closing_.X_MS().empty() ? 0 : closing_.X_MS().size() - 1;
  if (tracked.placement.submap > from) {
    std::size_t at = closing_.X_MS().size();
    for (const Submap& submap : closing_.waiting()) {
      if (at > tracked.placement.submap) break;
      X = X * submap.X_PS;
      ++at;
    }
    for (const UncertainPose& X_PS : tracking_.under_way(at, tracked.placement.submap)) X = X * X_PS;
  }
  return (X * tracked.X_SB).covariance;
}

}  // namespace bw::slam
