#include "components/recordings/adaptor/recording_messages.hpp"

#include <algorithm>
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
  message.latitude(sample.position.latitude);
  message.longitude(sample.position.longitude);
  message.altitude(sample.position.altitude);
  for (int i = 0; i < 3; ++i)
    message.position_covariance()[static_cast<std::size_t>(4 * i)] = sample.variance(i);
  namespace type = sensor_msgs::msg::NavSatFix_Constants;
  message.position_covariance_type(sample.variance.isZero() ? type::COVARIANCE_TYPE_UNKNOWN
                                                            : type::COVARIANCE_TYPE_DIAGONAL_KNOWN);
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

sensor_msgs::msg::LaserScan to_message(const ScanSample& sample, const std::string& frame, Time stamp) {
  sensor_msgs::msg::LaserScan message;
  message.header(make_header(frame, stamp));
  message.angle_min(sample.geometry.angle_min);
  message.angle_max(sample.geometry.angle_max);
  message.angle_increment(sample.geometry.angle_increment);
  message.time_increment(sample.geometry.time_increment);
  message.scan_time(sample.geometry.period);
  message.range_min(sample.geometry.range_min);
  message.range_max(sample.geometry.range_max);
  message.ranges(sample.ranges);
  message.intensities(sample.intensities);
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

void drop_what_others_tell(const Robot& robot, std::vector<FrameMount>& mounts) {
  std::erase_if(mounts, [&robot](const FrameMount& mount) {
    const bool is_sensor =
        std::ranges::find(robot.sensors, mount.child, &SensorMount::frame) != robot.sensors.end();
    return is_sensor || mount.child == "base_link" || mount.child == "odom";
  });
}

tf2_msgs::msg::TFMessage to_message(const std::vector<FrameMount>& mounts, const Renamed& renamed,
                                    Time stamp) {
  tf2_msgs::msg::TFMessage message;
  for (const FrameMount& mount : mounts) {
    geometry_msgs::msg::TransformStamped& transform = message.transforms().emplace_back();
    transform.header(make_header(renamed(mount.parent), stamp));
    transform.child_frame_id(renamed(mount.child));
    auto& translation = transform.transform().translation();
    translation.x(mount.translation.x());
    translation.y(mount.translation.y());
    translation.z(mount.translation.z());
    auto& rotation = transform.transform().rotation();
    rotation.x(mount.rotation(0));
    rotation.y(mount.rotation(1));
    rotation.z(mount.rotation(2));
    rotation.w(mount.rotation(3));
  }
  return message;
}

}  // namespace bw
