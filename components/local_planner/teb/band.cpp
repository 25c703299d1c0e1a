#include "components/local_planner/teb/band.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw::teb {
namespace {

constexpr double kShortestInterval = 0.02;  // [s] of a band just made; well above the guard of the solver
constexpr double kShortestDistance = 0.05;  // [m] that has a direction
constexpr double kMeanInterval = 0.965;     // of dt_ref: what resampling aims at
constexpr double kMeanIntervalDrift =
    0.015;  // of dt_ref: keeps bands comparable, as their time cost grows with it

BandPose make(const Pose2& pose, double dt) { return {pose.x, pose.y, pose.theta, dt}; }

std::size_t wanted_count(double duration, const BandOptions& options) {
  const double intervals = std::clamp(std::round(duration / (kMeanInterval * options.dt_ref)),
                                      kFewestPoses - 1.0, options.max_samples - 1.0);
  return static_cast<std::size_t>(intervals) + 1;
}

// Positions from `start` along the part of the path ahead of it.
std::vector<Vector2> route_from(const Vector2& start, const std::vector<Pose2>& path) {
  std::size_t next = path.size() - 1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vector2 a = path[i].position();
    const Vector2 d = path[i + 1].position() - a;
    const double s = std::clamp((start - a).dot(d) / std::max(d.squaredNorm(), 1e-12), 0.0, 1.0);
    const double distance = (a + s * d - start).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      next = i + 1;
    }
  }
  std::vector<Vector2> route{start};
  for (std::size_t i = next; i < path.size(); ++i) route.push_back(path[i].position());
  return route;
}

}  // namespace

double Band::duration() const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) sum += poses[i].dt;
  return sum;
}

Pose2 Band::pose_at(double time) const {
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    if (time < poses[i].dt)
      return interpolate(poses[i].pose(), poses[i + 1].pose(), std::max(time, 0.0) / poses[i].dt);
    time -= poses[i].dt;
  }
  return poses.back().pose();
}

bool Band::is_finite() const {
  return std::all_of(poses.begin(), poses.end(),
                     [](const BandPose& p) { return bw::is_finite(p.pose()) && std::isfinite(p.dt); });
}

Pose2 interpolate(const Pose2& a, const Pose2& b, double s) {
  const double rotation = wrap_angle(b.theta - a.theta);
  const Vector2 chord = b.position() - a.position();
  const double theta = wrap_angle(a.theta + s * rotation);
  constexpr double kLargestArc = 1.0;  // [rad]; beyond it the poses are a first guess, not an arc
  if (std::abs(rotation) < 1e-6 || std::abs(rotation) > kLargestArc) {
    return {a.x + s * chord.x(), a.y + s * chord.y(), theta};
  }
  const double ratio = std::sin(s * rotation / 2.0) / std::sin(rotation / 2.0);
  const double bend = -(1.0 - s) * rotation / 2.0;
  const double c = ratio * std::cos(bend);
  const double n = ratio * std::sin(bend);
  return {a.x + c * chord.x() - n * chord.y(), a.y + n * chord.x() + c * chord.y(), theta};
}

namespace {

// Headings along the path (`heading_offset` 0) or against it (pi), at `speed`.
Band band_with_headings(const std::vector<Pose2>& path, const Pose2& start, const Limits& limits,
                        const BandOptions& options, double speed, double heading_offset) {
  const std::vector<Vector2> route = route_from(start.position(), path);
  const Pose2& goal = path.back();
  double length = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) length += (route[i] - route[i - 1]).norm();
  const double spacing = std::max(speed * options.dt_ref, length / (options.max_samples - 1.0));

  Band band;
  band.poses.reserve(static_cast<std::size_t>(options.max_samples) + 1);
  band.poses.push_back(make(start, 0.0));
  double carried = 0.0;  // length since the last pose
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Vector2 step = route[i] - route[i - 1];
    const double step_length = step.norm();
    if (step_length < 1e-9) continue;
    const double heading = wrap_angle(std::atan2(step.y(), step.x()) + heading_offset);
    double along = spacing - carried;
    while (along < step_length - 1e-9) {
      const Vector2 p = route[i - 1] + step * (along / step_length);
      band.poses.push_back({p.x(), p.y(), heading, 0.0});
      along += spacing;
    }
    carried = spacing - (along - step_length);
  }
  band.poses.push_back(make(goal, 0.0));
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    const Pose2 a = band.poses[i].pose();
    const Pose2 b = band.poses[i + 1].pose();
    band.poses[i].dt =
        std::max({(b.position() - a.position()).norm() / speed,
                  std::abs(wrap_angle(b.theta - a.theta)) / limits.omega_max, kShortestInterval});
  }
  resample(band, wanted_count(band.duration(), options));
  return band;
}

}  // namespace

Band band_along(const std::vector<Pose2>& path, const Pose2& start, const Limits& limits,
                const BandOptions& options) {
  return band_with_headings(path, start, limits, options, limits.v_max, 0.0);
}

