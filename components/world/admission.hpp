// Whether somebody may be put into a running world, and why not. Frame: map; SI units. Values in, result out.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

/// Nobody walks, or is pushed, faster than this [m/s]: people run at 3 m/s.
inline constexpr double kFastestPerson = 3.0;
/// At once in one world, scripted and recorded ones included.
inline constexpr std::size_t kMaxPeople = 100;

struct NewPerson {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};  ///< kept to; with a goal its norm is the speed, and zero a usual speed
  std::optional<Vector2> goal;
  double radius = 0.3;
};

/// One sentence; empty: it is a speed of people.
std::string fault_of_speed(const Vector2& velocity);

/// One sentence; empty: they may come.
std::string refusal_of(const NewPerson& person, const StaticScene& scene, std::span<const RobotBody> robots,
                       const std::vector<Person>& people);

}  // namespace bw
