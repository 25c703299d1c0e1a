#include "components/people/detector/detector.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "components/people/detector/classifier.hpp"
#include "components/people/detector/disc_fit.hpp"
#include "components/people/detector/static_map.hpp"

namespace bw::people {

Detector::Detector(const DetectorOptions& options) : options_(options), local_(options.background) {}

void Detector::reset() { local_.reset(); }

const DetectionSet& Detector::detect(const LaserSweep& sweep, const Surroundings& surroundings) {
  result_.time = sweep.time;
  result_.detections.clear();
  result_.free_ranges.clear();
  clusters_.members.clear();
  clusters_.all.clear();
  if (fault_for_people(sweep) != SweepFault::none) return result_;
  read_beams(sweep, beams_);
  result_.sensor = beams_.sensor;
  result_.angle_min = beams_.angle_min;
  result_.angle_increment = beams_.angle_increment;
  result_.free_ranges.assign(beams_.ranges.begin(), beams_.ranges.end());
  local_.learn(beams_, sweep.time, surroundings.people);
  find_background(surroundings);
  find_clusters(beams_, is_background_, options_.clusters, clusters_);
  const std::vector<Neighbours>& neighbours = neighbours_.find(beams_, clusters_);
  for (std::size_t i = 0; i < clusters_.all.size(); ++i)
    result_.detections.push_back(describe(clusters_.all[i], neighbours[i]));
  return result_;
}

void Detector::find_background(const Surroundings& surroundings) {
  const auto is_in_map = [&](const Vector2& p_O) {
    return surroundings.map != nullptr && surroundings.X_MO &&
           is_near_wall(*surroundings.map, *surroundings.X_MO * p_O, BackgroundOptions::kMapTolerance);
  };
  is_background_.assign(beams_.kinds.size(), 0);
  for (std::size_t i = 0; i < is_background_.size(); ++i) {
    if (beams_.kinds[i] != BeamKind::hit) continue;
    const Vector2& p_O = beams_.points[i];
    is_background_[i] = local_.contains(p_O) || is_in_map(p_O);
  }
}

Detection Detector::describe(const Cluster& cluster, const Neighbours& neighbours) {
  read_outline(beams_, clusters_, cluster, outline_);
  Detection detection;
  detection.width = outline_.width();
  detection.points = cluster.count;
  detection.occluded = cluster.left.occluded || cluster.right.occluded;
  const auto members = clusters_.beams_of(cluster);
  detection.after = beams_.taken_after(members[members.size() / 2]);
  const auto background = std::count_if(members.begin(), members.end(), [&](int beam) {
    return is_background_[static_cast<std::size_t>(beam)] != 0;
  });
  detection.on_static =
      static_cast<double>(background) >= options_.background.kShare * static_cast<double>(members.size());
  if (detection.width > kWidestPerson) {
    detection.position = outline_.X_OC.position();
    const double sigma = detection.width / 4.0;  // where in a wall its middle is says little
    detection.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
    return detection;
  }
  DiscFit fit = fit_disc(outline_, options_.legs);
  const HumanScores scores = classify(features_of(outline_, fit, neighbours));
  detection.leg_score = scores.leg;
  detection.body_score = scores.body;
  if (scores.body > scores.leg) fit = fit_two_discs(outline_, options_.legs);
  detection.position = outline_.X_OC * fit.center;
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(outline_.X_OC.theta).toRotationMatrix();
  detection.covariance = R * fit.covariance * R.transpose();
  return detection;
}

}  // namespace bw::people
