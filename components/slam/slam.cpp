#include "components/slam/slam.hpp"

namespace bw::slam {

Slam::Slam(const SlamOptions& options)
    : options_(options), tracking_(options), nodes_(std::make_unique<Nodes>()), closing_(options, *nodes_) {}

Slam::Slam(SlamState state)
    : options_(state.options),
      tracking_(state.options, state.tracking),
      nodes_(std::make_unique<Nodes>(std::make_move_iterator(state.nodes.begin()),
                                     std::make_move_iterator(state.nodes.end()))),
      closing_(state.options, *nodes_, std::move(state.closing)),
      counts_(state.counts) {}

SlamState Slam::save() {
  settle();
  return {options_, counts_, {nodes_->begin(), nodes_->end()}, closing_.state(), tracking_.state()};
}

Tracked Slam::add(const Scan& scan, const Pose2& X_OB) {
  ++counts_.scans;
  Tracked tracked = tracking_.add(scan, X_OB, counts_.nodes);
  if (!tracked.matched && counts_.scans > 1) ++counts_.unmatched;
  if (tracked.enters_map)
    nodes_->emplace(counts_.nodes++,
                    Node{scan.time, tracked.placement, std::make_shared<const RangeImage>(scan.ranges)});
  if (tracked.finished) closing_.add(*tracked.finished);
  return tracked;
}

void Slam::finish() {
  for (const Submap& submap : tracking_.finish(counts_.nodes)) closing_.add(submap);
  settle();
}

bool Slam::settle_a_piece() {
  if (advance()) return true;
  closing_.settle();
  return advance();
}

void Slam::begin_at(std::size_t found_in, const UncertainPose& X_PB) {
  finish();
  tracking_.begin_at(found_in, X_PB);
}

std::optional<ScanTracking::Joint> Slam::joint(std::size_t submap) const {
  const std::size_t waits = submap - closing_.X_MS().size();
  if (waits >= closing_.waiting().size()) return tracking_.joint(submap);
  return ScanTracking::Joint{closing_.waiting()[waits].found_in, closing_.waiting()[waits].X_PS};
}

Pose2 Slam::X_M(std::size_t submap) const {
  const std::vector<Pose2>& X_MS = closing_.X_MS();
  if (submap < X_MS.size()) return X_MS[submap];
  // Submaps that wait or are under way continue from their parent.
  const auto hangs = joint(submap);
  if (!hangs || submap == 0) return {};
  return X_M(hangs->found_in.value_or(submap - 1)) * hangs->X_PS.X;
}

Pose2 Slam::pose(const Placement& placement) const {
  const std::vector<Pose2>& X_MS = closing_.X_MS();
  const std::size_t k = placement.submap;
  const Pose2 by_this = X_M(k) * placement.X_SB;
  if (k + 1 >= X_MS.size() || placement.share <= 0.0 || closing_.submaps()[k + 1].found_in) return by_this;
  const Pose2 by_next = X_MS[k + 1] * (inverse(closing_.submaps()[k + 1].X_PS.X) * placement.X_SB);
  const Eigen::Vector3d d = difference(by_next, by_this);
  return {by_this.x + placement.share * d.x(), by_this.y + placement.share * d.y(),
          wrap_angle(by_this.theta + placement.share * d.z())};
}

Eigen::Matrix3d Slam::covariance(const Tracked& tracked) const {
  // Of the newest submap that was searched for loops; from there the way that was tracked.
  const std::size_t known = closing_.X_MS().size();
  std::size_t at = tracked.placement.submap;
  std::vector<UncertainPose> way;
  while (at >= known && at > 0) {
    const auto hangs = joint(at);
    if (!hangs) break;
    way.push_back(hangs->X_PS);
    at = hangs->found_in.value_or(at - 1);
  }
  UncertainPose X = at + 1 < known && !way.empty() ? closing_.in_first(at) : closing_.newest_in_first();
  for (auto step = way.rbegin(); step != way.rend(); ++step) X = X * *step;
  return (X * tracked.X_SB).covariance;
}

}  // namespace bw::slam
