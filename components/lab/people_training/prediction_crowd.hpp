// Crowds from seeds that the learned prediction is trained on: people by the social forces of the world, who wander, stop, go
// on and turn besides. Metres, seconds.
//
// The rule:
// - 0.03 to 0.35 people per square metre (uniform in the logarithm) of a square of 10 to 18 m that goes on in itself: who
//   leaves at one side is met at the other; each has a course of their own, in half of the crowds to and fro along x;
// - a third walks in twos and threes, and in half of the crowds up to a half stands;
// - wanted speeds are normal about 0.8 to 1.5 m/s; others push by 0.05 to 1 times the world's force;
// - the wanted velocity wanders: white acceleration of 0 to 1 m/s/sqrt(s), forgotten within 2 s, a third of that for who
//   stands;
// - in half of the crowds each stops up to 0.06 times a second for 7 s; in half they take another course up to 0.1 times.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw::people {

inline constexpr double kCrowdStep = 0.1;  ///< [s]

/// Positions of everybody every kCrowdStep: result[k][i]. `seconds` of it, after 5 s in which they mingle.
std::vector<std::vector<Vector2>> draw_crowd(std::uint64_t seed, double seconds);

}  // namespace bw::people
