// The robot as every component sees it: geometry, encoders, limits. Section `robot:` of a graph, or a file in
// config/robots/.
#pragma once

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "components/model/differential_drive.hpp"
#include "components/model/footprint_field.hpp"
#include "components/model/limits.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Where a sensor sits on the robot.
struct SensorMount {
  std::string frame;
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
  double delay = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("frame", frame, {.doc = "frame of the sensor's messages"});
    v("x", x, {.unit = "m", .min = -10, .max = 10, .doc = "place on base_link, forward"});
    v("y", y, {.unit = "m", .min = -10, .max = 10, .doc = "place on base_link, left"});
    v("theta", theta, {.unit = "rad", .min = -6.3, .max = 6.3, .doc = "heading on base_link"});
    v("delay", delay,
      {.unit = "s",
       .min = 0,
       .max = 1,
       .doc =
           "of a sensor that another host stamps: how old its messages are at the least when they come; the stamps of "
           "another clock do not tell"});
  }
};

/// Which driver speaks to a device of the robot. What else stands in its section is that driver's.
struct DeviceChoice {
  static constexpr bool leaves_other_keys = true;
  std::string driver;

  template <class Visitor>
  void fields(Visitor& v) {
    v("driver", driver, {.doc = "what speaks to it; its parameters stand beside this"});
  }
};

struct Robot {
  std::string name = "generic";
  double wheel_radius = 0.0762;              ///< mean of both wheels [m]
  double wheel_radius_ratio = 1.0;           ///< right over left: E_d of Borenstein and Feng (1996)
  double wheel_separation = 0.39;            ///< distance b between the wheels [m]
  std::int64_t ticks_per_revolution = 2578;  ///< encoder counts per wheel revolution
  double wheel_speed_max = 2.0;              ///< top ground speed of one wheel [m/s]
  double radius = 0.3;    ///< footprint: disc around base_link [m], unless there is a polygon
  std::string footprint;  ///< polygon as text; read it by outline()
  Limits limits;
  std::vector<SensorMount> sensors;  ///< one that is not listed sits at base_link
  DeviceChoice base{.driver = "simulated"};
  DeviceChoice laser{.driver = "none"};  ///< none: its scans come from another program, or from the world

  bool has_mount_of(const std::string& frame) const {
    return std::ranges::any_of(sensors, [&](const SensorMount& mount) { return mount.frame == frame; });
  }
  WheelRadii wheel_radii() const {
    const double left = wheel_radius * (2.0 / (1.0 + wheel_radius_ratio));
    return {left, left * wheel_radius_ratio};
  }
  /// How far a wheel rolls from one encoder count to the next [m].
  double metres_per_tick(double rolling_radius) const {
    return 2.0 * std::numbers::pi * rolling_radius / static_cast<double>(ticks_per_revolution);
  }
  /// X_BS: pose of the sensor in base_link.
  Pose2 mount_of(const std::string& frame) const {
    for (const SensorMount& mount : sensors) {
      if (mount.frame == frame) return {mount.x, mount.y, mount.theta};
    }
    return {};
  }

  Duration delay_of(const std::string& frame) const {
    for (const SensorMount& mount : sensors) {
      if (mount.frame == frame) return Duration::seconds(mount.delay);
    }
    return {};
  }

  /// Its footprint while nothing else is said.
  Footprint outline() const {
    FootprintResult polygon = footprint_of(footprint, radius);
    return polygon.fault.empty() ? std::move(polygon.footprint) : Footprint{radius, {}};
  }

  /// From the top speeds as gently as they are commanded, and a little more until it hears of it: while it
  /// brakes, a run goes on.
  Duration time_to_rest() const {
    constexpr double kHears = 0.3;  // [s]: the oldest command that motor control obeys, and two cycles
    const double v = std::max(limits.v_max, limits.v_back_max);
    const double straight = v / limits.acc_max + limits.acc_max / limits.jerk_max;
    return Duration::seconds(kHears + std::max(straight, limits.omega_max / limits.alpha_max));
  }

  template <class Visitor>
  void fields(Visitor& v) {
    v("name", name, {.doc = "name shown in reports"});
    v("wheel_radius", wheel_radius,
      {.unit = "m", .min = 0.005, .max = 1, .doc = "radius (not diameter) of a driven wheel, mean of both"});
    v("wheel_radius_ratio", wheel_radius_ratio,
      {.min = 0.8,
       .max = 1.25,
       .doc = "radius of the right wheel over that of the left one; calibrate measures it"});
    v("wheel_separation", wheel_separation,
      {.unit = "m", .min = 0.02, .max = 5, .doc = "distance between the driven wheels"});
    v("ticks_per_revolution", ticks_per_revolution,
      {.min = 4, .max = 10'000'000, .doc = "encoder counts per wheel turn"});
    v("wheel_speed_max", wheel_speed_max,
      {.unit = "m/s",
       .min = 0.01,
       .max = 20,
       .doc = "top ground speed of one wheel; bounds v and omega together"});
    v("radius", radius,
      {.unit = "m",
       .min = 0.02,
       .max = 5,
       .first = true,
       .doc = "radius of the robot's disc footprint; of no effect beside a footprint"});
    v("footprint", footprint,
      footprint_field("outline as corners in base_link, \"[[x, y], [x, y], [x, y]]\", convex and around "
                      "base_link; empty: the disc of radius"));
    v("limits", limits, {.doc = "motion limits of the base"});
    v("sensors", sensors, {.doc = "where the sensors sit; published on /tf_static"});
    v("base", base, {.doc = "wheels and what else the base has: its driver"});
    v("laser", laser, {.doc = "the laser: its driver"});
  }
};

}  // namespace bw
