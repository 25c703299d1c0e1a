// How sure it is that something tracked is a person: a sum of log odds, each term with its reasons in a file
// of its own. Nothing is forgotten while somebody is hidden, and no term grows without bound, so that other
// evidence can still outweigh it.
#pragma once

#include <algorithm>
#include <cmath>

#include "components/people/tracker/evidence/appearance.hpp"
#include "components/people/tracker/evidence/walked.hpp"

namespace bw::people {

struct Existence {
  // Priors, by what it began as.
  static constexpr double kOneLeg = -3.5;      ///< one thing that may be a leg, or two in one
  static constexpr double kTwoLegs = -1.4;     ///< two that stand as legs do
  static constexpr double kWalker = -2.2;      ///< two that were first noticed walking
  static constexpr double kLoneWalker = -5.5;  ///< one of which that is so
  static constexpr double kUnseen = -60.0;     ///< whom no laser has shown yet
  /// Of two legs that only stand, by each other thing about that looks like a leg, beyond the first.
  static constexpr double kEachOther = -0.3;
  /// The same of two legs that have walked less than a metre.
  static constexpr double kEachOtherWalking = -0.25;
  /// Of two legs that only stand where nobody is known to walk, what ln(1 + people known) makes up for, and
  /// what it says at most: people are found where people are, and two posts look like legs everywhere. In
  /// full in a furnished place, and at first.
  static constexpr double kAlone = -3.0;
  static constexpr double kCompany = 2.0;
  static constexpr double kMaxCompany = 1.0;
  /// By 1 + so much for each of them other things that look like legs say less against such two.
  static constexpr double kShareOfOthers = 0.5;

  /// Of somebody who was confirmed: what was believed once is not given up for a doubt, such as more things
  /// about.
  static constexpr double kKept = 2.5;
  /// Less for who has never moved, where furniture like legs surely stands about.
  static constexpr double kLostAmongFurniture = 0.8;
  /// Of what looks say of two legs first noticed walking, or of one, beside the whole of it, before they have
  /// walked a metre.
  static constexpr double kLooksOfWalkers = 1.0;
  static constexpr double kUsualLooks = 1.0;  ///< log odds between furniture that seems to walk and people

  /// Of legs that are where nothing was before, both or the only one that is seen; the share of it where one
  /// of two is; and of what is not somebody yet.
  static constexpr double kCame = 6.0;
  static constexpr double kOneCame = 0.3;
  static constexpr double kThingCame = 2.7;
  /// Log odds of having come from which on somebody is known to.
  static constexpr double kHasCome = 3.0;
  /// Of two that stand and never move, for each second in view [1/s], and at most.
  static constexpr double kRigid = -0.1;
  static constexpr double kMaxRigid = -2.0;

  /// Of who walked and is seen where something stood before: from here on it is that (`taken` ends at -14).
  static constexpr double kSurelyTaken = -13.0;

  double prior = kOneLeg;
  Walked walked;
  Appearance appearance;
  double foot_shifts = 0.0;  ///< log odds (foot_shifts.hpp)
  double row = 0.0;          ///< log odds (row_of_posts.hpp), lately
  double clutter = 0.0;      ///< log odds by how many things about look like legs
  double alone = 0.0;        ///< log odds of two that stand by how few people are known to walk about
  bool in_place = false;     ///< they seem to walk where things stood all the time
  double taken = 0.0;        ///< log odds of who walked and is seen where something stood before
  double came = 0.0;         ///< log odds by what was at the position of the legs before
  double rigid = 0.0;        ///< log odds of two that stand and never move
  double furnished = 0.0;    ///< how sure it is that furniture like legs stands about, 0 to 1
  double kept = 0.0;         ///< kKept of somebody confirmed

  /// To be called when the evidence of a sweep is complete.
  void keep_belief() {
    kept = log_odds() >= 0.0 ? (has_moved() ? kKept : kKept - kLostAmongFurniture * furnished) : 0.0;
  }

  /// In a way that furniture does not.
  bool has_moved() const {
    return prior != kTwoLegs || walked.distance >= Walked::kFree || came >= kHasCome || foot_shifts > 0.0;
  }

  double log_odds() const {
    return prior + distance_walked() + appearance.log_odds() + looks_of_walker() + foot_shifts + row +
           clutter + alone + taken + came + rigid + kept;
  }
  double confidence() const { return 1.0 / (1.0 + std::exp(-log_odds())); }

 private:
  double distance_walked() const {
    return in_place && walked.distance < Walked::kFree ? 0.0 : walked.log_odds();
  }
  double looks_of_walker() const {
    const bool walks = prior == kWalker || prior == kLoneWalker;
    return walks && walked.distance < Walked::kFree ? kLooksOfWalkers * (appearance.log_odds() - kUsualLooks)
                                                    : 0.0;
  }
};

}  // namespace bw::people
