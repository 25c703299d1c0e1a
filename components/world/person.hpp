// A person in the world, and the one interface of everything that makes people move. Frame: map; SI units.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

struct Person {
  std::uint32_t id = 0;
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = 0.3;
};

/// Robots among those who move have ids from here on, in the order of the world.
inline constexpr std::uint32_t kFirstRobotId = 2'000'000'000;

/// A robot as people see it.
struct RobotBody {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = 0.3;
};

/// What a group of people may react to.
struct Surroundings {
  const std::vector<Person>& others;  ///< people of other groups, already moved
  std::span<const RobotBody> robots;  ///< those that are seen
};

class PeopleModel {
 public:
  virtual ~PeopleModel() = default;
  /// Moves everybody by dt [s] and appends those present to `people`, in an order that never changes.
  virtual void step(double dt, const Surroundings& surroundings, std::vector<Person>& people) = 0;
  /// Moves one person aside; they go on from there. False when it has no such person, or theirs is a recorded
  /// way.
  virtual bool displace(std::uint32_t /*id*/, const Vector2& /*by*/) { return false; }
};

}  // namespace bw
