#include "components/slam/slam.hpp"

#include <algorithm>
#include <cmath>

#include "components/slam/pairwise_consistency.hpp"

namespace bw::slam {
namespace {

constexpr std::size_t kOverlapping =
    3;  // [submaps] nearer along the drive, scans were matched with each other
constexpr std::size_t kMostCandidates = 6;
constexpr double kWide = 2.0;  // [m] beyond, a search is dear and finds look-alikes
constexpr double kAllRound = 0.2;
constexpr std::size_t kMostFar = 32;
constexpr std::size_t kImages = 6;          // nodes of a submap that look through the other
constexpr double kSure = 0.5;               // [m] a search so narrow needs no second loop
constexpr std::size_t kSupport = 3;         // loops that agree
constexpr std::size_t kWaiting = 200;       // loops that wait for support
constexpr double kJointNoise = 0.003;       // [m] of a step between submaps, beyond what is summed
constexpr double kJointTurnNoise = 0.0015;  // [rad]

}  // namespace

Slam::Slam(const SlamOptions& options) : options_(options), tracking_(options) {}

Tracked Slam::add(const Scan& scan, const Pose2& X_OB) {
  ++counts_.scans;
  Tracked tracked = tracking_.add(scan, X_OB, nodes_.size());
  if (!tracked.matched && counts_.scans > 1) ++counts_.unmatched;
  if (tracked.enters_map) nodes_.push_back({scan.time, tracked.placement, scan.ranges});
  if (tracked.finished) take(*tracked.finished);
  return tracked;
}

void Slam::take(const Submap& submap) {
  const std::size_t index = submaps_.size();
  submaps_.push_back(submap);
  submaps_.back().all_round = all_round(submap.surfaces);
  submaps_.back().centre = centre(submap.surfaces);
  UncertainPose& X_PS = submaps_.back().X_PS;
  if (index == 0) {
    X_MS_.emplace_back();
    return;
  }
  X_PS.covariance.diagonal() += Eigen::Vector3d{kJointNoise * kJointNoise, kJointNoise * kJointNoise,
                                                kJointTurnNoise * kJointTurnNoise};
  edges_.push_back({index - 1, index, X_PS, false});
  X_MS_.push_back(X_MS_.back() * X_PS.X);
  if (!options_.do_loop_closing) return;
  search(index);
  if (accept()) {
    optimise(edges_, X_MS_);
    ++counts_.optimisations;
  }
}

std::vector<std::size_t> Slam::loop_candidates(std::size_t later, const std::vector<UncertainPose>& others) {
  struct Candidate {
    std::size_t submap = 0;
    double distance = 0.0;  // [m], or in standard deviations
  };
  std::vector<Candidate> near;
  std::vector<Candidate> far;
  const double reach = options_.loop_search_maximum_distance;
  for (std::size_t j = 0; j + kOverlapping <= later; ++j) {
    const double sigma = std::sqrt(others[j].covariance.topLeftCorner<2, 2>().trace());
    const double distance = (others[j].X * submaps_[j].centre - submaps_[later].centre).norm();
    if (distance - 3.0 * sigma > reach) continue;
    if (3.0 * sigma <= kWide)
      near.push_back({j, distance});
    else if (submaps_[later].all_round > kAllRound && submaps_[j].all_round > kAllRound)
      far.push_back({j, std::max(0.0, distance - reach) / sigma});
  }
  const auto nearer = [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.submap < b.submap;
  };
  std::sort(near.begin(), near.end(), nearer);
  if (near.size() > kMostCandidates) near.resize(kMostCandidates);
  std::vector<std::size_t> chosen;
  for (const Candidate& candidate : near) chosen.push_back(candidate.submap);
  // Of many, some each time, so that all have their turn.
  std::sort(far.begin(), far.end(), nearer);
  for (std::size_t k = 0; k < std::min(far.size(), kMostFar); ++k)
    chosen.push_back(far[turn_++ % far.size()].submap);
  return chosen;
}

void Slam::search(std::size_t later) {
  const std::vector<UncertainPose> others = relative_to(later, edges_, X_MS_);
  const std::vector<std::size_t> candidates = loop_candidates(later, others);
  const Submap& submap = submaps_[later];
  std::vector<const RangeImage*> images;
  std::vector<Pose2> X_SB;
  const std::size_t stride = std::max<std::size_t>(1, (submap.last_node - submap.first_node) / kImages);
  for (std::size_t n = submap.first_node; n < submap.last_node && n < nodes_.size(); n += stride) {
    const Placement& placement = nodes_[n].placement;
    images.push_back(&nodes_[n].ranges);
    X_SB.push_back(placement.submap == later ? placement.X_SB : inverse(submap.X_PS.X) * placement.X_SB);
  }
  LoopSearch loops(submap, images, X_SB, options_);
  for (const std::size_t earlier : candidates) {
    ++counts_.searched;
    auto loop = loops.find(submaps_[earlier], others[earlier]);
    if (!loop) continue;
    ++counts_.found;
    loop->edge.from = earlier;
    loop->edge.to = later;
    pending_.push_back(*loop);
  }
  counts_.visited += loops.visited();
}

bool Slam::accept() {
  std::vector<bool> taken(pending_.size(), false);
  bool any = false;
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (taken[i]) continue;
    if (pending_[i].window <= kSure) {
      taken[i] = true;
      continue;
    }
    const std::vector<std::size_t> clique = supporters(i, pending_, submaps_);
    if (clique.size() < kSupport) continue;
    for (const std::size_t k : clique) taken[k] = true;
  }
  std::vector<Loop> left;
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (!taken[i]) {
      left.push_back(pending_[i]);
      continue;
    }
    any = true;
    ++counts_.accepted;
    edges_.push_back(pending_[i].edge);
    accepted_.push_back(pending_[i]);
  }
  if (left.size() > kWaiting) left.erase(left.begin(), left.end() - kWaiting);
  pending_ = std::move(left);
  return any;
}

void Slam::finish() {
  for (const Submap& submap : tracking_.finish(nodes_.size())) take(submap);
}

Pose2 Slam::pose(const Placement& placement) const {
  // Submaps that are under way continue from the last one.
  const std::size_t k = placement.submap;
  if (k >= X_MS_.size()) {
    Pose2 X = X_MS_.empty() ? Pose2{} : X_MS_.back();
    for (const UncertainPose& X_PS : tracking_.under_way(X_MS_.size(), k)) X = X * X_PS.X;
    return X * placement.X_SB;
  }
  const Pose2 by_this = X_MS_[k] * placement.X_SB;
  if (k + 1 >= X_MS_.size() || placement.share <= 0.0) return by_this;
  const Pose2 by_next = X_MS_[k + 1] * (inverse(submaps_[k + 1].X_PS.X) * placement.X_SB);
  const Eigen::Vector3d d = difference(by_next, by_this);
  return {by_this.x + placement.share * d.x(), by_this.y + placement.share * d.y(),
          wrap_angle(by_this.theta + placement.share * d.z())};
}

}  // namespace bw::slam
