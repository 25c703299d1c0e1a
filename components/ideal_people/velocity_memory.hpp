// Velocities of the last moments. Recorded people change theirs at once from one annotation to the next, and
// what is annotated is some centimetres wrong: 0.05 m in each of two positions 0.4 s apart are 0.18 m/s. A
// mean forgets that error:
//
//   u(t + dt) = u(t) + (1 - exp(-dt / memory)) (v - u(t))        u = v at the first look
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "components/model/obstacles.hpp"

namespace bw {

class VelocityMemory {
 public:
  /// Sets the velocities of `people` to their means over about `memory` [s]; 0 leaves them. `dt` [s] since
  /// the last call.
  /// Who is missing is forgotten; all are when the clock goes back (dt < 0).
  void smooth(std::vector<Mover>& people, double memory, double dt);

 private:
  std::map<std::uint32_t, Vector2> velocities_;
};

}  // namespace bw
