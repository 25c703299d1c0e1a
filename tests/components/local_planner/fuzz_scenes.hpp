// Scenes no planner should meet, and will: random ones with up to three things wrong or extreme.
#pragma once

#include <string>

#include "components/model/planning.hpp"
#include "components/model/random.hpp"

namespace bw {

struct FuzzScene {
  PlanningProblem problem;
  std::string what;      ///< was done to it, for people
  bool unsound = false;  ///< something is not finite, negative or otherwise no number to plan with
};

FuzzScene fuzz_scene(Random& random);

}  // namespace bw
