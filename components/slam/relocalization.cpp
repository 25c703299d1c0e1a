#include "components/slam/relocalization.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/slam/branch_and_bound.hpp"

namespace bw::slam {
namespace {

constexpr std::size_t kSubmapsAround = 6;
constexpr double kAround = 12.0;  // [m] from the pose to the frame of a submap
constexpr double kLeastOnWalls = 0.6;
constexpr int kPlaceIterations = 15;

constexpr double kBeside = 4.0;  // [m] from the way of the map's robot
constexpr double kBlock = 3.2;   // [m] half of the edge of what is searched at a time
constexpr int kSectors = 8;      // of the heading
constexpr double kLeastPlaceScore = 0.6;
constexpr double kWorse = 0.15;     // a score so much below the best is not looked at
constexpr double kRival = 0.1;      // a place as good as this less may be the right one
constexpr double kSamePlace = 0.5;  // [m]
constexpr double kSameHeading = 0.2;
constexpr std::size_t kMostSearched = 100;  // points
constexpr std::size_t kAgain = 5;           // nodes of the local map until it is searched for again
constexpr std::size_t kLooks = 8;           // scans of the local map that look through walls
constexpr SearchWindow kLastLook{0.4, 0.4, 0.15};

bool same_place(const Pose2& a, const Pose2& b) {
  const Eigen::Vector3d d = difference(a, b);
  return d.head<2>().norm() <= kSamePlace && std::abs(d.z()) <= kSameHeading;
}

// A map of what lies around alone.
SlamOptions local_options(SlamOptions options) {
  options.do_loop_closing = false;
  options.holds_back = true;
  return options;
}

}  // namespace

std::optional<Place> place_near(const Slam& map, std::span<const SurfacePoint> points, const Pose2& X_MB,
                                const SearchWindow& window) {
  struct Near {
    double distance = 0.0;
    std::size_t submap = 0;
  };
  std::vector<Near> around;
  for (std::size_t k = 0; k < map.submaps(); ++k) {
    if (map.map()[k].marginalised) continue;
    const double distance = (map.X_MS()[k].position() - X_MB.position()).norm();
    if (distance <= kAround) around.push_back({distance, k});
  }
  std::sort(around.begin(), around.end(), [](const Near& a, const Near& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.submap < b.submap;
  });
  if (around.size() > kSubmapsAround) around.resize(kSubmapsAround);
  std::optional<Place> best;
  const auto look = [&](const SurfaceMap& walls, const Pose2& X_MS, std::size_t submap) {
    const Correlation found = correlate(walls, points, inverse(X_MS) * X_MB, window);
    const Refined refined = refine(walls, points, found.X, nullptr, kPlaceIterations);
    if (refined.inliers < kLeastOnWalls || (best && refined.inliers <= best->inliers)) return;
    best = Place{submap, with_covariance(refined), X_MS * refined.X, refined.inliers};
  };
  for (const Near& near : around)
    look(SurfaceMap(map.options().resolution, map.map()[near.submap].surfaces), map.X_MS()[near.submap],
         near.submap);
  if (map.walls_under_way() != nullptr) {
    const std::size_t k = map.submap_under_way();
    look(*map.walls_under_way(), map.pose({k, {}, 0.0}), k);
  }
  return best;
}

PlaceSearch::PlaceSearch(const Slam& map)
    : map_(map), local_(std::make_unique<Slam>(local_options(map.options()))) {}

void PlaceSearch::add(const Scan& scan, const Pose2& X_OB) {
  const Tracked tracked = local_->add(scan, X_OB);
  if (tracked.held >= kKidnappedAfter) {
    local_ = std::make_unique<Slam>(local_options(map_.options()));
    is_open_ = false;
    blocks_.clear();
    asked_ = 0;
    return;
  }
  placement_ = tracked.placement;
  while (local_->advance()) {
  }
  newest_ = scan.points;
  if (!is_open_ && !place_ && (asked_ == 0 || local_->nodes().size() >= asked_ + kAgain)) begin_search();
}

void PlaceSearch::begin_search() {
  is_open_ = true;
  ++searches_;
  asked_ = local_->nodes().size();
  const std::size_t under_way = local_->submap_under_way();
  const std::vector<Surface>& surfaces = local_->walls_under_way()->surfaces();
  X_WS_ = local_->pose({under_way, {}, 0.0});
  const std::vector<Vector2> all = thinned(surfaces);
  points_.clear();
  for (std::size_t n = 0; n < all.size(); n += 1 + all.size() / kMostSearched) points_.push_back(all[n]);
  walls_.clear();
  for (const Surface& surface : surfaces) walls_.push_back(surface.point());
  sights_ = {};
  const std::size_t looks = std::min(asked_, kLooks);
  for (auto at = local_->nodes().lower_bound(asked_ - looks); at != local_->nodes().end(); ++at) {
    const Node& node = at->second;
    sights_.images.push_back(node.ranges.get());
    sights_.X_SB.push_back(inverse(X_WS_) * local_->pose(node.placement));
  }
  candidates_.clear();
  best_ = 0.0;
  submap_ = 0;
  if (map_.submaps() > 0) open_submap();
}

void PlaceSearch::open_submap() {
  const Submap& submap = map_.map()[submap_];
  grids_.emplace(submap.surfaces);
  surface_map_.reset();
  blocks_.clear();
  Vector2 low{1e9, 1e9};
  Vector2 high{-1e9, -1e9};
  const Pose2 X_SM = inverse(map_.X_MS()[submap_]);
  for (auto at = map_.nodes().lower_bound(submap.first_node),
            end = map_.nodes().lower_bound(submap.last_node);
       at != end; ++at) {
    const Vector2 p = (X_SM * map_.pose(at->second.placement)).position();
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if ((low.array() > high.array()).any() || submap.surfaces.empty()) return;
  const Vector2 size = (high - low).array() + 2.0 * kBeside;
  const Eigen::Array2i count = (size / (2.0 * kBlock)).array().ceil().cast<int>();
  const Vector2 half = 0.5 * size.array() / count.cast<double>();
  for (int j = 0; j < count.y(); ++j)
    for (int i = 0; i < count.x(); ++i)
      for (int s = 0; s < kSectors; ++s)
        blocks_.push_back(
            {{low.x() - kBeside + (2 * i + 1) * half.x(), low.y() - kBeside + (2 * j + 1) * half.y(),
              wrap_angle(s * 2.0 * std::numbers::pi / kSectors)},
             {half.x(), half.y(), std::numbers::pi / kSectors}});
}

bool PlaceSearch::advance() {
  if (!is_open_) return false;
  if (!blocks_.empty()) {
    look(blocks_.back());
    blocks_.pop_back();
    return true;
  }
  if (submap_ + 1 < map_.submaps()) {
    ++submap_;
    open_submap();
    return true;
  }
  is_open_ = false;
  judge();
  return false;
}

void PlaceSearch::look(const Block& block) {
  const double least = std::max(kLeastPlaceScore, best_ - kWorse);
  std::int64_t visited = 0;
  const auto found = branch_and_bound(*grids_, points_, block.start, block.window, least, visited);
  if (!found) return;
  const Submap& submap = map_.map()[submap_];
  if (!surface_map_) surface_map_.emplace(map_.options().resolution, submap.surfaces);
  const Refined refined = refine(*surface_map_, walls_, found->X, nullptr, kPlaceIterations);
  if (refined.inliers < kLeastPlaceScore) return;
  const double value = refined.inliers * (1.0 - seen_through(submap.surfaces, moved(sights_, refined.X)));
  best_ = std::max(best_, found->score);
  candidates_.push_back({map_.X_MS()[submap_] * refined.X, value, !refined.unseen.isZero()});
}

void PlaceSearch::judge() {
  const auto best =
      std::max_element(candidates_.begin(), candidates_.end(),
                       [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
  doubt_ = Doubt::none;
  if (best == candidates_.end() || best->value < kLeastOnWalls) {
    doubt_ = Doubt::nothing_fits;
  } else if (std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
               return other.value >= best->value - kRival && !same_place(other.X_MS, best->X_MS);
             })) {
    doubt_ = Doubt::several_fit;
  } else if (best->unseen) {
    doubt_ = Doubt::one_direction_unseen;
  } else {
    // The robot may have driven on since.
    const Pose2 X_MB = best->X_MS * (inverse(X_WS_) * local_->pose(placement_));
    place_ = place_near(map_, newest_, X_MB, kLastLook);
    if (!place_) doubt_ = Doubt::nothing_fits;
  }
}

}  // namespace bw::slam
