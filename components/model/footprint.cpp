#include "components/model/footprint.hpp"

#include <algorithm>

#include "components/model/footprint_distance.hpp"

namespace bw {

double inscribed_radius(const Footprint& footprint) {
  if (!footprint.is_polygon()) return footprint.radius;
  return std::max(0.0, -gap_to(footprint, Pose2{}, Capsule{}));
}

}  // namespace bw
