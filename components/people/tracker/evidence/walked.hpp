// Who walks or has walked is a person: furniture does not.
#pragma once

#include <algorithm>

namespace bw::people {

/// Log odds by the way [m] that legs went as a walker's do: nothing in the first `kSlip` metres, which edges
/// that come into view and errors of odometry make up, then in proportion, up to kMax, which nothing else
/// outweighs.
struct Walked {
  static constexpr double kSlip = 0.15;      ///< [m]
  static constexpr double kPerMetre = 10.0;  ///< [1/m]
  static constexpr double kMax = 7.0;
  static constexpr double kFree = 1.0;  ///< [m] who has walked so far has no legs of furniture

  double distance = 0.0;  ///< [m]

  double log_odds() const { return std::clamp(kPerMetre * (distance - kSlip), 0.0, kMax); }
};

}  // namespace bw::people
