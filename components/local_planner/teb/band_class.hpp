// On which side a band passes every obstacle, movers where they are when the robot is there: its topology
// class in (x, y, t). Exact for the piecewise linear motion of band and movers.
#pragma once

#include <vector>

#include "components/local_planner/teb/band.hpp"
#include "components/model/obstacles.hpp"

namespace bw::teb {

/// Total turning [rad] of the line from each obstacle to the robot: first the `fixed` points, then the
/// movers. A band that is shorter than `horizon` [s] waits at its goal until then, so that bands of different
/// duration end alike.
std::vector<double> winding(const Band& band, const std::vector<Vector2>& fixed,
                            const std::vector<Mover>& movers, double horizon);

/// Windings of two bands with the same ends belong to one class when they differ by less than half a turn
/// about every obstacle (spec 6.2).
bool same_class(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace bw::teb
