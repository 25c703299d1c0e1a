// What its looks say: the classifier's scores of a thing, by the side from which it was seen. Scores of one
// side repeat each other and are averaged; other sides tell something new. A post is as round as a leg from
// everywhere, the corner of a box is not.
#pragma once

#include <array>

namespace bw::people {

class Appearance {
 public:
  static constexpr double kMax = 3.0;  ///< log odds, either way

  static constexpr double kEach = 0.1;  ///< [s] for which a sighting stands

  /// A score, 0 to 1, as seen by somebody who looks along `bearing` [rad], `since` [s] the one before: what is
  /// seen more often says no more in a second.
  void add(double score, double bearing, double since = kEach);

  /// Log odds of a person: sum over sides of the mean log odds of the scores, within +-kMax.
  double log_odds() const;

 private:
  static constexpr std::size_t kSides = 8;
  struct Side {
    float sum = 0.0F;
    float weight = 0.0F;
  };
  std::array<Side, kSides> sides_{};
};

}  // namespace bw::people
