#include "components/messages/tracks.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "components/messages/geometry.hpp"
#include "components/messages/prediction.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

Eigen::Matrix2d rotated(const Eigen::Matrix2d& covariance, double angle) {
  const Eigen::Rotation2Dd R(angle);
  return R.toRotationMatrix() * covariance * R.toRotationMatrix().transpose();
}

Mover to_mover(const bandwagon_msgs::msg::Track& track, const Pose2& X_OF) {
  Mover mover;
  mover.id = track.id();
  mover.radius = track.radius();
  mover.confidence = tells_confidence(track) ? track.confidence() : 1.0;
  mover.position = X_OF * Vector2(track.position().x(), track.position().y());
  mover.velocity = rotate(X_OF, Vector2(track.velocity().x(), track.velocity().y()));
  for (const auto& p : track.predictions()) {
    Eigen::Matrix2d covariance;
    covariance << p.cov_xx(), p.cov_xy(), p.cov_xy(), p.cov_yy();
    const double time = p.time_from_start().sec() + 1e-9 * p.time_from_start().nanosec();
    mover.predictions.push_back({.time = time,
                                 .position = X_OF * Vector2(p.x(), p.y()),
                                 .covariance = rotated(covariance, X_OF.theta)});
  }
  return mover;
}

/// The mover as seen `age` seconds later, if it moved as predicted.
Mover advanced(Mover mover, double age) {
  const Vector2 position = mover.position_at(age);
  std::erase_if(mover.predictions, [&](const PredictedPosition& p) { return p.time <= age; });
  for (PredictedPosition& p : mover.predictions) p.time -= age;
  mover.position = position;
  return mover;
}

}  // namespace

bool tells_confidence(const bandwagon_msgs::msg::Track& track) {
  return track.confidence() >= 0.0 && track.confidence() <= 1.0;  // false for NaN
}

std::vector<Mover> to_movers(const bandwagon_msgs::msg::Tracks& message, const Pose2& X_OF, Time now) {
  const double age = (now - from_stamp(message.header().stamp())).to_seconds();
  std::vector<Mover> movers;
  for (const auto& track : message.tracks())
    movers.push_back(advanced(to_mover(track, X_OF), std::max(0.0, age)));
  return movers;
}

bandwagon_msgs::msg::Tracks to_message(const std::vector<Mover>& movers, const std::string& frame, Time now) {
  bandwagon_msgs::msg::Tracks message;
  message.header(make_header(frame, now));
  for (const Mover& mover : movers) {
    bandwagon_msgs::msg::Track track;
    track.id(mover.id);
    track.position(to_point(mover.position));
    track.velocity(to_vector3(mover.velocity));
    track.radius(mover.radius);
    track.confidence(mover.confidence);
    for (const PredictedPosition& prediction : mover.predictions)
      track.predictions().push_back(to_message(prediction));
    message.tracks().push_back(std::move(track));
  }
  return message;
}

}  // namespace bw
