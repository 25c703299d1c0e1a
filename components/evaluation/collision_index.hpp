// Collision index of Truong and Ngo (theory.md 7.7): how deep the robot is in somebody's space, from 0 to 1.
//
//   CI = max over people of exp(-d^2 / (2 sigma^2))
//
// with d the distance between centres and sigma half the comfortable distance. With sigma = 0.6 m, 0.54
// (physical limit) lies at 0.67 m, 0.14 (comfort limit) at 1.19 m, and two discs of 0.3 m touch at 0.607.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "components/evaluation/truth_sample.hpp"

namespace bw {

inline constexpr double kJudgingSigma = 0.6;  ///< [m]
inline constexpr double kComfortLimit = 0.14;
inline constexpr double kPhysicalLimit = 0.54;

inline double collision_index(const Vector2& robot, const std::vector<TruePerson>& people, double sigma) {
  double index = 0.0;
  for (const TruePerson& person : people) {
    index = std::max(index, std::exp(-(person.position - robot).squaredNorm() / (2.0 * sigma * sigma)));
  }
  return index;
}

}  // namespace bw
