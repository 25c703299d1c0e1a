// Weights and conditions of the critics that Nav2 ships (book 5.8).
#pragma once

#include <cstdint>
#include <string_view>

#include "runtime/base/field.hpp"

namespace bw::mppi {

namespace detail {

template <class Visitor>
void weight_field(Visitor& v, double& weight) {
  v("cost_weight", weight, {.min = 0, .max = 1e4, .doc = "0 switches the critic off"});
}

template <class Visitor>
void threshold_field(Visitor& v, double& threshold, std::string_view doc) {
  v("threshold_to_consider", threshold, {.unit = "m", .min = 0, .max = 100, .doc = doc});
}

constexpr std::string_view kOffNearGoal = "off when the goal is nearer than this";
constexpr std::string_view kOnNearGoal = "on when the goal is nearer than this";

}  // namespace detail

struct ConstraintOptions {
  double cost_weight = 4.0;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
  }
};

struct CostOptions {
  double cost_weight = 3.81;
  double critical_cost = 300.0;
  double near_collision_cost = 253.0;
  double collision_cost = 1e6;
  double near_goal_distance = 1.0;
  std::int64_t trajectory_point_step = 2;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
    v("critical_cost", critical_cost,
      {.min = 0, .max = 1e9, .doc = "of a pose whose cell costs near_collision_cost or more"});
    v("near_collision_cost", near_collision_cost,
      {.min = 1, .max = 254, .doc = "253: contact; lower punishes being near as well"});
    v("collision_cost", collision_cost, {.min = 0, .max = 1e9, .doc = "of a motion that touches something"});
    v("near_goal_distance", near_goal_distance,
      {.unit = "m", .min = 0, .max = 100, .doc = "nearer to the goal only contacts cost"});
    v("trajectory_point_step", trajectory_point_step,
      {.min = 1, .max = 100, .doc = "every how many-th pose is looked at"});
  }
};

struct GoalOptions {
  double cost_weight = 5.0;
  double threshold_to_consider = 1.4;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
    detail::threshold_field(v, threshold_to_consider, detail::kOnNearGoal);
  }
};

struct GoalAngleOptions {
  double cost_weight = 3.0;
  double threshold_to_consider = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
    detail::threshold_field(v, threshold_to_consider, detail::kOnNearGoal);
  }
};

struct PathAlignOptions {
  double cost_weight = 14.0;
  double max_path_occupancy_ratio = 0.05;
  std::int64_t trajectory_point_step = 4;
  double threshold_to_consider = 0.5;
  std::int64_t offset_from_furthest = 20;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
    v("max_path_occupancy_ratio", max_path_occupancy_ratio,
      {.min = 0, .max = 1, .doc = "off when a larger share of the plan's points is taken"});
    v("trajectory_point_step", trajectory_point_step,
      {.min = 1, .max = 100, .doc = "every how many-th pose is looked at"});
    detail::threshold_field(v, threshold_to_consider, detail::kOffNearGoal);
    v("offset_from_furthest", offset_from_furthest,
      {.min = 0, .max = 1000, .doc = "off until a sample comes so many points of the plan far, 0.05 m each"});
  }
};

struct PathFollowOptions {
  double cost_weight = 5.0;
  double threshold_to_consider = 1.4;
  std::int64_t offset_from_furthest = 5;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
    detail::threshold_field(v, threshold_to_consider, detail::kOffNearGoal);
    v("offset_from_furthest", offset_from_furthest,
      {.min = 0,
       .max = 1000,
       .doc = "drawn to so many points of the plan, 0.05 m each, beyond the furthest that a sample reaches"});
  }
};

struct PathAngleOptions {
  double cost_weight = 2.0;
  double threshold_to_consider = 0.5;
  std::int64_t offset_from_furthest = 4;
  double max_angle_to_furthest = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
    detail::threshold_field(v, threshold_to_consider, detail::kOffNearGoal);
    v("offset_from_furthest", offset_from_furthest,
      {.min = 0,
       .max = 1000,
       .doc = "looks at so many points of the plan, 0.05 m each, beyond the furthest that a sample reaches"});
    v("max_angle_to_furthest", max_angle_to_furthest,
      {.unit = "rad", .min = 0, .max = 3.15, .doc = "on when that point is further off the heading"});
  }
};

struct PreferForwardOptions {
  double cost_weight = 5.0;
  double threshold_to_consider = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    detail::weight_field(v, cost_weight);
    detail::threshold_field(v, threshold_to_consider, detail::kOffNearGoal);
  }
};

}  // namespace bw::mppi
