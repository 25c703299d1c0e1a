// What a world is made of: section `world` of a graph. Frame: map; SI units.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/model/shape_options.hpp"
#include "components/world/drive_model.hpp"
#include "components/world/gps.hpp"
#include "components/world/imu.hpp"
#include "components/world/laser_scanner.hpp"
#include "components/world/legs.hpp"
#include "components/world/orca_walkers.hpp"
#include "components/world/replayed_people.hpp"
#include "components/world/scripted_people.hpp"
#include "components/world/social_walkers.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct StartOptions {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("theta", theta, {.unit = "rad", .min = -6.3, .max = 6.3, .doc = "heading in map"});
  }
};

/// One of several robots. All are of the kind that section `robot` describes.
struct WorldRobotOptions {
  std::string name;
  StartOptions start;

  template <class Visitor>
  void fields(Visitor& v) {
    v("name", name, {.doc = "its topics and frames go below it: robot1/scan, robot1/laser"});
    v("start", start, {.doc = "pose at the start"});
  }
};

struct PeopleOptions {
  std::vector<ScriptedPersonOptions> scripted;
  SocialWalkersOptions social;
  OrcaWalkersOptions orca;
  ReplayOptions replay;
  LegOptions legs;

  template <class Visitor>
  void fields(Visitor& v) {
    v("scripted", scripted, {.doc = "people who follow waypoints or stand"});
    v("social", social, {.doc = "people who walk by the social force model"});
    v("orca", orca, {.doc = "people who walk by ORCA"});
    v("replay", replay, {.doc = "recorded people"});
    v.retired({"legs"}, "a constant of world_options.hpp");
  }
};

struct WorldOptions {
  /// added to the seed of the run (set by code alone)
  std::int64_t seed_offset = 0;
  /// [s] one step of the world: a tenth of the usual period of a scan
  static constexpr double kPhysicsStep = 0.01;
  double encoder_rate = 50.0;
  double truth_rate = 50.0;
  StartOptions start;
  std::vector<WorldRobotOptions> robots;
  std::string map;
  std::string tracks;
  std::string track_walls;
  std::string track_circles;
  std::vector<WallOptions> walls;
  std::vector<BoxOptions> boxes;
  bool people_react = true;
  PeopleOptions people;
  DriveOptions drive;
  LaserOptions laser;
  std::vector<MoreLaserOptions> more_lasers;
  ImuOptions imu;
  GpsOptions gps;

  template <class Visitor>
  void fields(Visitor& v) {
    v("encoder_rate", encoder_rate,
      {.unit = "Hz", .min = 0.1, .max = 1000, .doc = "encoder readings per second"});
    v("truth_rate", truth_rate,
      {.unit = "Hz", .min = 0.1, .max = 1000, .doc = "ground truth messages per second"});
    v("start", start, {.doc = "pose of the robot at the start"});
    v("robots", robots,
      {.doc = "several robots, named as in the graph; none: one without a name, at `start`"});
    v("map", map, {.first = true, .doc = "map file (YAML beside a PGM or PNG); empty: none"});
    v("tracks", tracks,
      {.doc = "file of recorded people (CSV t_s,frame,ped_id,x_m,y_m,vx_mps,vy_mps); empty: none"});
    v("track_walls", track_walls,
      {.doc = "file of the recording's walls (CSV x1_m,y1_m,x2_m,y2_m); empty: none"});
    v("track_circles", track_circles,
      {.doc = "file of the recording's trees and pillars (CSV x_m,y_m,r_m); empty: none"});
    v("walls", walls, {.doc = "thin walls"});
    v("boxes", boxes, {.doc = "boxes that stand about"});
    v("people_react", people_react,
      {.first = true,
       .doc = "walkers see the robots and keep clear of them; claims on safety only with false"});
    v("people", people, {.doc = "who walks where"});
    v("drive", drive, {.doc = "wheels and encoders"});
    v("laser", laser, {.doc = "laser scanner"});
    v("more_lasers", more_lasers,
      {.doc = "further laser scanners of each robot, such as one that looks back"});
    v("imu", imu, {.doc = "gyro and compass"});
    v("gps", gps, {.doc = "satellite receiver"});
    v.retired({"physics_step"}, "a constant of world_options.hpp");
  }

  std::optional<std::string> violated_rule() const {
    for (const double rate : {encoder_rate, truth_rate, laser.rate, imu.rate, gps.rate}) {
      if (rate * kPhysicsStep > 1.0 + 1e-9) return "no rate may exceed 100 Hz, one per step of the world";
    }
    for (const MoreLaserOptions& one : more_lasers) {
      if (one.rate * kPhysicsStep > 1.0 + 1e-9) return "no rate may exceed 100 Hz, one per step of the world";
      const auto is_same = [&](const MoreLaserOptions& other) { return other.topic == one.topic; };
      if (one.topic.empty() || one.topic == "scan" || std::ranges::count_if(more_lasers, is_same) > 1)
        return "each of more_lasers must have a topic of its own";
    }
    return std::nullopt;
  }
};

/// The inline walls, and the outlines of the boxes.
std::vector<Segment> wall_segments(const WorldOptions& options);

}  // namespace bw
