// A robot that stands although it has not arrived, because it can neither drive on nor turn: it backs off a
// little.
#pragma once

#include <optional>

#include "components/model/planning.hpp"

namespace bw::dwa {

/// Backs off 0.3 m, straight and slowly (../back_off), when nothing else than standing has been found for 2 s
/// and nobody walks within 2 m, as far as there is room behind.
class StuckRecovery {
 public:
  /// Puts the command to back off into `result`, what was planned for `problem`, while that is the thing to
  /// do.
  void apply(const PlanningProblem& problem, PlanningResult& result);
  void forget() { *this = {}; }

 private:
  bool is_stuck(const PlanningProblem& problem, const PlanningResult& result);

  std::optional<Time> standing_since_;
  std::optional<Vector2> backing_from_;
};

}  // namespace bw::dwa
