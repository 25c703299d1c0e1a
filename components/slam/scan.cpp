#include "components/slam/scan.hpp"

#include <algorithm>
#include <cmath>

namespace bw::slam {
namespace {

struct Hit {
  Vector2 position;
  double range = 0.0;
  int beam = 0;
};

constexpr int kNeighbours = 4;             // to either side
constexpr double kLeastReach = 0.15;       // [m]
constexpr double kSpacings = 3.5;          // neighbours are at most so many beam spacings away
constexpr double kGrazing = 3.0;           // spacing on a wall seen at a flat angle
constexpr double kLongestDrawn = 65500.0;  // [mm]
constexpr double kRoughness = 0.02;        // [m] a wall whose points deviate by more is not straight
constexpr int kFewestBeams = 30;           // by which two sweeps are compared
constexpr double kAlike = 0.1;             // [m], and
constexpr double kAlikeShare = 0.02;       // of its range: a beam that sees the same

// Sets the normal of hit `i` from its neighbours along the sweep.
void set_normal(const std::vector<Hit>& hits, std::size_t i, double increment, SurfacePoint& point) {
  const Hit& hit = hits[i];
  const double reach = std::max(kLeastReach, kSpacings * kGrazing * hit.range * increment);
  const std::size_t first = i >= kNeighbours ? i - kNeighbours : 0;
  const std::size_t last = std::min(hits.size() - 1, i + kNeighbours);
  Vector2 sum = Vector2::Zero();
  int n = 0;
  for (std::size_t j = first; j <= last; ++j) {
    if ((hits[j].position - hit.position).norm() > reach ||
        std::abs(hits[j].beam - hit.beam) > 2 * kNeighbours)
      continue;
    sum += hits[j].position;
    ++n;
  }
  if (n < 3) return;
  const Vector2 mean = sum / n;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t j = first; j <= last; ++j) {
    if ((hits[j].position - hit.position).norm() > reach ||
        std::abs(hits[j].beam - hit.beam) > 2 * kNeighbours)
      continue;
    const Vector2 d = hits[j].position - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  // The larger eigenvalue's direction is the wall's; the normal's doubled angle is opposite to it.
  const double c = xx - yy;
  const double s = 2.0 * xy;
  const double spread = std::hypot(c, s);
  if (spread <= 0.0) return;
  const double large = 0.5 * (xx + yy + spread);
  const double small = 0.5 * (xx + yy - spread);
  const double rough = std::sqrt(std::max(0.0, small) / n) / kRoughness;
  const double straight = (1.0 - small / large) / (1.0 + rough * rough);
  point.normal_cos2 = static_cast<float>(-c / spread * straight);
  point.normal_sin2 = static_cast<float>(-s / spread * straight);
}

/// The image as it would be had all beams been taken at the middle of the sweep, at a steady turn meanwhile.
void set_frame(const LaserSweep& sweep, RangeImage& image) {
  image.X_BL = sweep.X_FL;
  image.angle_min = sweep.angle_min;
  image.angle_increment = sweep.angle_increment;
  const std::size_t beams = sweep.ranges.size();
  if (sweep.beam_poses.empty() || beams < 2) return;
  const std::size_t middle = beams / 2;
  image.X_BL = scanner_at(sweep, middle);
  const double turn = wrap_angle(scanner_at(sweep, middle).theta - scanner_at(sweep, 0).theta) +
                      wrap_angle(scanner_at(sweep, beams - 1).theta - scanner_at(sweep, middle).theta);
  image.angle_increment += turn / static_cast<double>(beams - 1);
  image.angle_min -= static_cast<double>(middle) * (image.angle_increment - sweep.angle_increment);
}

}  // namespace

Scan scan_of(const LaserSweep& sweep, const SlamOptions& options) {
  Scan scan;
  scan.time = sweep.time;
  set_frame(sweep, scan.ranges);
  scan.ranges.millimetres.resize(sweep.ranges.size(), RangeImage::kUnknown);
  std::vector<Hit> hits;
  hits.reserve(sweep.ranges.size());
  const double longest = std::min(options.max_laser_range, 65.0);
  for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
    const double range = static_cast<double>(sweep.ranges[i]);
    const BeamKind kind = kind_of(sweep.ranges[i], sweep);
    if (kind == BeamKind::unknown) continue;
    if (kind == BeamKind::free || range > longest) {
      scan.ranges.millimetres[i] = RangeImage::kNoReturn;
      continue;
    }
    const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
    hits.push_back({scanner_at(sweep, i) * Vector2{range * std::cos(angle), range * std::sin(angle)}, range,
                    static_cast<int>(i)});
    const double drawn = (hits.back().position - scan.ranges.X_BL.position()).norm();
    scan.ranges.millimetres[i] =
        static_cast<std::uint16_t>(std::clamp(std::round(drawn * 1000.0), 1.0, kLongestDrawn));
  }
  const double apart = 0.5 * options.resolution;
  Vector2 kept{1e9, 1e9};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if ((hits[i].position - kept).norm() < apart) continue;
    kept = hits[i].position;
    SurfacePoint point;
    point.x = static_cast<float>(kept.x());
    point.y = static_cast<float>(kept.y());
    set_normal(hits, i, std::abs(sweep.angle_increment), point);
    scan.points.push_back(point);
  }
  return scan;
}

std::optional<std::size_t> beam_towards(const RangeImage& image, const Vector2& p) {
  double turned = wrap_angle(std::atan2(p.y(), p.x()) - image.angle_min);
  if (turned * image.angle_increment < 0.0)
    turned += std::copysign(2.0 * std::numbers::pi, image.angle_increment);
  const auto beam = static_cast<std::size_t>(std::lround(turned / image.angle_increment));
  return beam < image.millimetres.size() ? std::optional(beam) : std::nullopt;
}

double seen_alike(const RangeImage& then, const RangeImage& now, const Pose2& X_TN) {
  const Pose2 X = inverse(then.X_BL) * X_TN * now.X_BL;
  int looked = 0;
  int alike = 0;
  for (std::size_t i = 0; i < now.millimetres.size(); ++i) {
    const std::uint16_t mm = now.millimetres[i];
    if (mm == RangeImage::kUnknown || mm == RangeImage::kNoReturn) continue;
    const double angle = now.angle_min + static_cast<double>(i) * now.angle_increment;
    const Vector2 p = X * Vector2(0.001 * mm * direction(angle));
    const std::optional<std::size_t> beam = beam_towards(then, p);
    if (!beam || *beam < 1 || *beam + 1 >= then.millimetres.size()) continue;
    // At the edge of an obstacle the next beam goes past: one of three that agrees will do.
    const double range = p.norm();
    ++looked;
    for (std::size_t b = *beam - 1; b <= *beam + 1; ++b) {
      if (then.millimetres[b] == RangeImage::kNoReturn) continue;
      if (std::abs(0.001 * then.millimetres[b] - range) > kAlike + kAlikeShare * range) continue;
      ++alike;
      break;
    }
  }
  return looked < kFewestBeams ? 1.0 : static_cast<double>(alike) / looked;
}

}  // namespace bw::slam
