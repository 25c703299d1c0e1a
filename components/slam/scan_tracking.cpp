#include "components/slam/scan_tracking.hpp"

#include <algorithm>
#include <cmath>

#include "components/slam/correlative_search.hpp"

namespace bw::slam {
namespace {

constexpr int kIterations = 10;
constexpr double kGoodMatch = 0.6;         // share of inliers with which nothing else is searched for
constexpr double kLeastMatch = 0.15;       // with less the scan says nothing
constexpr double kRefinedFrom = 0.2;       // [m] up to which refinement finds the way by itself
constexpr double kRefinedFromTurn = 0.05;  // [rad]
constexpr double kSlightlyBetter = 0.02;
constexpr double kBetterBy = 0.1;
constexpr double kMostAcceleration = 1.5;      // [m/s^2] of a base whose odometry is in time
constexpr double kMostTurnAcceleration = 3.0;  // [rad/s^2]
constexpr double kLate = 0.15;                 // [m] by which a pose can be off while odometry is late
constexpr double kLateTurn = 0.12;             // [rad]
constexpr double kMostWindow = 0.5;            // [m]
constexpr double kMostLateTurn = 0.4;          // [rad]
constexpr double kTurnAsTravel = 0.3;          // [m/rad] a turn shows new walls as travel does
constexpr double kTelling = 0.8;               // share of inliers of a scan that tells how odometry errs

}  // namespace

ScanTracking::Active ScanTracking::begun(std::size_t node, const UncertainPose& X_PS) const {
  Active active(options_.resolution);
  active.first_node = node;
  active.X_PS = X_PS;
  return active;
}

ScanTracking::Match ScanTracking::match(const Scan& scan, const UncertainPose& predicted) {
  Match best{refine(older_->surface, scan.points, predicted.X, &predicted, kIterations), predicted};
  // Walls farther away than refinement reaches, after a turn by as much as odometry may err.
  const auto unsure = [&](int axis) { return 3.0 * std::sqrt(predicted.covariance(axis, axis)); };
  if (unsure(0) > kRefinedFrom || unsure(1) > kRefinedFrom || unsure(2) > kRefinedFromTurn) {
    const Correlation found = correlate(older_->surface, scan.points, predicted.X,
                                        {std::min(unsure(0), kMostWindow), std::min(unsure(1), kMostWindow),
                                         std::min(unsure(2), kMostLateTurn)});
    const Refined refined = refine(older_->surface, scan.points, found.X, &predicted, kIterations);
    if (refined.inliers > best.refined.inliers + kSlightlyBetter) best.refined = refined;
  }
  if (best.refined.inliers >= kGoodMatch) {
    late_ = false;
    return best;
  }
  if (!late_) return best;
  // Odometry that came late stands still and then jumps: as likely as what it says is that the motion went on.
  for (const Pose2& start : {predicted.X, older_->X_before * step_before_}) {
    UncertainPose wide{start, predicted.covariance};
    wide.covariance.diagonal() += Eigen::Vector3d{kLate * kLate, kLate * kLate, kLateTurn * kLateTurn};
    const auto window = [&](int axis, double most) {
      return std::min(2.0 * std::sqrt(wide.covariance(axis, axis)), most);
    };
    const Correlation found =
        correlate(older_->surface, scan.points, start,
                  {window(0, kMostWindow), window(1, kMostWindow), window(2, kMostLateTurn)});
    const Refined refined = refine(older_->surface, scan.points, found.X, &wide, kIterations);
    if (refined.inliers > best.refined.inliers + kBetterBy) best = {refined, wide};
  }
  return best;
}

Tracked ScanTracking::add(const Scan& scan, const Pose2& X_OB, std::size_t nodes) {
  Tracked result;
  if (!older_) {
    older_ = begun(nodes, {});
    result.enters_map = true;
  } else {
    const Pose2 X_step = inverse(X_OB_) * X_OB;
    const UncertainPose step{X_step, trust_.covariance(X_step, options_)};
    const double travel = std::hypot(step.X.x, step.X.y);
    older_->X_before = older_->X_SB.X;
    older_->X_SB = older_->X_SB * step;
    if (younger_) younger_->X_SB = younger_->X_SB * step;
    const double seconds = std::max(1e-3, (scan.time - time_).to_seconds());
    const Eigen::Vector3d jolt = difference(step.X, odometry_before_) / (seconds * seconds);
    late_ = late_ || jolt.head<2>().norm() > kMostAcceleration || std::abs(jolt.z()) > kMostTurnAcceleration;
    odometry_before_ = step.X;
    const Match found = match(scan, older_->X_SB);
    result.match = found.refined;
    result.matched = result.match.inliers >= kLeastMatch;
    if (result.matched) {
      const auto updated = [](const Eigen::Matrix3d& prior,
                              const Eigen::Matrix3d& information) -> Eigen::Matrix3d {
        const Eigen::Matrix3d sum = (prior + 1e-12 * Eigen::Matrix3d::Identity()).inverse() + information;
        return sum.inverse();
      };
      older_->X_SB = {result.match.X, updated(found.prior.covariance, result.match.information)};
      if (younger_) {
        const Eigen::Matrix3d R = by_second(younger_->X_PS.X);
        younger_->X_SB = {inverse(younger_->X_PS.X) * older_->X_SB.X,
                          updated(younger_->X_SB.covariance, R.transpose() * result.match.information * R)};
      }
    }
    if (result.match.inliers >= kTelling && !late_) {
      const Eigen::Matrix3d R = by_second(older_->X_before);
      trust_.learn(X_step, inverse(older_->X_before) * result.match.X,
                   R.transpose() * found.prior.covariance * R, R.transpose() * result.match.information * R,
                   options_);
    }
    step_before_ = inverse(older_->X_before) * older_->X_SB.X;
    since_node_ += travel;
    turned_since_node_ += std::abs(step.X.theta);
    const double progress = travel + kTurnAsTravel * std::abs(step.X.theta);
    older_->travel += progress;
    if (younger_) younger_->travel += progress;
    result.enters_map = since_node_ >= options_.minimum_travel_distance ||
                        turned_since_node_ >= options_.minimum_travel_heading;
  }
  X_OB_ = X_OB;
  time_ = scan.time;
  if (result.enters_map) {
    since_node_ = 0.0;
    turned_since_node_ = 0.0;
    older_->surface.insert(scan.points, older_->X_SB.X);
    if (younger_) younger_->surface.insert(scan.points, younger_->X_SB.X);
  }
  const double half = 0.5 * options_.submap_length;
  result.X_SB = older_->X_SB;
  result.placement = {submap_, older_->X_SB.X, younger_ ? std::min(1.0, younger_->travel / half) : 0.0};
  if (!result.enters_map) return result;
  if (younger_ && younger_->travel >= half) {
    result.finished = Submap{older_->X_PS, older_->surface.surfaces(), older_->first_node, nodes};
    older_ = std::move(younger_);
    younger_.reset();
    ++submap_;
  }
  if (!younger_ && older_->travel >= half) {
    younger_ = begun(nodes, older_->X_SB);
    younger_->surface.insert(scan.points, Pose2{});
  }
  return result;
}

std::vector<Submap> ScanTracking::finish(std::size_t nodes) {
  std::vector<Submap> submaps;
  for (std::optional<Active>* active : {&older_, &younger_}) {
    if (*active)
      submaps.push_back({(*active)->X_PS, (*active)->surface.surfaces(), (*active)->first_node, nodes});
    active->reset();
  }
  return submaps;
}

std::vector<UncertainPose> ScanTracking::under_way(std::size_t first, std::size_t last) const {
  std::vector<UncertainPose> steps;
  if (older_ && first <= submap_ && submap_ <= last) steps.push_back(older_->X_PS);
  if (younger_ && first <= submap_ + 1 && submap_ + 1 <= last) steps.push_back(younger_->X_PS);
  return steps;
}

}  // namespace bw::slam
