#include "components/lab/bench/slam/truth_score.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Cholesky>

#include "components/model/rigid_fit.hpp"
#include "components/slam/pose_graph.hpp"

namespace bw::slam {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr Duration kLookEvery = Duration::milliseconds(1000);
constexpr Duration kJudgedAfter = Duration::milliseconds(10'000);
constexpr double kReach = 3.0;  // [m]
constexpr double kTurn = 45.0 * kDegree;
constexpr double kWayBetween = 20.0;  // [m]
constexpr double kMissedFrom = 0.3;   // [m]
constexpr double kKept = 0.1;         // share of a loop's weight
constexpr double kQuantile95 = 7.81;  // chi-square, three degrees of freedom

bool is_beyond(const Pose2& error, double metres, double degrees) {
  return error.position().norm() > metres || std::abs(error.theta) > degrees * kDegree;
}

}  // namespace

Pose2 TruthOfScans::at(Time time) const {
  const auto reference = reference_at(drive_, time, Duration::milliseconds(1000));
  if (!reference || !reference->heading) throw std::runtime_error("the truth does not cover the drive");
  return {reference->position.x(), reference->position.y(), *reference->heading};
}

TrajectoryError trajectory_error(const std::vector<Pose2>& estimated, const std::vector<Pose2>& truth) {
  if (estimated.empty()) return {};
  const auto count = static_cast<double>(estimated.size());
  RigidFit fit;
  for (std::size_t k = 0; k < estimated.size(); ++k) fit.add(truth[k].position(), estimated[k].position());
  const Pose2 X = fit.X_AB();
  TrajectoryError error;
  for (std::size_t k = 0; k < estimated.size(); ++k) {
    const double distance = (X * estimated[k].position() - truth[k].position()).norm();
    error.rms += distance * distance / count;
    error.largest = std::max(error.largest, distance);
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

LoopFaults loop_faults(const Slam& slam, const TruthOfScans& truth) {
  // A submap's frame is the pose of its first scan. Where that left with another submap: by the first that lies in it.
  std::vector<Pose2> true_poses(slam.map().size());
  for (auto at = slam.nodes().rbegin(); at != slam.nodes().rend(); ++at) {
    const Node& node = at->second;
    true_poses[node.placement.submap] = truth.at(node.time) * inverse(node.placement.X_SB);
  }
  for (std::size_t k = 0; k < true_poses.size(); ++k) {
    const auto first = slam.nodes().find(slam.map()[k].first_node);
    if (first != slam.nodes().end()) true_poses[k] = truth.at(first->second.time);
  }
  LoopFaults faults;
  for (const Edge& edge : slam.edges()) {
    if (!edge.loop && edge.to == edge.from + 1) continue;  // of the drive, unless loops were composed into it
    const Pose2 X = inverse(true_poses[edge.from]) * true_poses[edge.to];
    const Pose2 error = inverse(X) * edge.X.X;
    ++faults.loops;
    if (is_beyond(error, 0.2, 1.0)) ++faults.wrong;
    if (!is_beyond(error, 1.0, 10.0)) continue;
    ++faults.gross;
    if (!edge.loop || weight_left(edge, slam.X_MS()) >= kKept) ++faults.gross_kept;
  }
  return faults;
}

const Revisits::Visit* Revisits::earlier(const Visit& visit) const {
  const Visit* nearest = nullptr;
  double least = kReach;
  for (const Visit& other : visits_) {
    if (other.way > visit.way - kWayBetween) break;
    const Vector2 between = visit.X_WB.position() - other.X_WB.position();
    const double distance = between.norm();
    if (distance >= least || std::abs(wrap_angle(visit.X_WB.theta - other.X_WB.theta)) >= kTurn) continue;
    const bool is_in_sight =
        distance < 1e-9 || walls_.ray_hit(other.X_WB.position(), between / distance, distance) >= distance;
    if (!is_in_sight) continue;
    nearest = &other;
    least = distance;
  }
  return nearest;
}

void Revisits::look(const SlamReplay& so_far) {
  const std::size_t newest = so_far.scans.size() - 1;
  const Time now = so_far.scans[newest].time;
  const Pose2 X_WB = truth_.at(now);
  if (newest > 0) way_ += (X_WB.position() - X_before_.position()).norm();
  X_before_ = X_WB;
  if (visits_.empty() || now - so_far.scans[visits_.back().scan].time >= kLookEvery)
    visits_.push_back({newest, X_WB, way_});
  for (; next_ < visits_.size() && now - so_far.scans[visits_[next_].scan].time >= kJudgedAfter; ++next_) {
    const Visit& visit = visits_[next_];
    const Visit* first = earlier(visit);
    if (first == nullptr) continue;
    ++count_;
    const Pose2 X_true = inverse(first->X_WB) * visit.X_WB;
    const Pose2 X_told = inverse(so_far.pose(first->scan)) * so_far.pose(visit.scan);
    if ((inverse(X_true) * X_told).position().norm() > kMissedFrom) ++missed_;
  }
}

Consistency consistency(const SlamReplay& replayed, const std::vector<Pose2>& truth) {
  Consistency result;
  std::size_t count = 0;
  for (std::size_t k = 1; k < replayed.scans.size(); ++k) {
    const ReplayedScan& scan = replayed.scans[k];
    const Eigen::LLT<Eigen::Matrix3d> root(scan.covariance);
    if (root.info() != Eigen::Success) continue;  // of a robot that has not moved yet
    const Pose2 X_MB = inverse(truth.front()) * truth[k];
    const Eigen::Vector3d e = difference(scan.told, X_MB);
    const double squared = e.dot(root.solve(e));
    result.anees += squared / 3.0;
    if (squared <= kQuantile95) result.share_in_95 += 1.0;
    ++count;
  }
  if (count == 0) return {};
  result.anees /= static_cast<double>(count);
  result.share_in_95 /= static_cast<double>(count);
  return result;
}

}  // namespace bw::slam
