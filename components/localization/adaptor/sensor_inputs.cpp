#include "components/localization/adaptor/sensor_inputs.hpp"

#include <vector>

#include "components/messages/laser.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/sweep_motion.hpp"

namespace bw::localization {

void SensorInputs::configure(Setup& setup, const LocalizationParameters& parameters) {
  sensors_ = parameters.sensors;
  uses_laser_ = sensors_.laser && parameters.algorithm == Algorithm::particle_filter;
  wheels_ = names_.add("wheels");
  gyro_ = names_.add("gyro");
  compass_ = names_.add("compass");
  gps_ = names_.add("gps");
  course_ = names_.add("course");
  laser_ = names_.add("laser");
  ranges_ = names_.add("ranges");
  pose_ = names_.add("pose");
  course_from_fixes_.emplace(course_, CourseLimits{});
  const DatumParameters& datum = parameters.datum;
  if (datum.enabled) plane_ = LocalPlane::around({datum.latitude, datum.longitude, datum.altitude});
  map_frame_ = setup.frame("map");
  mounts_ = {setup, setup.transforms()};
  log_ = setup.log();
}

template <class Message, class Use>
void SensorInputs::listen_to(Setup& setup, const char* topic, const Qos& qos, Use use) {
  setup.input<Message>(topic, qos, use, Need::optional);
}

void SensorInputs::listen(Setup& setup, Localizer& filter) {
  using geometry_msgs::msg::PoseWithCovarianceStamped;
  filter_ = &filter;
  if (sensors_.gyro || sensors_.compass)
    listen_to<sensor_msgs::msg::Imu>(setup, "imu", Qos::sensor(),
                                     [this](const auto& m, const Tick& tick) { on_imu(m, tick); });
  if (sensors_.gps)
    listen_to<sensor_msgs::msg::NavSatFix>(setup, "gps/fix", Qos::sensor(),
                                           [this](const auto& m, const Tick& tick) { on_fix(m, tick); });
  if (sensors_.poses)
    listen_to<PoseWithCovarianceStamped>(setup, "pose", Qos::standard(),
                                         [this](const auto& m, const Tick& tick) {
                                           if (m.header().frame_id() == map_frame_)
                                             filter_->add(to_measurement(m, pose_), tick.now);
                                         });
  if (sensors_.ranges)
    listen_to<bandwagon_msgs::msg::AnchorRange>(setup, "ranges", Qos::sensor(),
                                                [this](const auto& m, const Tick& tick) {
                                                  if (m.header().frame_id() == map_frame_)
                                                    filter_->add(to_range(m, ranges_), tick.now);
                                                });
  if (uses_laser_)
    listen_to<sensor_msgs::msg::LaserScan>(setup, "scan", Qos::sensor(),
                                           [this](const auto& m, const Tick& tick) { on_scan(m, tick); });
}

void SensorInputs::on_scan(const sensor_msgs::msg::LaserScan& message, const Tick& tick) {
  const Pose2 X_BL = mounts_.of(message.header().frame_id());
  LaserReading reading{to_sweep(message, X_BL), laser_};
  // In base_link of the sweep's time, by the twist of now: it changes little in half a sweep.
  const std::vector<Pose2> poses = beam_poses(reading, X_BL, [&](Time time) {
    return advance_exact({}, twist_, (time - reading.time).to_seconds());
  });
  reading.beam_poses = poses;
  filter_->add(reading, tick.now);
}

void SensorInputs::on_imu(const sensor_msgs::msg::Imu& message, const Tick& tick) {
  if (sensors_.gyro) {
    if (const auto gyro = to_gyro(message, gyro_, sensors_.gyro_noise)) filter_->add(*gyro, tick.now);
  }
  if (!sensors_.compass) return;
  const Pose2 X_BS = mounts_.of(message.header().frame_id());
  if (const auto heading = to_heading(message, compass_, X_BS, sensors_.compass_noise))
    filter_->add(*heading, tick.now);
}

void SensorInputs::on_fix(const sensor_msgs::msg::NavSatFix& message, const Tick& tick) {
  const std::optional<Geodetic> geodetic = to_geodetic(message, plane_ ? plane_->datum().altitude : 0.0);
  if (!geodetic) return;
  if (!plane_) {
    plane_ = LocalPlane::around(*geodetic);
    log_.info("the origin of map is the first fix: {:.7f} N, {:.7f} E", geodetic->latitude,
              geodetic->longitude);
  }
  const Pose2 X_BS = mounts_.of(message.header().frame_id());
  const PositionFix fix = to_fix(message, gps_, *geodetic, *plane_, X_BS, sensors_.gps_noise);
  filter_->add(fix, tick.now);
  if (!sensors_.course) return;
  if (const auto course = course_from_fixes_->add(fix)) filter_->add(*course, tick.now);
}

}  // namespace bw::localization
