#include "components/lab/people_training/figures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "components/lab/people_training/labels.hpp"

namespace bw::people {
namespace {

constexpr double kNear = 6.0;  // [m]

class Scoring {
 public:
  void add(const TrainingRoom& room, const RoomSweep& sweep, const Detector& detector,
           const DetectionSet& set) {
    const Pose2 X_MO = sweep.X_MO();
    const auto seen = visibility(sweep, detector);
    const auto labels = label_clusters(room, sweep, detector);
    std::vector<bool> found(sweep.people.size(), false);
    for (std::size_t i = 0; i < set.detections.size(); ++i) {
      const Detection& detection = set.detections[i];
      if (std::max(detection.leg_score, detection.body_score) < 0.5) continue;
      const Vector2 p_M = X_MO * detection.position;
      const double nearest = match(sweep, p_M, found);
      if (!detection.on_static && (p_M - sweep.X_ML.position()).norm() < kNear) {
        ++figures.detections;
        if (nearest < 0.4) ++figures.right;
      }
      judge_position(sweep, labels[i], detection, p_M, X_MO);
    }
    for (std::size_t person = 0; person < found.size(); ++person) {
      const bool near = (sweep.people[person].position - sweep.X_ML.position()).norm() < kNear;
      if (!near || seen[person].expected == 0 || 2 * seen[person].seen < seen[person].expected) continue;
      ++figures.people;
      if (found[person]) ++figures.found;
    }
  }

  PeopleFigures finish() {
    const double legs = std::max(figures.legs, 1);
    figures.leg_bias_away /= legs;
    figures.leg_bias_left /= legs;
    figures.leg_error = std::sqrt(figures.leg_error / legs);
    figures.leg_nees /= legs;
    figures.body_error = std::sqrt(figures.body_error / std::max(figures.bodies, 1));
    return figures;
  }

 private:
  static double match(const RoomSweep& sweep, const Vector2& p_M, std::vector<bool>& found) {
    double nearest = 1e9;
    for (std::size_t person = 0; person < found.size(); ++person) {
      const double distance = (sweep.people[person].position - p_M).norm();
      nearest = std::min(nearest, distance);
      if (distance < 0.3) found[person] = true;
    }
    return nearest;
  }

  void judge_position(const RoomSweep& sweep, const Label& label, const Detection& detection,
                      const Vector2& p_M, const Pose2& X_MO) {
    const bool as_leg = detection.leg_score >= detection.body_score;
    if ((p_M - sweep.X_ML.position()).norm() > kNear || label.leg < 0) return;
    if (as_leg && label.kind == Kind::leg) {
      const Vector2 error = p_M - sweep.legs[static_cast<std::size_t>(label.leg)].center;
      const Vector2 sight = (p_M - sweep.X_ML.position()).normalized();
      ++figures.legs;
      figures.leg_bias_away += sight.dot(error);
      figures.leg_bias_left += cross(sight, error);
      figures.leg_error += error.squaredNorm();
      const Eigen::Matrix2d R = Eigen::Rotation2Dd(X_MO.theta).toRotationMatrix();
      const Eigen::Matrix2d covariance_M = R * detection.covariance * R.transpose();
      figures.leg_nees += error.dot(covariance_M.inverse() * error);
    }
    if (!as_leg && label.kind == Kind::body) {
      const Vector2 error = p_M - sweep.people[static_cast<std::size_t>(label.leg / 2)].position;
      ++figures.bodies;
      figures.body_error += error.squaredNorm();
    }
  }

 public:
  PeopleFigures figures;
};

}  // namespace

ClassifierFigures figures_of(std::span<const double> scores, std::span<const std::uint8_t> positive) {
  ClassifierFigures figures;
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
  double below = 0.0;  // negatives with a lower score
  double pairs = 0.0;
  int taken = 0;
  int right = 0;
  for (std::size_t i = 0; i < order.size();) {
    double same_negatives = 0.0;
    double same_positives = 0.0;
    const double score = scores[order[i]];
    for (; i < order.size() && scores[order[i]] == score; ++i) {
      (positive[order[i]] != 0 ? same_positives : same_negatives) += 1.0;
    }
    pairs += same_positives * (below + same_negatives / 2.0);
    below += same_negatives;
    figures.positives += static_cast<int>(same_positives);
    figures.negatives += static_cast<int>(same_negatives);
    if (score < 0.5) continue;
    taken += static_cast<int>(same_positives + same_negatives);
    right += static_cast<int>(same_positives);
  }
  if (figures.positives > 0 && figures.negatives > 0)
    figures.area = pairs / (static_cast<double>(figures.positives) * figures.negatives);
  if (taken > 0) figures.precision = static_cast<double>(right) / taken;
  if (figures.positives > 0) figures.recall = static_cast<double>(right) / figures.positives;
  return figures;
}

PeopleFigures try_detector(const Trial& trial) {
  Scoring scoring;
  for (int r = 0; r < trial.rooms; ++r) {
    const RoomOptions options{.most_people = trial.most_people,
                              .furnished = true,
                              .varied_scanner = trial.varied_scanner,
                              .moving = trial.moving};
    TrainingRoom room(options, trial.first_seed + static_cast<std::uint64_t>(r));
    Detector detector(DetectorOptions{});
    std::vector<Vector2> people;
    for (int s = 0; s < trial.sweeps; ++s) {
      const RoomSweep& sweep = room.next();
      people.clear();
      const Pose2 X_OM = inverse(sweep.X_MO());
      for (const Person& person : sweep.people) people.push_back(X_OM * person.position);
      const DetectionSet& set = detector.detect(room.view(), {nullptr, std::nullopt, people});
      if (s % 5 == 0) scoring.add(room, sweep, detector, set);
    }
  }
  return scoring.finish();
}

}  // namespace bw::people
