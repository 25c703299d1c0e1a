#include "components/evaluation/possible/contact_verdict.hpp"

#include <algorithm>
#include <utility>

namespace bw::possible {

const char* text_of(Avoidance avoidance) {
  switch (avoidance) {
    case Avoidance::avoidable:
      return "avoidable";
    case Avoidance::not_avoidable:
      return "not avoidable";
    case Avoidance::undecided:
      break;
  }
  return "undecided";
}

ContactVerdict judge_contact(const SearchScene& scene, const std::vector<MotionState>& drive, double earliest,
                             double contact, double known_until, const Limits& limits,
                             const VerdictOptions& options) {
  constexpr double kRounding = 1e-6;  // [s]
  std::vector<MotionState> states;
  for (const MotionState& state : drive)
    if (state.time >= earliest - kRounding && state.time < contact - kRounding) states.push_back(state);
  ContactVerdict verdict;
  if (states.empty()) return verdict;
  const double until = std::min(contact + options.after_contact, std::max(contact, known_until));
  const MotionBounds bounds = bounds_of(limits, 1.0);
  const MotionBounds optimistic = bounds_of(limits, options.optimistic_factor);
  const auto is_saved = [&](std::size_t i) {
    std::optional<std::vector<MotionState>> motion =
        find_motion(scene, states[i], bounds, until, options.finder);
    if (!motion) return false;
    verdict.motion = std::move(*motion);  // states are asked later and later once one is saved
    return true;
  };
  const auto is_lost = [&](std::size_t i) {
    return search_optimistically(scene, states[i], optimistic, until, options.optimistic) ==
           SearchOutcome::none;
  };

  // Backwards in longer and longer steps, to the first state from which a motion is found.
  std::size_t failed = states.size();
  std::optional<std::size_t> saved;
  for (double back = 0.5; failed > 0 && !saved; back *= 2.0) {
    const auto from = std::lower_bound(
        states.begin(), states.begin() + static_cast<std::ptrdiff_t>(failed) - 1, contact - back - kRounding,
        [](const MotionState& state, double t) { return state.time < t; });
    const auto i = static_cast<std::size_t>(from - states.begin());
    if (is_saved(i)) {
      saved = i;
    } else {
      failed = i;
    }
  }
  // The first state from which there is none lies between the last known to be saved, or the first of all,
  // and the contact.
  std::size_t lost = states.size();
  std::size_t not_lost = 0;
  if (saved) {
    verdict.avoidance = Avoidance::avoidable;
    while (failed - *saved > 1) {
      const std::size_t middle = (*saved + failed) / 2;
      if (is_saved(middle)) {
        saved = middle;
      } else {
        failed = middle;
      }
    }
    verdict.saveable_until = states[*saved].time;
    not_lost = *saved;
  } else if (is_lost(0)) {
    verdict.avoidance = Avoidance::not_avoidable;
    verdict.lost_since = states[0].time;
    return verdict;
  }
  while (lost - not_lost > 1) {
    const std::size_t middle = (lost + not_lost) / 2;
    if (is_lost(middle)) {
      lost = middle;
    } else {
      not_lost = middle;
    }
  }
  if (lost < states.size()) verdict.lost_since = states[lost].time;
  return verdict;
}

}  // namespace bw::possible
