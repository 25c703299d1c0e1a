// Parameters of the collision monitor. Names as in nav2_collision_monitor where it has the same thing.
#pragma once

#include <vector>

#include "components/model/stamped_choice.hpp"
#include "components/safety/sweep_options.hpp"
#include "components/safety/zone.hpp"
#include "runtime/base/field.hpp"

namespace bw::safety {

struct StoppingOptions {
  double margin = 0.1;
  double padding = 0.0;
  double reaction_time = 0.1;
  double approach_speed = 0.0;
  /// [m] what the robot's side would touch no deeper than this is passed at graze_speed, not stopped for; as
  /// large as the noise of the laser and of arcs that are not held exactly
  static constexpr double kGraze = 0.03;
  double graze_speed = 0.05;
  double narrow_margin = 0.2;
  /// [m/s] top speed within narrow_margin of narrow things
  static constexpr double kNarrowSpeed = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("margin", margin,
      {.unit = "m",
       .min = 0,
       .max = 2,
       .first = true,
       .doc = "distance left between the robot at rest and what stopped it"});
    v("padding", padding,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "added to the robot's radius, all round; raise it for what sticks out"});
    v("reaction_time", reaction_time,
      {.unit = "s",
       .min = 0,
       .max = 2,
       .doc =
           "time from a sweep to braking wheels (t of safety/theory.md 7.9); raise it by every latency on the way"});
    v("approach_speed", approach_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 3,
       .first = true,
       .doc =
           "speed at which what is ahead may come nearer meanwhile (u of safety/theory.md 7.9); 1.6 is a walking "
           "person (ISO 13855); 0: it stands"});
    v("graze_speed", graze_speed,
      {.unit = "m/s", .min = 0, .max = 1, .doc = "top speed past what the side would graze"});
    v("narrow_margin", narrow_margin,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc =
           "a body is this much wider than the legs a laser sees; around narrow things the robot is down to "
           "narrow_speed so far off; 0: nothing special"});
    v.retired({"graze", "narrow_speed"}, "a constant of collision_monitor_options.hpp");
  }
};

struct SightOptions {
  /// [rad] sector around the way of travel that must be seen
  static constexpr double kHalfAngle = 0.785;
  /// [rad] a wider run of unknown beams there could hide somebody: legs and hips 0.3 m wide, 1.5 m away
  static constexpr double kMaxGap = 0.2;
  /// share of unknown beams there beyond which the robot creeps
  static constexpr double kMaxUnknown = 0.3;
  double creep_speed = 0.1;
  /// share of unknown beams there beyond which the robot stops
  static constexpr double kStopUnknown = 0.9;

  template <class Visitor>
  void fields(Visitor& v) {
    v("creep_speed", creep_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 2,
       .doc = "top speed into what the laser does not see; 0: the robot does not go there"});
    v.retired({"half_angle", "max_gap", "max_unknown", "stop_unknown"},
              "a constant of collision_monitor_options.hpp");
  }
};

enum class Resume { automatic, manual };
constexpr auto choice_table(Resume) {
  return choices<Resume>({{Resume::automatic, "automatic"}, {Resume::manual, "manual"}});
}

struct CollisionMonitorOptions {
  double source_timeout = 0.25;
  double command_timeout = 0.2;
  /// [s] a limit or a stop is eased so long after its cause: four sweeps of a laser at 10 Hz
  static constexpr double kClearAfter = 0.4;
  Resume resume = Resume::automatic;
  StampedCmdVel enable_stamped_cmd_vel = StampedCmdVel::no;
  SweepOptions sweep;
  SightOptions sight;
  StoppingOptions stopping;
  std::vector<ZoneOptions> polygons;

  template <class Visitor>
  void fields(Visitor& v) {
    v("source_timeout", source_timeout,
      {.unit = "s",
       .min = 0.02,
       .max = 5,
       .doc = "longest time without a sound sweep; at least two and a half periods of the laser"});
    v("command_timeout", command_timeout,
      {.unit = "s", .min = 0.02, .max = 1, .doc = "oldest command that is passed on"});
    v("resume", resume,
      {.doc = "after a fault of the laser: by itself, or when collision_monitor/reset says so"});
    v("enable_stamped_cmd_vel", enable_stamped_cmd_vel,
      {.doc =
           "commands in and out are TwistStamped; auto: as Nav2 of the graph's ros_distro has it, true from Kilted on"});
    v("sweep", sweep, {.doc = "what makes a sweep usable"});
    v("sight", sight, {.doc = "where the robot drives it must see"});
    v("stopping", stopping, {.doc = "speed limited by the way that is free"});
    v("polygons", polygons, {.doc = "zones around the robot"});
    v.retired({"clear_after"}, "a constant of collision_monitor_options.hpp");
  }
};

}  // namespace bw::safety