std::optional<Band> band_rotating_first(const std::vector<Pose2>& path, const Pose2& start,
                                        const Limits& limits, const BandOptions& options,
                                        double least_rotation) {
  const std::vector<Vector2> route = route_from(start.position(), path);
  const auto away = std::find_if(route.begin(), route.end(), [&](const Vector2& p) {
    return (p - start.position()).norm() > kShortestDistance;
  });
  if (away == route.end()) return std::nullopt;
  const Vector2 to_path = *away - start.position();
  const double heading = std::atan2(to_path.y(), to_path.x());
  const double rotation = wrap_angle(heading - start.theta);
  if (std::abs(rotation) < least_rotation) return std::nullopt;
  const double duration = std::abs(rotation) / limits.omega_max;
  const int steps = static_cast<int>(
      std::clamp(std::ceil(duration / options.dt_ref), 1.0, static_cast<double>(options.max_samples)));
  Band band;
  for (int i = 0; i < steps; ++i) {
    band.poses.push_back(
        make({start.x, start.y, wrap_angle(start.theta + rotation * i / steps)}, duration / steps));
  }
  const Band drive = band_along(path, {start.x, start.y, heading}, limits, options);
  band.poses.insert(band.poses.end(), drive.poses.begin(), drive.poses.end());
  return band;
}

std::optional<Band> band_backward(const std::vector<Pose2>& path, const Pose2& start, const Limits& limits,
                                  const BandOptions& options) {
  const bool behind = (path.back().position() - start.position()).dot(direction(start.theta)) < 0.0;
  if (!behind || limits.v_back_max <= 0.0) return std::nullopt;
  return band_with_headings(path, start, limits, options, limits.v_back_max, std::numbers::pi);
}

void resample(Band& band, std::size_t count) {
  const double interval = band.duration() / static_cast<double>(count - 1);
  std::vector<BandPose> sampled;
  sampled.reserve(std::max(band.poses.capacity(), count));
  sampled.push_back(make(band.poses.front().pose(), interval));
  std::size_t i = 0;
  double begin = 0.0;  // time of pose i
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double time = static_cast<double>(k) * interval;
    while (i + 2 < band.size() && begin + band.poses[i].dt <= time) begin += band.poses[i++].dt;
    const double s = std::min((time - begin) / band.poses[i].dt, 1.0);
    sampled.push_back(make(interpolate(band.poses[i].pose(), band.poses[i + 1].pose(), s), interval));
  }
  sampled.push_back(make(band.poses.back().pose(), 0.0));
  band.poses = std::move(sampled);
}

void resize(Band& band, const BandOptions& options) {
  const double duration = band.duration();
  const std::size_t wanted = wanted_count(duration, options);
  bool drifted = band.size() < static_cast<std::size_t>(kFewestPoses) ||
                 band.size() > static_cast<std::size_t>(options.max_samples);
  if (wanted != band.size()) {
    const double mean = duration / static_cast<double>(band.size() - 1);
    drifted =
        drifted || std::abs(mean - kMeanInterval * options.dt_ref) > kMeanIntervalDrift * options.dt_ref;
  }
  for (std::size_t i = 1; i + 1 < band.size() && wanted > static_cast<std::size_t>(kFewestPoses); ++i) {
    drifted = drifted || std::abs(band.poses[i].dt - options.dt_ref) > options.dt_hysteresis;
  }
  if (drifted) resample(band, wanted);
}

double advance(Band& band, const Pose2& start, double horizon, const BandOptions& options) {
  std::size_t segment = 0;
  double fraction = 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  double begin = 0.0;
  for (std::size_t i = 0; i + 1 < band.size() && begin <= horizon; begin += band.poses[i++].dt) {
    const BandPose& a = band.poses[i];
    const Vector2 d = band.poses[i + 1].position() - a.position();
    const double rotation = kHeadingLength * wrap_angle(band.poses[i + 1].theta - a.theta);
    const Vector2 offset = start.position() - a.position();
    const double offset_rotation = kHeadingLength * wrap_angle(start.theta - a.theta);
    const double s = std::clamp(
        (offset.dot(d) + offset_rotation * rotation) / std::max(d.squaredNorm() + rotation * rotation, 1e-12),
        0.0, 1.0);
    const double distance = std::hypot((offset - s * d).norm(), offset_rotation - s * rotation);
    if (distance < nearest - 1e-9) {
      nearest = distance;
      segment = i;
      fraction = s;
    }
  }
  double first = (1.0 - fraction) * band.poses[segment].dt;
  // A short first interval would make the start acceleration stiff: let the next one absorb it.
  if (first < 0.5 * options.dt_ref && segment + 2 < band.size()) first += band.poses[++segment].dt;
  band.poses.erase(band.poses.begin(), band.poses.begin() + static_cast<std::ptrdiff_t>(segment));
  band.poses.front() = make(start, std::max(first, kShortestInterval));
  return nearest;
}

void set_goal(Band& band, const Pose2& goal) { band.poses.back() = make(goal, 0.0); }

}  // namespace bw::teb
