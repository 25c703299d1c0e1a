// Weights and conditions of the critics that Nav2 ships (theory.md 5.8).
#pragma once

#include "runtime/base/field.hpp"

namespace bw::mppi {

/// What all critics have; a parameter of those that say how the plan is followed and what is kept clear of.
template <class Visitor>
void weight_field(Visitor& v, double& weight) {
  v("cost_weight", weight,
    {.min = 0, .max = 1e4, .doc = "raise it to give this critic more of a say; 0 switches it off"});
}

struct ConstraintOptions {
  double cost_weight = 4.0;  ///< set by code alone
};

struct CostOptions {
  static constexpr double kCriticalCost = 300.0;  ///< of a pose whose cell costs near_collision_cost or more
  static constexpr double kCollisionCost = 1e6;   ///< of a motion that touches something
  static constexpr double kNearGoal = 1.0;        ///< nearer to the goal only contacts cost [m]
  static constexpr int kPointStep = 2;            ///< every how many-th pose is looked at
  double cost_weight = 3.81;
  double near_collision_cost = 253.0;  ///< contact; lower punishes being near as well

  void fields(auto& v) { weight_field(v, cost_weight); }
};

struct GoalOptions {
  static constexpr double kWithin = 1.4;  ///< on when the goal is nearer than this [m]
  double cost_weight = 5.0;               ///< set by code alone
};

struct GoalAngleOptions {
  static constexpr double kWithin = 0.5;  ///< on when the goal is nearer than this [m]
  double cost_weight = 3.0;               ///< set by code alone
};

struct PathAlignOptions {
  static constexpr double kMaxTaken = 0.05;  ///< off when a larger share of the plan's points is taken
  static constexpr int kPointStep = 4;       ///< every how many-th pose is looked at
  static constexpr double kBeyond = 0.5;     ///< off when the goal is nearer than this [m]
  static constexpr int kFromPoint =
      20;  ///< off until a sample comes so many points of the plan far, 0.05 m each
  double cost_weight = 14.0;

  void fields(auto& v) { weight_field(v, cost_weight); }
};

struct PathFollowOptions {
  static constexpr double kBeyond = 1.4;  ///< off when the goal is nearer than this [m]
  static constexpr int kAhead = 5;        ///< points of the plan beyond the furthest that a sample reaches
  double cost_weight = 5.0;

  void fields(auto& v) { weight_field(v, cost_weight); }
};

struct PathAngleOptions {
  static constexpr double kBeyond = 0.5;  ///< off when the goal is nearer than this [m]
  static constexpr int kAhead = 4;        ///< points of the plan beyond the furthest that a sample reaches
  static constexpr double kOffHeading = 1.0;  ///< on when that point is further off the heading [rad]
  double cost_weight = 2.0;                   ///< set by code alone
};

struct PreferForwardOptions {
  static constexpr double kBeyond = 0.5;  ///< off when the goal is nearer than this [m]
  double cost_weight = 5.0;               ///< set by code alone
};

}  // namespace bw::mppi
