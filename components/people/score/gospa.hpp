// How far a set of positions is from the true one: generalized optimal sub-pattern assignment (Rahmathullah,
// Garcia-Fernandez and Svensson, FUSION 2017) with alpha = 2, so that it is a sum over what was found, missed
// and made up:
//
//   gospa^p = min over assignments  sum of d^p over the assigned  +  c^p / 2 * (missed + false)
#pragma once

#include <vector>

#include "components/people/tracker/assignment.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::people {

class Gospa {
 public:
  static constexpr double kCutoff = 0.75;  ///< c [m], the radius within which CLEAR MOT matches
  static constexpr double kPower = 2.0;    ///< p

  /// Between the two sets [m]; 0 when both are empty.
  double operator()(const std::vector<Vector2>& truth, const std::vector<Vector2>& tracks);

 private:
  Assignment assignment_;
};

}  // namespace bw::people
