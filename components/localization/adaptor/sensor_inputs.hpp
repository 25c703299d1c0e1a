// What the filter listens to beside the wheels: each sensor under a name of its own, from its topic to
// measurements.
#pragma once

#include <optional>
#include <string>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/localization/adaptor/sensor_messages.hpp"
#include "components/localization/course_from_fixes.hpp"
#include "components/localization/localization_parameters.hpp"
#include "components/localization/localizer.hpp"
#include "components/localization/source_names.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/sensor_mounts.hpp"

namespace bw::localization {

class SensorInputs {
 public:
  /// Names the sources in the order in which the diagnostics list them.
  void configure(Setup& setup, const LocalizationParameters& parameters);
  /// Subscribes to those that the parameters ask for. `filter` has room for names().count() sources and
  /// outlives this.
  void listen(Setup& setup, Localizer& filter);

  /// How noisy sensors are that do not say so themselves.
  void set_noise(const SensorParameters& sensors) { sensors_ = sensors; }

  /// How the robot moves now, by its wheels.
  void set_twist(const Twist2& twist) { twist_ = is_finite(twist) ? twist : Twist2{}; }

  const SourceNames& names() const { return names_; }
  int wheels() const { return wheels_; }

 private:
  void on_imu(const sensor_msgs::msg::Imu& message, const Tick& tick);
  void on_scan(const sensor_msgs::msg::LaserScan& message, const Tick& tick);
  void on_fix(const sensor_msgs::msg::NavSatFix& message, const Tick& tick);
  template <class Message, class Use>
  void listen_to(Setup& setup, const char* topic, const Qos& qos, Use use);

  SourceNames names_;
  int wheels_ = 0, gyro_ = 0, compass_ = 0, gps_ = 0, course_ = 0, laser_ = 0, ranges_ = 0, pose_ = 0;
  SensorParameters sensors_;
  bool uses_laser_ = false;
  Twist2 twist_;
  Localizer* filter_ = nullptr;
  std::optional<LocalPlane> plane_;
  std::optional<CourseFromFixes> course_from_fixes_;
  std::string map_frame_;
  SensorMounts mounts_;
  Logger log_;
};

}  // namespace bw::localization
