// How a drive went in which processes failed, injection by injection: from what a recording tells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/lab/battery/injection_plan.hpp"

namespace bw {

/// Of a recording, in seconds of one clock.
struct InjectedDrive {
  struct Speed {
    double t = 0.0, v = 0.0;  ///< [m/s]
  };
  struct Begun {
    double t = 0.0;
    Injection injection;
  };
  std::vector<Speed> truth;      ///< forward, of the true robot
  std::vector<Speed> told;       ///< of the wheels, as the base tells them to drive
  std::vector<Begun> begun;      ///< as /faults told it
  std::vector<double> poses;     ///< when the localization said where the robot is
  std::vector<double> commands;  ///< when somebody upstream of the base's process commanded
  bool reached = false;          ///< the goal, in the end; false too where the recording does not tell
  int caused_contacts = 0;       ///< that the robot caused
};

struct JudgedInjection {
  Injection injection;
  double speed = 0.0;  ///< [m/s] of the robot then
  /// [s] from the last command to the first slower one to the wheels; nothing where it was not gone for long, or stood
  std::optional<double> stop_frame;
  std::optional<double> standing;  ///< [s] from the injection until the robot stood
  std::optional<double> allowed;   ///< [s] for that; nothing: it is not asked
  std::optional<double> again;     ///< [s] from the injection until it drove on
  std::string trouble;             ///< empty: as it should be
};

struct InjectionRules {
  double deceleration = 1.0;  ///< [m/s^2] in normal braking
  double command_age = 0.25;  ///< [s] to the stop frame, where a commander is lost
  double pose_age = 0.7;      ///< [s] likewise where the pose is: half a second of age, and two cycles
  double margin = 0.1;        ///< [s] beside the stopping distance
};

/// Whose loss shows in what: of the commander in commands, of the base in what the wheels are told, of others in poses.
struct InjectedProcesses {
  std::string commander, base;
};

/// What of `drive` belongs to each injection: until the next one, or the end.
std::vector<JudgedInjection> judge(const InjectedDrive& drive, const InjectedProcesses& processes,
                                   const InjectionRules& rules = {});

}  // namespace bw
