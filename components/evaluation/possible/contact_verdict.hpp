// Whether a contact could have been avoided, and until when (theory.md 8.10).
//
// From a state of the drive before the contact on, a motion that stays clear until some seconds after it is
// looked for: found is `avoidable`; and where even the hopeful search finds nothing, `not_avoidable`. Who
// could still be saved at one time could be before, by driving as the robot did until then: so the latest of
// these times is found by halving.
#pragma once

#include <optional>
#include <vector>

#include "components/evaluation/possible/motion_finder.hpp"
#include "components/evaluation/possible/optimistic_search.hpp"
#include "components/evaluation/possible/search_scene.hpp"
#include "components/model/limits.hpp"

namespace bw::possible {

enum class Avoidance {
  avoidable,      ///< a motion is known, proven with the whole footprint
  not_avoidable,  ///< no motion exists, proven with a smaller one
  undecided       ///< neither; counts as possible
};

const char* text_of(Avoidance avoidance);

struct VerdictOptions {
  double after_contact = 5.0;      ///< a motion must stay clear until so long after the contact [s]
  double optimistic_factor = 2.0;  ///< on the accelerations, for the hopeful search
  OptimisticSearchOptions optimistic;
  FinderOptions finder;
};

struct ContactVerdict {
  Avoidance avoidance = Avoidance::undecided;
  std::optional<double> saveable_until;  ///< latest state of the drive from which a motion is known [s]
  std::optional<double> lost_since;      ///< first state of the drive from which there is none, proven [s]
  std::vector<MotionState> motion;       ///< the one known from `saveable_until` on; empty without
};

/// `drive`: states by rising time; those from `earliest` until before `contact` [s] are looked at.
/// `known_until`: after it nobody knows where people were [s]. Without a state in that time it is undecided.
ContactVerdict judge_contact(const SearchScene& scene, const std::vector<MotionState>& drive, double earliest,
                             double contact, double known_until, const Limits& limits,
                             const VerdictOptions& options = {});

}  // namespace bw::possible
