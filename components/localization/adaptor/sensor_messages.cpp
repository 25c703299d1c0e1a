#include "components/localization/adaptor/sensor_messages.hpp"

#include <cmath>

#include "components/messages/geometry.hpp"

namespace bw::localization {
namespace {

constexpr double kYawUnknown = 10.0;   // [rad^2]
constexpr double kNotMeasured = -1.0;  // first element of a covariance, by sensor_msgs/Imu

double variance_or(double given, double sigma) { return given != 0.0 ? given : sigma * sigma; }

}  // namespace

std::optional<GyroReading> to_gyro(const sensor_msgs::msg::Imu& message, int source, double sigma) {
  if (message.angular_velocity_covariance()[0] == kNotMeasured) return std::nullopt;
  return GyroReading{from_stamp(message.header().stamp()), source, message.angular_velocity().z(),
                     variance_or(message.angular_velocity_covariance()[8], sigma)};
}

std::optional<HeadingReading> to_heading(const sensor_msgs::msg::Imu& message, int source, const Pose2& X_BS,
                                         double sigma) {
  if (message.orientation_covariance()[0] == kNotMeasured) return std::nullopt;
  return HeadingReading{from_stamp(message.header().stamp()), source,
                        wrap_angle(yaw_of(message.orientation()) - X_BS.theta),
                        variance_or(message.orientation_covariance()[8], sigma)};
}

std::optional<Geodetic> to_geodetic(const sensor_msgs::msg::NavSatFix& message, double unknown_altitude) {
  if (message.status().status() < sensor_msgs::msg::NavSatStatus_Constants::STATUS_FIX) return std::nullopt;
  const double altitude = std::isfinite(message.altitude()) ? message.altitude() : unknown_altitude;
  const Geodetic geodetic{message.latitude(), message.longitude(), altitude};
  return is_plausible(geodetic) ? std::optional(geodetic) : std::nullopt;
}

PositionFix to_fix(const sensor_msgs::msg::NavSatFix& message, int source, const Geodetic& geodetic,
                   const LocalPlane& plane, const Pose2& X_BS, double sigma) {
  PositionFix fix;
  fix.time = from_stamp(message.header().stamp());
  fix.source = source;
  fix.position = plane.to_plane(geodetic).head<2>();
  fix.antenna = X_BS.position();
  const auto& C = message.position_covariance();
  const bool unknown =
      message.position_covariance_type() == sensor_msgs::msg::NavSatFix_Constants::COVARIANCE_TYPE_UNKNOWN;
  if (unknown || (C[0] == 0.0 && C[4] == 0.0)) {
    fix.covariance = Eigen::Matrix2d::Identity() * sigma * sigma;
  } else {
    fix.covariance << C[0], C[1], C[3], C[4];
  }
  return fix;
}

Measurement to_measurement(const geometry_msgs::msg::PoseWithCovarianceStamped& message, int source) {
  const Time time = from_stamp(message.header().stamp());
  const Eigen::Matrix3d C = planar_covariance(message.pose().covariance());
  const Pose2 X_MB = from_pose(message.pose().pose());
  if (C(2, 2) > kYawUnknown)
    return PositionFix{time, source, X_MB.position(), C.topLeftCorner<2, 2>(), {0.0, 0.0}};
  return PoseReading{time, source, X_MB, C};
}

RangeReading to_range(const bandwagon_msgs::msg::AnchorRange& message, int source) {
  RangeReading reading;
  reading.time = from_stamp(message.header().stamp());
  reading.source = source;
  reading.range = message.range();
  reading.variance = message.variance();
  reading.anchor = {message.anchor().x(), message.anchor().y()};
  return reading;
}

}  // namespace bw::localization
