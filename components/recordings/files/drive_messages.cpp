#include "components/recordings/files/drive_messages.hpp"

#include <cmath>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

constexpr double kNotMeasured = -1.0;  // first element of a covariance, by sensor_msgs/Imu

}  // namespace

std::optional<OdometrySample> to_sample(const nav_msgs::msg::Odometry& message, Time time) {
  const OdometrySample sample{time, from_pose(message.pose().pose()), from_twist(message.twist().twist())};
  if (!is_finite(sample.X_OB) || !is_finite(sample.twist)) return std::nullopt;
  return sample;
}

std::optional<ImuSample> to_sample(const sensor_msgs::msg::Imu& message, Time time) {
  ImuSample sample{.time = time};
  const double heading = yaw_of(message.orientation());
  if (message.orientation_covariance()[0] != kNotMeasured && std::isfinite(heading)) {
    sample.heading = heading;
    sample.heading_variance = message.orientation_covariance()[8];
  }
  const double turn_rate = message.angular_velocity().z();
  if (message.angular_velocity_covariance()[0] != kNotMeasured && std::isfinite(turn_rate))
    sample.turn_rate = turn_rate;
  if (!sample.heading && !sample.turn_rate) return std::nullopt;
  return sample;
}

std::optional<FixSample> to_sample(const sensor_msgs::msg::NavSatFix& message, Time time) {
  if (message.status().status() < sensor_msgs::msg::NavSatStatus_Constants::STATUS_FIX) return std::nullopt;
  FixSample sample{.time = time, .position = {message.latitude(), message.longitude(), message.altitude()}};
  if (!std::isfinite(sample.position.altitude)) sample.position.altitude = 0.0;
  if (!localization::is_plausible(sample.position)) return std::nullopt;
  const auto& C = message.position_covariance();
  const bool is_declared =
      message.position_covariance_type() != sensor_msgs::msg::NavSatFix_Constants::COVARIANCE_TYPE_UNKNOWN;
  if (is_declared && C[0] > 0.0 && C[4] > 0.0) sample.variance = {C[0], C[4], C[8]};
  return sample;
}

std::optional<RangeSample> to_sample(const bandwagon_msgs::msg::AnchorRange& message, Time time) {
  const RangeSample sample{
      time, {message.anchor().x(), message.anchor().y()}, message.range(), message.variance()};
  if (!sample.anchor.allFinite() || !std::isfinite(sample.range) || !(sample.variance > 0.0))
    return std::nullopt;
  return sample;
}

std::optional<ScanSample> to_sample(const sensor_msgs::msg::LaserScan& message, Time time) {
  return ScanSample{.time = time,
                    .frame = message.header().frame_id(),
                    .geometry = {.angle_min = message.angle_min(),
                                 .angle_max = message.angle_max(),
                                 .angle_increment = message.angle_increment(),
                                 .time_increment = message.time_increment(),
                                 .period = message.scan_time(),
                                 .range_min = message.range_min(),
                                 .range_max = message.range_max()},
                    .ranges = message.ranges(),
                    .intensities = message.intensities()};
}

std::optional<ReferencePose> to_reference(const geometry_msgs::msg::Pose& pose, Time time) {
  const Pose2 X_MB = from_pose(pose);
  if (!X_MB.position().allFinite()) return std::nullopt;
  ReferencePose reference{time, X_MB.position(), std::nullopt};
  if (std::isfinite(X_MB.theta)) reference.heading = X_MB.theta;
  return reference;
}

std::vector<FrameMount> to_mounts(const tf2_msgs::msg::TFMessage& message) {
  std::vector<FrameMount> mounts;
  for (const auto& stamped : message.transforms()) {
    const auto& t = stamped.transform().translation();
    const auto& q = stamped.transform().rotation();
    mounts.push_back({stamped.header().frame_id(),
                      stamped.child_frame_id(),
                      {t.x(), t.y(), t.z()},
                      {q.x(), q.y(), q.z(), q.w()}});
  }
  return mounts;
}

}  // namespace bw
