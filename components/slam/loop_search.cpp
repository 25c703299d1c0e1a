#include "components/slam/loop_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/model/chi_square.hpp"
#include "components/slam/branch_and_bound.hpp"
#include "components/slam/once_per_cell.hpp"
#include "components/slam/refinement.hpp"

namespace bw::slam {
namespace {

constexpr double kLeastScore = 0.4;
constexpr double kLeastInliers = 0.5;
constexpr double kBelieved = 0.999;  // of right loops are that near to where they are expected
constexpr double kLeastValue = 0.4;  // share of inliers times the share that was not seen through
constexpr int kIterationsOfLoop = 15;
constexpr double kFitsAsWell = 0.02;  // by so much of its fit the better of two places is no better
constexpr double kOtherPlace = 0.3;   // [m] between two places
constexpr double kApart = 0.2;        // [m] of the points that are searched with
constexpr double kSigmas = 3.0;
constexpr double kLeastWindow = 0.3;  // [m]
constexpr double kOverlap = 6.0;      // [m] between the frames of submaps that share walls
constexpr double kLeastTurn = 0.05;   // [rad]
constexpr double kMostTurn = 0.7;     // [rad]

std::vector<SurfacePoint> points_of(std::span<const Surface> surfaces) {
  std::vector<SurfacePoint> points;
  points.reserve(surfaces.size());
  for (const Surface& s : surfaces) points.push_back(s.point());
  return points;
}

}  // namespace

Sights moved(Sights sights, const Pose2& X_AS) {
  for (Pose2& X_SB : sights.X_SB) X_SB = X_AS * X_SB;
  return sights;
}

std::vector<Vector2> thinned(std::span<const Surface> surfaces) {
  OncePerCell cells(kApart);
  std::vector<Vector2> points;
  for (const Surface& s : surfaces)
    if (cells.take(s)) points.emplace_back(s.x, s.y);
  return points;
}

double all_round(std::span<const Surface> surfaces) {
  // Sum of n n^T by doubled angles: trace N, the difference of its eigenvalues the length of the summed vectors.
  double c = 0.0;
  double s = 0.0;
  double n = 0.0;
  for (const Surface& surface : surfaces) {
    c += static_cast<double>(surface.normal_cos2);
    s += static_cast<double>(surface.normal_sin2);
    n += std::hypot(static_cast<double>(surface.normal_cos2), static_cast<double>(surface.normal_sin2));
  }
  const double length = std::hypot(c, s);
  return n > 0.0 ? (n - length) / (n + length) : 0.0;
}

Vector2 centre(std::span<const Surface> surfaces) {
  Vector2 sum{0.0, 0.0};
  for (const Surface& surface : surfaces) sum += Vector2{surface.x, surface.y};
  return surfaces.empty() ? sum : Vector2(sum / static_cast<double>(surfaces.size()));
}

namespace {

enum class Look { out_of_view, unsure, met, through };

// From where a scan was taken, of a point in the scanner's frame.
Look look_at(const Vector2& p, const RangeImage& image) {
  constexpr double kMargin = 0.3;  // [m] a beam that ends so far behind a surface went through it
  const double range = p.norm();
  if (range < 0.3 || range > 12.0) return Look::out_of_view;
  const std::optional<std::size_t> beam = beam_towards(image, p);
  if (!beam || *beam < 1 || *beam + 1 >= image.millimetres.size()) return Look::out_of_view;
  // All three neighbouring beams must agree: at the edge of an obstacle the next one goes past.
  int beyond = 0;
  int ended = 0;
  for (std::size_t b = *beam - 1; b <= *beam + 1; ++b) {
    const std::uint16_t mm = image.millimetres[b];
    if (mm == RangeImage::kUnknown || mm == RangeImage::kNoReturn) continue;
    const double measured = 0.001 * mm;
    if (measured < range - kMargin) return Look::out_of_view;
    (measured > range + kMargin + 0.02 * range ? beyond : ended) += 1;
  }
  if (beyond == 3) return Look::through;
  return ended > 0 ? Look::met : Look::unsure;
}

// Looks of each scan at every so many of these, from the first on: look(index, what it was).
template <class F>
void look_at_each(std::span<const Surface> surfaces, std::size_t stride, const Sights& sights,
                  const F& look) {
  for (std::size_t k = 0; k < sights.images.size(); ++k) {
    const RangeImage& image = *sights.images[k];
    const Pose2 X_LS = inverse(sights.X_SB[k] * image.X_BL);
    for (std::size_t n = 0; n < surfaces.size(); n += stride)
      look(n, look_at(X_LS * Vector2{surfaces[n].x, surfaces[n].y}, image));
  }
}

}  // namespace

double seen_through(std::span<const Surface> surfaces, const Sights& sights) {
  int in_view = 0;
  int through = 0;
  look_at_each(surfaces, 3, sights, [&](std::size_t, Look look) {
    if (look != Look::out_of_view) ++in_view;
    if (look == Look::through) ++through;
  });
  return in_view < 30 ? 0.0 : static_cast<double>(through) / in_view;
}

std::vector<Surface> standing(std::span<const Surface> surfaces, const Sights& sights) {
  std::vector<int> gone(surfaces.size(), 0);
  look_at_each(surfaces, 1, sights, [&](std::size_t n, Look look) {
    if (look == Look::through) ++gone[n];
    if (look == Look::met) --gone[n];
  });
  std::vector<Surface> result;
  for (std::size_t n = 0; n < surfaces.size(); ++n)
    if (gone[n] <= 0) result.push_back(surfaces[n]);
  return result;
}

LoopSearch::LoopSearch(std::span<const Surface> walls, const Sights& sights, const SlamOptions& options)
    : walls_(walls), centre_(centre(walls)), sights_(sights), options_(options), grids_(walls) {}

std::optional<Loop> LoopSearch::find(const Submap& earlier, const Sights& of_earlier,
                                     const UncertainPose& expected) {
  const auto sigmas = [&](int axis) { return kSigmas * std::sqrt(expected.covariance(axis, axis)); };
  SearchWindow window{std::max(kLeastWindow, sigmas(0)), std::max(kLeastWindow, sigmas(1)),
                      std::clamp(sigmas(2), kLeastTurn, kMostTurn)};
  Pose2 start = expected.X;
  if (std::max(window.x, window.y) > kOverlap) {
    // Where they overlap at all.
    const auto within = [](double middle, double reach, double overlap, double& start_at, double& half) {
      const double low = std::max(middle - reach, overlap - kOverlap);
      const double high = std::min(middle + reach, overlap + kOverlap);
      start_at = 0.5 * (low + high);
      half = std::max(kLeastWindow, 0.5 * (high - low));
    };
    const Vector2 offset = centre_ - rotate(expected.X, earlier.centre);
    within(expected.X.x, window.x, offset.x(), start.x, window.x);
    within(expected.X.y, window.y, offset.y(), start.y, window.y);
  }
  const auto found =
      branch_and_bound(grids_, thinned(earlier.surfaces), start, window, kLeastScore, visited_);
  if (!found) return std::nullopt;
  if (!map_) map_.emplace(options_.resolution, walls_);
  const std::vector<SurfacePoint> points = points_of(earlier.surfaces);
  Refined refined = refine(*map_, points, found->X, nullptr, kIterationsOfLoop);
  if (!refined.unseen.isZero()) {
    // Along a corridor any place fits: the one that was expected is taken.
    const Vector2 along = refined.unseen * refined.unseen.dot(expected.X.position() - refined.X.position());
    refined = refine(*map_, points, {refined.X.x + along.x(), refined.X.y + along.y(), refined.X.theta},
                     nullptr, kIterationsOfLoop);
  } else if ((refined.X.position() - expected.X.position()).norm() > kOtherPlace) {
    // Where the place that was expected fits as well, nothing tells the two apart: more of the walls overlap in the one.
    Refined there = refine(*map_, points, expected.X, nullptr, kIterationsOfLoop);
    const Vector2 between = refined.X.position() - there.X.position();
    if (there.fit >= refined.fit - kFitsAsWell && between.norm() > kOtherPlace) {
      there.hide(between.normalized());
      refined = there;
    }
  }
  if (refined.inliers < kLeastInliers) return std::nullopt;
  const UncertainPose there = with_covariance(refined);
  if (squared_distance(there, expected) > chi_square_quantile(kBelieved, 3)) return std::nullopt;
  Loop loop;
  loop.score = found->score;
  loop.inliers = refined.inliers;
  loop.window = std::max(window.x, window.y);
  // Either way: where a wall was seen then and nothing stands now, and where a wall stands now.
  loop.through = 1.0 - (1.0 - seen_through(earlier.surfaces, moved(sights_, inverse(refined.X)))) *
                           (1.0 - seen_through(walls_, moved(of_earlier, refined.X)));
  if (loop.inliers * (1.0 - loop.through) < kLeastValue) return std::nullopt;
  loop.edge.loop = true;
  loop.edge.X = inverse(there);
  return loop;
}

}  // namespace bw::slam
