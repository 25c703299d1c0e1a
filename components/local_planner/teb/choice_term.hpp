// A term that a planner of the band adds to the cost by which it chooses among its bands (3.10). PTEB is
// teb_homotopy with one such term (hrvo_preference.hpp).
#pragma once

#include <functional>
#include <optional>

#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/local_planner/teb/band_candidate.hpp"

namespace bw::teb {

/// The term in one cycle.
struct ChoiceTerm {
  std::function<double(const BandCandidate&)> cost;  ///< of a candidate that was improved; empty: no term
  std::optional<hrvo::Advice> advice;                ///< what it rests on, for people to see
};

/// Makes it for a cycle. The term keeps references to both arguments.
using ChoiceTermSource = std::function<ChoiceTerm(const PlanningProblem&, const ObstacleField&)>;

}  // namespace bw::teb
