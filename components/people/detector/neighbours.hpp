// What stands about a narrow thing: legs come in twos, chairs and tables stand on four alike.
#pragma once

#include <vector>

#include "components/people/detector/beams.hpp"
#include "components/people/detector/clusters.hpp"

namespace bw::people {

/// Of narrow clusters beside this one, whether background or not.
struct Neighbours {
  static constexpr double kWidest = 0.3;    ///< wider clusters are not narrow [m]
  static constexpr double kFarthest = 2.0;  ///< none nearer: this is told [m]
  static constexpr double kAbout = 1.0;     ///< how near those are that are counted [m]

  double nearest = kFarthest;  ///< how far the nearest is, from middle to middle [m]
  double second = kFarthest;   ///< and the next one [m]
  double width = 0.0;          ///< of the nearest [m]
  int about = 0;               ///< how many there are
};

class NeighbourSearch {
 public:
  /// One for each cluster, in the same order; valid until the next call.
  const std::vector<Neighbours>& find(const Beams& beams, const Clusters& clusters);
  const std::vector<Neighbours>& last() const { return found_; }

 private:
  struct Narrow {
    Vector2 middle;
    double width;
    std::size_t cluster;
  };
  std::vector<Narrow> narrow_;  ///< by rising x
  std::vector<Neighbours> found_;
};

}  // namespace bw::people
