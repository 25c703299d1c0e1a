// Drawings of the filters: a late fix in the EKF, and particles over a likelihood field.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "components/lab/figures/figures.hpp"
#include "components/lab/figures/plane.hpp"
#include "components/lab/figures/room.hpp"
#include "components/localization/ekf/ekf.hpp"
#include "components/localization/particle_filter/particle_filter.hpp"
#include "components/model/differential_drive.hpp"
#include "components/world/laser_scanner.hpp"

namespace bw::figures {
namespace {

using localization::Ekf;
using localization::Estimate;
using localization::ParticleFilter;

constexpr double kPeriod = 0.05;  // [s] between wheel steps
const Time kBegin = Time::seconds(100.0);

Time at_step(std::size_t i) { return kBegin + Duration::seconds(kPeriod * static_cast<double>(i)); }

/// What wheels with `k` [m] (variance of a metre's travel) measure of one step; and `slant` [rad/m] that they
/// do not know of.
WheelStep wheel_step(std::size_t i, const Pose2& from, const Pose2& to, double k, double slant,
                     Random& random) {
  const Pose2 by = inverse(from) * to;
  const double distance = std::hypot(by.x, by.y);
  WheelStep step{.time = at_step(i), .over = Duration::seconds(kPeriod)};
  step.covariance = Eigen::Vector2d(k * distance, 4.0 * k * distance).asDiagonal();
  step.distance = distance + std::sqrt(k * distance) * random.normal();
  step.rotation = by.theta + slant * distance + std::sqrt(4.0 * k * distance) * random.normal();
  return step;
}

std::vector<Vector2> positions(const std::vector<Pose2>& poses) {
  std::vector<Vector2> points;
  for (const Pose2& pose : poses) points.push_back(pose.position());
  return points;
}

}  // namespace

// Wheels alone drift; a fix of 1.5 s ago arrives, is used at its own stamp, and what the wheels said since is
// predicted again.
std::string late_measurement() {
  constexpr std::size_t kNow = 120, kMeasured = 90;
  const std::vector<Pose2> truth = path_through_room(static_cast<int>(kNow));
  Random random(3);
  Ekf ekf({});
  ekf.start_at(truth[0], Eigen::Vector3d(4e-4, 4e-4, 1e-3).asDiagonal(), at_step(0));
  std::vector<Estimate> before;
  for (std::size_t i = 1; i <= kNow; ++i) {
    ekf.add(wheel_step(i, truth[i - 1], truth[i], 2e-3, 0.07, random), at_step(i));
    if (i % 10 == 0) before.push_back(ekf.estimate_at(at_step(i)));
  }
  const localization::PositionFix fix{.time = at_step(kMeasured),
                                      .source = 1,
                                      .position = truth[kMeasured].position() + Vector2(0.03, -0.02),
                                      .covariance = 0.01 * Eigen::Matrix2d::Identity()};
  const localization::Outcome outcome = ekf.add(fix, at_step(kNow));
  const Estimate after = ekf.estimate_at(at_step(kNow));

  Plane plane("A late measurement in the EKF", kRoom, kFloor);
  draw_room(plane);
  plane.curve(positions(truth), kGrey, 1.6, "5 4");
  std::vector<Vector2> path;
  for (const Estimate& estimate : before) {
    path.push_back(estimate.X_MB.position());
    plane.ellipse(estimate.X_MB.position(), estimate.covariance.topLeftCorner<2, 2>(), 2.0, kBlue);
  }
  plane.curve(path, kBlue, 2.0);
  plane.ellipse(fix.position, fix.covariance, 2.0, kOrange);
  plane.dot(fix.position, 3.5, kOrange);
  plane.note(fix.position, "fix, 1.5 s old", 10.0, -22.0, kVermilion);
  plane.ellipse(after.X_MB.position(), after.covariance.topLeftCorner<2, 2>(), 2.0, kGreen);
  plane.arrow(path.back(), after.X_MB.position() - path.back(), kGreen, 2.4);
  plane.dot(truth.back().position(), 3.5, kBlack);
  plane.note(truth.back().position(), "truth now", 8.0, 8.0);
  plane.key(kBlue, "wheels alone, with two standard deviations of the position each 0.5 s");
  plane.key(kOrange, "the position fix, and two standard deviations of it");
  plane.key(
      kGreen,
      fmt::format(
          "correction of the present: the fix is used at its stamp and {} later steps are predicted again",
          outcome.replayed));
  return std::move(plane).finish();
}

std::string particle_cloud() {
  const OccupancyGrid map = room_map();
  localization::ParticleFilterOptions options;
  ParticleFilter filter(options, 1);
  filter.set_map(map);
  const std::vector<Pose2> truth = path_through_room(120);
  const StaticScene scene(room_shapes(), std::nullopt);
  LaserScanner scanner({.beams = 180, .range_max = 8.0, .range_noise = 0.02}, Random(5));
  Random random(4);
  filter.start_at(truth[0], Eigen::Vector3d(0.16, 0.16, 0.04).asDiagonal(), at_step(0));

  Plane plane("Particles over the likelihood field", kRoom, kFloor);
  const localization::LikelihoodField field(map, {});
  plane.shades(0.1, kOrange, [&field](const Vector2& p) {
    return 0.6 * std::exp(-0.5 * std::pow(field.distance(p.x(), p.y()) / field.options().sigma_hit, 2));
  });
  draw_room(plane);
  const auto draw_cloud = [&](std::string_view color) {
    const localization::ParticleSet& particles = *filter.particles();
    for (std::size_t i = 0; i < particles.size(); i += 4)
      plane.dot({particles.x[i], particles.y[i]}, 1.4, color, 0.5);
  };
  const auto draw_truth = [&](std::size_t i) {
    plane.disc(truth[i].position(), 0.2, kBlack, 0.0);
    plane.arrow(truth[i].position(), 0.4 * direction(truth[i].theta), kBlack);
  };
  draw_cloud(kBlue);
  draw_truth(0);
  for (std::size_t i = 1; i < truth.size(); ++i) {
    filter.add(wheel_step(i, truth[i - 1], truth[i], 2e-3, 0.0, random), at_step(i));
    if (i % 5 != 0) continue;
    const LaserScan scan = scanner.scan(scene, {}, truth[i]);
    localization::LaserReading reading;
    reading.time = at_step(i);
    reading.source = 1;
    reading.angle_min = scan.angle_min;
    reading.angle_increment = scan.angle_increment;
    reading.range_min = 0.05;
    reading.range_max = 8.0;
    reading.ranges = scan.ranges;
    filter.add(reading, at_step(i));
    if (i + 1 < truth.size()) continue;
    for (std::size_t beam = 0; beam < scan.ranges.size(); beam += 6)
      if (std::isfinite(scan.ranges[beam]))
        plane.dot(truth[i] * (static_cast<double>(scan.ranges[beam]) *
                              direction(scan.angle_min + static_cast<double>(beam) * scan.angle_increment)),
                  2.6, kVermilion);
  }
  draw_cloud(kGreen);
  draw_truth(truth.size() - 1);
  plane.key(kOrange, "likelihood field: how likely a beam ends there");
  plane.key(kBlue, "each fourth particle at the start: the pose is known within 0.4 m");
  plane.key(kGreen,
            fmt::format("after {:.1f} m and the sweeps on the way; the circle is the robot", 0.8 * 6.0));
  plane.key(kVermilion, "ends of the last sweep's beams");
  return std::move(plane).finish();
}

}  // namespace bw::figures
