// Parameters of the localization component: which filter, what it listens to, where it starts; then each
// filter's own.
#pragma once

#include <optional>
#include <string>

#include "components/localization/localizer_factory.hpp"
#include "components/model/local_plane.hpp"
#include "runtime/base/field.hpp"

namespace bw::localization {

struct DatumParameters {
  bool enabled = false;
  double latitude = 0.0;
  double longitude = 0.0;
  double altitude = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled, {.doc = "the origin of map is given here; otherwise it is the first fix"});
    v("latitude", latitude,
      {.unit = "deg", .min = -90, .max = 90, .doc = "latitude of the origin of map, WGS 84"});
    v("longitude", longitude,
      {.unit = "deg", .min = -180, .max = 180, .doc = "longitude of the origin of map, WGS 84"});
    v("altitude", altitude,
      {.unit = "m", .min = -1000, .max = 20000, .doc = "altitude of the origin of map above the ellipsoid"});
  }
};

/// What the filter listens to. Topics: README.md.
struct SensorParameters {
  double wheel_noise = 0.0;
  bool gyro = true;
  double gyro_noise = 0.01;
  bool compass = true;
  double compass_noise = 0.05;
  bool gps = true;
  double gps_noise = 1.0;
  bool course = false;
  bool laser = true;
  bool ranges = true;
  bool poses = true;

  template <class Visitor>
  void fields(Visitor& v) {
    v("wheel_noise", wheel_noise,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc =
           "k of model/README.md 2.2, variance of a wheel's travel per metre of it; 0: as the covariance of odom grows, "
           "5e-4 where it does not"});
    v("gyro", gyro, {.doc = "use the turn rate of imu"});
    v("gyro_noise", gyro_noise,
      {.unit = "rad/s",
       .min = 1e-6,
       .max = 1,
       .doc = "standard deviation of a turn rate where the message gives none"});
    v("compass", compass, {.doc = "use the orientation of imu as heading in map (0 is east)"});
    v("compass_noise", compass_noise,
      {.unit = "rad",
       .min = 1e-6,
       .max = 3.15,
       .doc = "standard deviation of a heading where the message gives none"});
    v("gps", gps, {.doc = "use gps/fix"});
    v("gps_noise", gps_noise,
      {.unit = "m",
       .min = 0.001,
       .max = 1000,
       .doc = "standard deviation of a fix, per axis, where the message gives none"});
    v("course", course, {.doc = "use the direction between two fixes as heading, without a compass"});
    v("laser", laser, {.doc = "use scan against map (particle filter)"});
    v("ranges", ranges, {.doc = "use ranges to anchors"});
    v("poses", poses,
      {.doc = "use pose: positions or poses in map from anything else, with their covariance"});
  }
};

/// A pose known at the start, as amcl's initial_pose.
struct InitialPoseParameters {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
  /// [m] standard deviation of the position per axis, also of a clicked pose that has none: amcl's, 0.25 m^2
  static constexpr double kPositionSigma = 0.5;
  /// [rad] standard deviation of the heading, likewise: amcl's, (pi/12)^2
  static constexpr double kYawSigma = 0.26;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("yaw", yaw, {.unit = "rad", .min = -3.1416, .max = 3.1416, .doc = "in map"});
    v.retired({"position_sigma", "yaw_sigma"}, "a constant of localization_parameters.hpp");
  }
};

struct LocalizationParameters {
  Algorithm algorithm = Algorithm::ekf;
  bool set_initial_pose = false;
  InitialPoseParameters initial_pose;
  bool start_anywhere = false;
  SensorParameters sensors;
  DatumParameters datum;
  double transform_tolerance = 0.0;
  /// [Hz] how many times a second amcl_pose, particles and health are published
  static constexpr double kPoseRate = 10.0;
  bool publish_when_lost = false;
  LocalizerOptions filters;

  template <class Visitor>
  void fields(Visitor& v) {
    v("algorithm", algorithm, {.first = true, .doc = "filter in use"});
    v("set_initial_pose", set_initial_pose,
      {.first = true, .doc = "start at initial_pose; otherwise find the first pose"});
    v("initial_pose", initial_pose, {.doc = "the pose at the start"});
    v("start_anywhere", start_anywhere,
      {.first = true, .doc = "search the whole map at the start (particle filter)"});
    v("sensors", sensors, {.doc = "what the filter listens to"});
    v("datum", datum, {.doc = "where map lies on the earth"});
    v("transform_tolerance", transform_tolerance,
      {.unit = "s",
       .min = 0,
       .max = 10,
       .doc = "map->odom is dated so far ahead, so that readers find it in time"});
    v("publish_when_lost", publish_when_lost,
      {.first = true,
       .doc = "go on with odometry/filtered while LOST; otherwise it stops, and with it the drive"});
    filters.fields(v);
    v.retired({"pose_rate"}, "a constant of localization_parameters.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (set_initial_pose && start_anywhere) return "set_initial_pose and start_anywhere exclude each other";
    if (start_anywhere && algorithm != Algorithm::particle_filter)
      return "start_anywhere needs algorithm: particle_filter";
    const Geodetic geodetic{datum.latitude, datum.longitude, datum.altitude};
    if (datum.enabled && !LocalPlane::around(geodetic)) return "datum must be a place on the earth";
    return std::nullopt;
  }
};

}  // namespace bw::localization
