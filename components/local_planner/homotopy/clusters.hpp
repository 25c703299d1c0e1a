// Static obstacles joined where the robot does not fit between them.
#pragma once

#include <vector>

#include "components/model/capsule_index.hpp"
#include "components/model/obstacles.hpp"

namespace bw::homotopy {

/// All points within `radius` [m] of the axis; a point or disc has axis.a == axis.b.
struct Part {
  Segment axis;
  double radius = 0.0;
};

/// In this order.
std::vector<Capsule> capsules_of(const std::vector<Part>& parts);

/// Single-link clusters: parts with a gap [m] of at most `widest_gap` are in one cluster. Parts and clusters
/// come in an order that does not depend on that of the input. What is far
/// from each other is not compared.
std::vector<std::vector<Part>> clusters_of(const StaticObstacles& obstacles, double widest_gap);

}  // namespace bw::homotopy
