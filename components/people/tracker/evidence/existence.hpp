// How sure it is that something tracked is a person: a sum of log odds, each term with its reasons in a file of its
// own. Nothing is forgotten while somebody is hidden, and no term grows without bound, so that other evidence can
// still outweigh it.
#pragma once

#include <algorithm>
#include <cmath>

#include "components/people/tracker/evidence/looks.hpp"
#include "components/people/tracker/evidence/walked.hpp"

namespace bw::people {

struct Existence {
  // Priors, by what it began as.
  static constexpr double kOneLeg = -3.5;      ///< one thing that may be a leg, or two in one
  static constexpr double kTwoLegs = -1.0;     ///< two that stand as legs do
  static constexpr double kWalker = -2.2;      ///< two that were first noticed walking
  static constexpr double kLoneWalker = -4.5;  ///< one of which that is so
  static constexpr double kUnseen = -60.0;     ///< whom no laser has shown yet
  /// Of two legs that only stand, by each other thing about that looks like a leg, beyond the first.
  static constexpr double kEachOther = -0.5;
  /// The same of two legs that have walked less than a metre.
  static constexpr double kEachOtherWalking = -0.25;

  double prior = kOneLeg;
  Walked walked;
  Looks looks;
  double fidgets = 0.0;  ///< log odds (fidgets.hpp)
  double row = 0.0;      ///< log odds (row_of_posts.hpp), lately
  double clutter = 0.0;  ///< log odds by how many things about look like legs

  double log_odds() const { return prior + walked.log_odds() + looks.log_odds() + fidgets + row + clutter; }
  double confidence() const { return 1.0 / (1.0 + std::exp(-log_odds())); }
};

}  // namespace bw::people
