#include "components/recordings/adaptor/recording_messages.hpp"

#include <limits>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kNotMeasured = -1.0;

}  // namespace

sensor_msgs::msg::Imu to_message(const ImuSample& sample, const std::string& frame, Time stamp,
                                 double faster) {
  sensor_msgs::msg::Imu message;
  message.header(make_header(frame, stamp));
  message.orientation(to_quaternion(sample.heading.value_or(0.0)));
  if (sample.heading) {
    message.orientation_covariance()[8] = sample.heading_variance;
  } else {
    message.orientation_covariance()[0] = kNotMeasured;
  }
  message.angular_velocity().z(sample.turn_rate.value_or(0.0) * faster);
  if (!sample.turn_rate) message.angular_velocity_covariance()[0] = kNotMeasured;
  message.linear_acceleration_covariance()[0] = kNotMeasured;
  return message;
}

sensor_msgs::msg::NavSatFix to_message(const FixSample& sample, const std::string& frame, Time stamp) {
  sensor_msgs::msg::NavSatFix message;
  message.header(make_header(frame, stamp));
  message.status().status(sensor_msgs::msg::NavSatStatus_Constants::STATUS_FIX);
  message.status().service(sensor_msgs::msg::NavSatStatus_Constants::SERVICE_GPS);
  message.latitude(sample.place.latitude);
  message.longitude(sample.place.longitude);
  message.altitude(sample.place.altitude);
  for (int i = 0; i < 3; ++i)
    message.position_covariance()[static_cast<std::size_t>(4 * i)] = sample.variance(i);
  message.position_covariance_type(sensor_msgs::msg::NavSatFix_Constants::COVARIANCE_TYPE_DIAGONAL_KNOWN);
  return message;
}

bandwagon_msgs::msg::AnchorRange to_message(const RangeSample& sample, const std::string& frame, Time stamp) {
  bandwagon_msgs::msg::AnchorRange message;
  message.header(make_header(frame, stamp));
  message.anchor(to_point(sample.anchor));
  message.range(sample.range);
  message.variance(sample.variance);
  return message;
}

sensor_msgs::msg::LaserScan to_message(const ScanSample& sample, const ScanGeometry& geometry,
                                       const std::string& frame, Time stamp) {
  const auto last_beam = static_cast<double>(sample.ranges.size()) - 1.0;
  sensor_msgs::msg::LaserScan message;
  message.header(make_header(frame, stamp));
  message.angle_min(static_cast<float>(geometry.angle_min));
  message.angle_max(static_cast<float>(geometry.angle_min + last_beam * geometry.angle_increment));
  message.angle_increment(static_cast<float>(geometry.angle_increment));
  message.scan_time(static_cast<float>(geometry.period));
  message.range_min(static_cast<float>(geometry.range_min));
  message.range_max(static_cast<float>(geometry.range_max));
  message.ranges(sample.ranges);
  return message;
}

bandwagon_msgs::msg::GroundTruth to_message(const ReferencePose& reference, const Twist2& twist,
                                            const std::string& frame, Time stamp) {
  bandwagon_msgs::msg::GroundTruth message;
  message.header(make_header(frame, stamp));
  message.pose().position(to_point(reference.position));
  if (reference.heading) {
    message.pose().orientation(to_quaternion(*reference.heading));
    message.twist(to_twist_message(twist));
  } else {
    message.pose().orientation().w(0.0);
    message.twist(to_twist_message({kUnknown, kUnknown}));
  }
  message.wall_clearance(std::numeric_limits<double>::infinity());
  return message;
}

}  // namespace bw
