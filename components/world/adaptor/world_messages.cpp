#include "components/world/adaptor/world_messages.hpp"

#include <limits>
#include <utility>
#include <vector>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

constexpr double kWallReach = 5.0;  // [m]

}  // namespace

void to_message(const LaserScan& scan, const LaserOptions& options, Time stamp,
                sensor_msgs::msg::LaserScan& message) {
  const auto last_beam = static_cast<double>(scan.ranges.size() - 1);
  message.header().stamp(to_stamp(stamp));
  message.angle_min(static_cast<float>(scan.angle_min));
  message.angle_max(static_cast<float>(scan.angle_min + last_beam * scan.angle_increment));
  message.angle_increment(static_cast<float>(scan.angle_increment));
  message.scan_time(static_cast<float>(1.0 / options.rate));
  message.range_min(static_cast<float>(options.range_min));
  message.range_max(static_cast<float>(options.range_max));
  message.ranges(scan.ranges);
}

sensor_msgs::msg::Imu to_message(const ImuReading& reading, const ImuOptions& options, Time stamp) {
  sensor_msgs::msg::Imu message;
  message.header().stamp(to_stamp(stamp));
  message.orientation(to_quaternion(reading.heading));
  message.orientation_covariance()[8] = options.heading_noise * options.heading_noise;
  message.angular_velocity().z(reading.turn_rate);
  message.angular_velocity_covariance()[8] = options.gyro_noise * options.gyro_noise;
  message.linear_acceleration_covariance()[0] = -1.0;
  return message;
}

sensor_msgs::msg::NavSatFix to_message(const GpsFix& fix, const GpsOptions& options, Time world_start) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  sensor_msgs::msg::NavSatFix message;
  message.header().stamp(to_stamp(world_start + fix.measured_at));
  message.status().status(fix.valid ? sensor_msgs::msg::NavSatStatus_Constants::STATUS_FIX
                                    : sensor_msgs::msg::NavSatStatus_Constants::STATUS_NO_FIX);
  message.status().service(sensor_msgs::msg::NavSatStatus_Constants::SERVICE_GPS);
  message.latitude(fix.valid ? fix.latitude : kUnknown);
  message.longitude(fix.valid ? fix.longitude : kUnknown);
  message.altitude(kUnknown);
  if (fix.valid) {
    message.position_covariance()[0] = options.noise * options.noise;
    message.position_covariance()[4] = options.noise * options.noise;
    message.position_covariance_type(sensor_msgs::msg::NavSatFix_Constants::COVARIANCE_TYPE_APPROXIMATED);
  }
  return message;
}

bandwagon_msgs::msg::WheelTicks to_message(const EncoderTicks& ticks, Time stamp) {
  bandwagon_msgs::msg::WheelTicks message;
  message.header().stamp(to_stamp(stamp));
  message.left(ticks.left);
  message.right(ticks.right);
  return message;
}

bandwagon_msgs::msg::GroundTruth ground_truth(const World& world, std::size_t robot, Time stamp) {
  bandwagon_msgs::msg::GroundTruth message;
  message.header().stamp(to_stamp(stamp));
  message.pose().position().x(world.pose(robot).x);
  message.pose().position().y(world.pose(robot).y);
  message.pose().orientation(to_quaternion(world.pose(robot).theta));
  message.twist().linear().x(world.twist(robot).v);
  message.twist().angular().z(world.twist(robot).omega);
  std::vector<bandwagon_msgs::msg::GroundTruthPerson> people;
  for (const Person& person : world.others(robot)) {
    bandwagon_msgs::msg::GroundTruthPerson entry;
    entry.id(person.id);
    entry.position().x(person.position.x());
    entry.position().y(person.position.y());
    entry.velocity().x(person.velocity.x());
    entry.velocity().y(person.velocity.y());
    entry.radius(person.radius);
    people.push_back(entry);
  }
  message.people(std::move(people));
  const double gap = world.wall_gap(kWallReach, robot);
  message.wall_clearance(gap < kWallReach ? gap : std::numeric_limits<double>::infinity());
  message.contacts(static_cast<std::uint32_t>(world.contacts(robot).contacts().size()));
  return message;
}

}  // namespace bw
