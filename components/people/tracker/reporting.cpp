#include "components/people/tracker/reporting.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace bw::people {
namespace {

constexpr double kUnborn = 0.49;  // most confident that what is no person yet can be
constexpr double kRest = 0.1;     // [m/s] how surely something that stands does not move

}  // namespace

TrackedPerson report_of(const PersonTrack& person, const Pose2& X_OS, double radius) {
  Eigen::Matrix4d R = Eigen::Matrix4d::Zero();
  R.topLeftCorner<2, 2>() = R.bottomRightCorner<2, 2>() = Eigen::Rotation2Dd(X_OS.theta).toRotationMatrix();
  const double seen = person.there * person.existence.confidence();
  return {{.id = person.id,
           .position = X_OS * person.heading.position(),
           .velocity = rotate(X_OS, person.heading.velocity()),
           .radius = radius,
           .confidence = 1.0 - (1.0 - seen) * (1.0 - person.heard)},
          R * person.heading.true_covariance() * R.transpose(),
          person.born,
          person.confirmed,
          person.last_known()};
}

TrackedPerson report_of(const ClusterTrack& possible, Time origin, const Pose2& X_OS, double radius) {
  TrackedPerson person;
  person.id = possible.id;
  person.position = X_OS * possible.position();
  person.radius = radius;
  person.confidence = std::min(possible.existence.confidence(), kUnborn);
  person.covariance.diagonal() << Vector2::Constant(possible.variance()), Vector2::Constant(kRest * kRest);
  const auto time = [&](double seconds) { return origin + Duration::seconds(seconds); };
  person.born = time(possible.born());
  person.confirmed = person.last_seen = time(possible.last().time);
  return person;
}

}  // namespace bw::people
