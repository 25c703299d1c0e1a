#include "components/slam/loop_closing.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/rigid_fit.hpp"
#include "components/slam/loop_candidates.hpp"
#include "components/slam/once_per_cell.hpp"
#include "components/slam/pairwise_consistency.hpp"
#include "components/slam/sparsification.hpp"

namespace bw::slam {
namespace {

constexpr std::size_t kBefore = 2;          // [submaps] before the newest: it ended where the newest begins
constexpr std::size_t kInView = 20;         // [submaps] along the drive; beyond, what is seen is seen again
constexpr std::size_t kImages = 8;          // nodes that look through an earlier submap
constexpr std::size_t kWaiting = 200;       // loops that wait for support
constexpr double kAgrees = 0.5;             // chi^2 of a loop that the poses keep to already
constexpr double kJointNoise = 0.003;       // [m] of a step between submaps, beyond what is summed
constexpr double kJointTurnNoise = 0.0015;  // [rad]

// Of a submap in the first one, which hangs on `anchor` if it left.
UncertainPose marginal_in_first(std::size_t submap, const std::optional<Submap::Anchor>& anchor,
                                const std::vector<Edge>& edges, const std::vector<Pose2>& X_MS) {
  if (!anchor) return marginal(submap, 0, edges, X_MS);
  return UncertainPose{inverse(anchor->X_AS), Eigen::Matrix3d::Zero()} *
         marginal(submap, anchor->submap, edges, X_MS);
}

}  // namespace

// What loops are searched in: walls in the newest submap, and some of the scans that saw them.
struct LoopClosing::View {
  std::vector<Surface> walls;
  Sights sights;
  std::optional<LoopSearch> loops;
};

struct LoopClosing::Search {
  std::vector<UncertainPose> others;
  UncertainPose in_first;
  bool is_open = false;  // and then:
  std::vector<std::size_t> candidates;
  std::size_t next = 0;
  View newest;
  View with_before;  // and the one before: what was seen of a place is often shared by two submaps
};

UncertainPose LoopClosing::in_first(std::size_t submap) const {
  return marginal_in_first(submap, known_.submaps.front().marginalised, known_.edges, known_.X_MS);
}

bool LoopClosing::advance() {
  if (pending_.is_done && !pending_.is_done()) return true;
  if (optimisation_) {
    if (optimisation_->step()) return true;
    place(optimisation_->poses());
    optimisation_.reset();
    ++known_.counts.optimisations;
    return true;
  }
  if (!search_) {
    if (!review_.empty()) {
      marginalise_if_seen_again(review_.back());
      review_.pop_back();
      return true;
    }
    if (waiting_.empty()) return false;
    take_up();
    return true;
  }
  if (!search_->is_open) {
    open_search();
    return true;
  }
  if (search_->next < search_->candidates.size()) {
    const std::size_t earlier = search_->candidates[search_->next];
    const bool again = earlier + kInView < known_.submaps.size();
    View& view = again ? search_->with_before : search_->newest;
    if (!view.loops) {
      look(view, again ? kBefore : 0);
      return true;
    }
    ++search_->next;
    ++known_.counts.searched;
    if (auto loop = view.loops->find(known_.submaps[earlier], sights(earlier, 0), search_->others[earlier])) {
      ++known_.counts.found;
      loop->edge.from = earlier;
      loop->edge.to = known_.submaps.size() - 1;
      known_.pending.push_back(*loop);
    }
    return true;
  }
  for (const View* view : {&search_->newest, &search_->with_before})
    if (view->loops) known_.counts.visited += view->loops->visited();
  const std::size_t newest = known_.submaps.size() - 1;
  around_.clear();
  for (std::size_t k = 0; k <= newest; ++k) {
    const UncertainPose& X = search_->others[k];
    const double distance = X.X.position().norm();
    if (known_.submaps[k].marginalised || distance > 2.0 * kPlaceReach) continue;
    around_.push_back(k);
    if (distance > kPlaceReach || overlap(k, newest, known_.submaps)) continue;
    if (3.0 * std::sqrt(X.covariance.topLeftCorner<2, 2>().trace()) <= kWide) review_.push_back(k);
  }
  search_.reset();
  if (accept()) settle();
  return true;
}

void LoopClosing::place(std::vector<Pose2> X_MS) {
  if (!known_.submaps.empty() && known_.submaps.front().marginalised) {
    // The first pose is not there any more to hold the map's frame: all that are hold it together.
    RigidFit fit;
    for (std::size_t k = 0; k < known_.submaps.size(); ++k)
      if (!known_.submaps[k].marginalised) fit.add(known_.X_MS[k].position(), X_MS[k].position());
    const Pose2 X = fit.X_AB();
    for (Pose2& pose : X_MS) pose = X * pose;
  }
  known_.X_MS = std::move(X_MS);
  for (std::size_t k = 0; k < known_.submaps.size(); ++k)
    if (const auto& anchor = known_.submaps[k].marginalised)
      known_.X_MS[k] = known_.X_MS[anchor->submap] * anchor->X_AS;
}

void LoopClosing::marginalise_if_seen_again(std::size_t submap) {
  if (!is_seen_again(submap, around_, known_.submaps, known_.X_MS, nodes_)) return;
  auto rest = marginalise(submap, known_.edges, known_.X_MS);
  if (!rest) return;
  known_.edges = std::move(rest->edges);
  const Pose2 X_AS = inverse(known_.X_MS[rest->anchor]) * known_.X_MS[submap];
  for (Submap& other : known_.submaps)
    if (other.marginalised && other.marginalised->submap == submap)
      other.marginalised = Submap::Anchor{rest->anchor, X_AS * other.marginalised->X_AS};
  Submap& left = known_.submaps[submap];
  left.marginalised = Submap::Anchor{rest->anchor, X_AS};
  left.surfaces = {};
  std::erase_if(nodes_, [&](const auto& node) { return node.second.placement.submap == submap; });
  std::erase_if(known_.pending,
                [&](const Loop& loop) { return loop.edge.from == submap || loop.edge.to == submap; });
  ++known_.counts.marginalised;
}

void LoopClosing::settle() {
  if (settled_) return;
  settled_ = true;
  optimisation_ = std::make_shared<Optimisation>(known_.edges, known_.X_MS);
  if (!beside_) return;
  pending_ = beside_([optimisation = optimisation_] {
    while (optimisation->step()) {
    }
  });
}

void LoopClosing::take_up() {
  const std::size_t index = known_.submaps.size();
  known_.submaps.push_back(std::move(waiting_.front()));
  waiting_.pop_front();
  Submap& submap = known_.submaps.back();
  submap.surfaces = standing(submap.surfaces, sights(index, 0));
  submap.all_round = all_round(submap.surfaces);
  submap.centre = centre(submap.surfaces);
  if (index == 0) {
    known_.X_MS.emplace_back();
    return;
  }
  submap.X_PS.covariance.diagonal() += Eigen::Vector3d{kJointNoise * kJointNoise, kJointNoise * kJointNoise,
                                                       kJointTurnNoise * kJointTurnNoise};
  const std::size_t parent = submap.parent(index);
  known_.X_MS.push_back(known_.X_MS[parent] * submap.X_PS.X);
  if (const auto& anchor = known_.submaps[parent].marginalised)
    known_.edges.push_back(
        {anchor->submap, index, UncertainPose{anchor->X_AS, Eigen::Matrix3d::Zero()} * submap.X_PS, false});
  else
    known_.edges.push_back({parent, index, submap.X_PS, false});
  known_.newest_in_first = submap.found_in ? in_first(index) : known_.newest_in_first * submap.X_PS;
  if (options_.do_loop_closing) begin_search();
}

void LoopClosing::begin_search() {
  const std::size_t later = known_.submaps.size() - 1;
  search_ = std::make_shared<Search>();
  const auto work = [search = search_, later, edges = known_.edges, X_MS = known_.X_MS,
                     anchor = known_.submaps.front().marginalised] {
    search->others = relative_to(later, edges, X_MS);
    search->in_first = marginal_in_first(later, anchor, edges, X_MS);
  };
  if (beside_) {
    pending_ = beside_(work);
    return;
  }
  work();
  open_search();
}

void LoopClosing::open_search() {
  known_.newest_in_first = search_->in_first;
  search_->candidates =
      loop_candidates(known_.submaps, search_->others, options_.loop_search_maximum_distance, known_.turn);
  search_->is_open = true;
}

std::vector<Pose2> LoopClosing::frames_before(std::size_t submap, std::size_t before) const {
  std::vector<Pose2> X_SK{Pose2{}};
  for (std::size_t k = submap; k > 0 && !known_.submaps[k].found_in && X_SK.size() <= before; --k)
    X_SK.push_back(X_SK.back() * inverse(known_.submaps[k].X_PS.X));
  return X_SK;
}

Sights LoopClosing::sights(std::size_t submap, std::size_t before) const {
  // The first scan of a submap may have been placed in the second one before it, which ended there.
  const std::vector<Pose2> X_SK = frames_before(submap, before + 2);
  const Submap& last = known_.submaps[submap];
  const Submap& first = known_.submaps[submap - std::min(before, X_SK.size() - 1)];
  Sights sights;
  const std::size_t stride = std::max<std::size_t>(1, (last.last_node - first.first_node) / kImages);
  for (std::size_t n = first.first_node; n < last.last_node; n += stride) {
    const auto node = nodes_.find(n);
    if (node == nodes_.end()) continue;  // it left with its submap
    const Placement& placement = node->second.placement;
    // Of a file alone: it lies in none of these submaps.
    if (submap - placement.submap >= X_SK.size()) continue;
    sights.images.push_back(node->second.ranges.get());
    sights.X_SB.push_back(X_SK[submap - placement.submap] * placement.X_SB);
  }
  return sights;
}

void LoopClosing::look(View& view, std::size_t before) const {
  const std::size_t later = known_.submaps.size() - 1;
  view.walls = known_.submaps[later].surfaces;
  const std::vector<Pose2> X_SK = frames_before(later, before);
  if (X_SK.size() > 1) {
    // Walls that both saw, once: a cell has one surface.
    OncePerCell cells(options_.resolution);
    for (const Surface& surface : view.walls) cells.take(surface);
    for (const Surface& surface : known_.submaps[later + 1 - X_SK.size()].surfaces) {
      const Surface there = moved(surface, X_SK.back());
      if (cells.take(there)) view.walls.push_back(there);
    }
  }
  view.sights = sights(later, before);
  view.loops.emplace(view.walls, view.sights, options_);
}

bool LoopClosing::accept() {
  const std::vector<bool> taken = believed(known_.pending, known_.submaps);
  bool any = false;
  std::vector<Loop> left;
  for (std::size_t i = 0; i < known_.pending.size(); ++i) {
    if (!taken[i]) {
      left.push_back(known_.pending[i]);
      continue;
    }
    if (disagreement(known_.pending[i].edge, known_.X_MS) > kAgrees) any = true;
    settled_ = false;
    ++known_.counts.accepted;
    known_.edges.push_back(known_.pending[i].edge);
  }
  if (left.size() > kWaiting) left.erase(left.begin(), left.end() - kWaiting);
  known_.pending = std::move(left);
  return any;
}

}  // namespace bw::slam
