#include "components/slam/scan_tracking.hpp"

#include <algorithm>
#include <cmath>

#include "components/slam/correlative_search.hpp"

namespace bw::slam {
namespace {

constexpr int kIterations = 10;
constexpr double kGoodMatch = 0.6;    // share of inliers with which nothing else is searched for
constexpr double kLeastMatch = 0.15;  // with less the scan says nothing
constexpr double kMeets = 0.8;  // share of a scan on walls, or as the one before saw it; less: another place
constexpr double kHardlyMoved = 0.3;       // [m, rad] what is in view is the same
constexpr double kRefinedFrom = 0.2;       // [m] up to which refinement finds the way by itself
constexpr double kRefinedFromTurn = 0.05;  // [rad]
constexpr double kSlightlyBetter = 0.02;
constexpr double kBetterBy = 0.1;
constexpr double kMostAcceleration = 1.5;      // [m/s^2] of a base whose odometry is in time
constexpr double kMostTurnAcceleration = 3.0;  // [rad/s^2]
constexpr double kMostWindow = 0.5;            // [m]
constexpr double kMostLateTurn = 0.4;          // [rad]
constexpr double kTurnAsTravel = 0.3;          // [m/rad] a turn shows new walls as travel does
constexpr double kTelling = 0.8;               // share of inliers of a scan that tells how odometry errs

// By which a pose can be off while odometry is late: 0.15 m and 0.12 rad.
const Eigen::Vector3d kLateVariance{0.15 * 0.15, 0.15 * 0.15, 0.12 * 0.12};

}  // namespace

Submap ScanTracking::Active::finished(std::size_t nodes) const {
  Submap submap;
  submap.found_in = joint.found_in;
  submap.X_PS = joint.X_PS;
  submap.surfaces = surface.surfaces();
  submap.first_node = first_node;
  submap.last_node = nodes;
  return submap;
}

ScanTracking::ScanTracking(const SlamOptions& options, const State& state) : options_(options), now_(state) {
  if (state.older) older_.emplace(options.resolution, *state.older);
  if (state.younger) younger_.emplace(options.resolution, *state.younger);
}

ScanTracking::State ScanTracking::state() const {
  State state{now_, std::nullopt, std::nullopt};
  if (older_) state.older = older_->state();
  if (younger_) state.younger = younger_->state();
  return state;
}

ScanTracking::Active ScanTracking::begun(std::size_t node, const Joint& joint) const {
  Active active(options_.resolution);
  active.first_node = node;
  active.joint = joint;
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
    now_.late = false;
    return best;
  }
  if (!now_.late) return best;
  // Odometry that came late stands still and then jumps: as likely as what it says is that the motion went on.
  for (const Pose2& start : {predicted.X, older_->X_before * now_.step_before}) {
    UncertainPose wide{start, predicted.covariance};
    wide.covariance.diagonal() += kLateVariance;
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

int ScanTracking::held(const Scan& scan, const Pose2& X_OB, const Refined& match) {
  if (!options_.holds_back || scan.points.size() < kFewPoints) return held_ = 0;
  if (!met_) met_ = Met{X_OB, scan.ranges};
  const Pose2 moved = inverse(met_->X_OB) * X_OB;
  if (match.inliers >= kMeets || seen_alike(met_->ranges, scan.ranges, moved) >= kMeets) {
    met_ = Met{X_OB, scan.ranges};
    return held_ = 0;
  }
  if (held_ > 0) return ++held_;
  if (std::hypot(moved.x, moved.y) > kHardlyMoved || std::abs(moved.theta) > kHardlyMoved) {
    met_ = Met{X_OB, scan.ranges};
    return 0;
  }
  // Odometry that came late is another reason.
  return held_ = now_.late ? 0 : 1;
}

Tracked ScanTracking::add(const Scan& scan, const Pose2& X_OB, std::size_t nodes) {
  Tracked result;
  if (!older_) {
    older_ = begun(nodes, start_);
    result.enters_map = true;
    met_ = Met{X_OB, scan.ranges};
    held_ = 0;
  } else {
    const double seconds = std::max(1e-3, (scan.time - now_.time).to_seconds());
    result.by_odometry = inverse(now_.X_OB) * X_OB;
    const bool jumped = is_jump(result.by_odometry, seconds);
    const Pose2 X_step = jumped ? now_.step_before : result.by_odometry;
    UncertainPose step{X_step, now_.trust.covariance(X_step, options_)};
    if (jumped) step.covariance.diagonal() += kLateVariance;
    const double travel = std::hypot(step.X.x, step.X.y);
    older_->X_before = older_->X_SB.X;
    older_->X_SB = older_->X_SB * step;
    if (younger_) younger_->X_SB = younger_->X_SB * step;
    const Eigen::Vector3d jolt = difference(step.X, now_.odometry_before) / (seconds * seconds);
    now_.late = now_.late || jumped || jolt.head<2>().norm() > kMostAcceleration ||
                std::abs(jolt.z()) > kMostTurnAcceleration;
    now_.odometry_before = step.X;
    const Match found = match(scan, older_->X_SB);
    result.match = found.refined;
    result.held = held(scan, X_OB, result.match);
    result.matched = result.match.inliers >= kLeastMatch && result.held == 0;
    if (result.matched) {
      const auto updated = [](const Eigen::Matrix3d& prior,
                              const Eigen::Matrix3d& information) -> Eigen::Matrix3d {
        const Eigen::Matrix3d sum = (prior + 1e-12 * Eigen::Matrix3d::Identity()).inverse() + information;
        return sum.inverse();
      };
      older_->X_SB = {result.match.X, updated(found.prior.covariance, result.match.information)};
      if (younger_) {
        const Pose2& X_PS = younger_->joint.X_PS.X;
        const Eigen::Matrix3d R = by_second(X_PS);
        younger_->X_SB = {inverse(X_PS) * older_->X_SB.X,
                          updated(younger_->X_SB.covariance, R.transpose() * result.match.information * R)};
      }
    }
    if (result.match.inliers >= kTelling && !now_.late) {
      const Eigen::Matrix3d R = by_second(older_->X_before);
      now_.trust.learn(X_step, inverse(older_->X_before) * result.match.X,
                       R.transpose() * found.prior.covariance * R,
                       R.transpose() * result.match.information * R, options_);
    }
    now_.step_before = inverse(older_->X_before) * older_->X_SB.X;
    result.by_scan = now_.step_before;
    now_.since_node += travel;
    now_.turned_since_node += std::abs(step.X.theta);
    const double progress = travel + kTurnAsTravel * std::abs(step.X.theta);
    older_->travel += progress;
    if (younger_) younger_->travel += progress;
    result.enters_map = result.held == 0 && (now_.since_node >= options_.minimum_travel_distance ||
                                             now_.turned_since_node >= options_.minimum_travel_heading);
  }
  now_.X_OB = X_OB;
  now_.time = scan.time;
  if (result.enters_map) {
    now_.since_node = 0.0;
    now_.turned_since_node = 0.0;
    older_->surface.insert(scan.points, older_->X_SB.X);
    if (younger_) younger_->surface.insert(scan.points, younger_->X_SB.X);
  }
  const double half = 0.5 * options_.submap_length;
  result.X_SB = older_->X_SB;
  result.placement = {now_.submap, older_->X_SB.X, younger_ ? std::min(1.0, younger_->travel / half) : 0.0};
  if (!result.enters_map) return result;
  if (younger_ && younger_->travel >= half) {
    result.finished = older_->finished(nodes);
    older_ = std::move(younger_);
    younger_.reset();
    ++now_.submap;
  }
  if (!younger_ && older_->travel >= half) {
    younger_ = begun(nodes, {std::nullopt, older_->X_SB});
    younger_->surface.insert(scan.points, Pose2{});
  }
  return result;
}

std::vector<Submap> ScanTracking::finish(std::size_t nodes) {
  std::vector<Submap> submaps;
  for (std::optional<Active>* active : {&older_, &younger_}) {
    if (*active) submaps.push_back((*active)->finished(nodes));
    active->reset();
  }
  now_.submap += submaps.size();
  return submaps;
}

void ScanTracking::begin_at(std::size_t found_in, const UncertainPose& X_PB) {
  start_ = {found_in, X_PB};
  now_.late = false;
  now_.odometry_before = {};
  now_.step_before = {};
  now_.since_node = 0.0;
  now_.turned_since_node = 0.0;
}

std::optional<ScanTracking::Joint> ScanTracking::joint(std::size_t submap) const {
  if (older_ && submap == now_.submap) return older_->joint;
  if (younger_ && submap == now_.submap + 1) return younger_->joint;
  return std::nullopt;
}

}  // namespace bw::slam
