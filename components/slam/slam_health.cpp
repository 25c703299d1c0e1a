#include "components/slam/slam_health.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::slam {
namespace {

constexpr double kDoubtful = 0.3;     // share of beams that must meet the map
constexpr double kUnseenFor = 1.0;    // [s] before it is worth a word
constexpr double kWindow = 1.0;       // [s] over which slip is summed
constexpr double kSlip = 0.08;        // [m]
constexpr double kSlipShare = 0.3;    // of what the wheels say
constexpr double kTurnSlip = 0.15;    // [rad]
constexpr double kTellsOfSlip = 0.6;  // share of inliers of a scan that tells of slip

}  // namespace

void HealthWatch::add(const Tracked& tracked, std::size_t points, const Pose2& X_MB, Time time) {
  kidnapped_ = tracked.held >= kKidnappedAfter;
  inliers_ = began_ ? tracked.match.inliers : 1.0;
  points_ = points;
  if (tracked.match.unseen.isZero()) {
    unseen_.reset();
  } else {
    // Of the submap's axes in the map's.
    const double turn = X_MB.theta - tracked.placement.X_SB.theta;
    if (!unseen_) unseen_since_ = time;
    unseen_ = turn + std::atan2(tracked.match.unseen.y(), tracked.match.unseen.x());
  }
  const Step step{time, difference(tracked.by_odometry, {}), difference(tracked.by_scan, {})};
  const double seconds = steps_.empty() ? 0.0 : (time - steps_.back().time).to_seconds();
  if (seconds > 0.0 && is_jump(tracked.by_odometry, seconds)) {
    jumped_ = time;
    jump_ = step.wheels.head<2>().norm();
  }
  const bool tells = began_ && tracked.matched && tracked.match.inliers >= kTellsOfSlip;
  steps_.push_back(tells ? step : Step{time, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  while ((time - steps_.front().time).to_seconds() > kWindow) steps_.pop_front();
  began_ = true;
}

std::optional<SlamHealth> HealthWatch::slip() const {
  Eigen::Vector3d wheels = Eigen::Vector3d::Zero();
  Eigen::Vector3d scanned = Eigen::Vector3d::Zero();
  for (const Step& step : steps_) {
    wheels += step.wheels;
    scanned += step.scanned;
  }
  const double way = wheels.head<2>().norm();
  if ((wheels - scanned).head<2>().norm() > std::max(kSlip, kSlipShare * way))
    return SlamHealth{HealthState::degraded, HealthCause::slip, way, scanned.head<2>().norm()};
  if (std::abs(wheels.z() - scanned.z()) > std::max(kTurnSlip, kSlipShare * std::abs(wheels.z())))
    return SlamHealth{HealthState::degraded, HealthCause::turn_slip, wheels.z(), scanned.z()};
  return std::nullopt;
}

SlamHealth HealthWatch::health(Time now) const {
  const auto degraded = [](HealthCause cause, double value = 0.0) {
    return SlamHealth{HealthState::degraded, cause, value};
  };
  if (!began_) return {};
  if (kidnapped_) return {HealthState::lost, HealthCause::kidnapped};
  if (jumped_ && (now - *jumped_).to_seconds() < kToldFor) return degraded(HealthCause::odometry_jump, jump_);
  if (points_ < kFewPoints) return degraded(HealthCause::no_features);
  if (inliers_ < kDoubtful) return degraded(HealthCause::no_match);
  if (const auto slipping = slip()) return *slipping;
  if (unseen_ && (now - unseen_since_).to_seconds() > kUnseenFor)
    return degraded(HealthCause::unseen,
                    *unseen_ - std::numbers::pi * std::floor(*unseen_ / std::numbers::pi));
  return {HealthState::ok, HealthCause::none};
}

}  // namespace bw::slam
