// Who of those known to be there shows in a sweep: for a truth that sees through walls.
#pragma once

#include <vector>

#include "components/model/laser_sweep.hpp"
#include "components/people/score/clear_mot.hpp"

namespace bw::people {

/// Sets `counted` and `unoccluded` of people, in the frame F of the sweep. Counted: in the view of the
/// scanner, no farther from it than `range` [m], and most of the three beams through the middle of the body
/// end at a person or behind, not at something nearer that is nobody. Unoccluded: at least three beams end at
/// them.
void look_for(const LaserSweep& sweep, double range, std::vector<TruePerson>& people);

}  // namespace bw::people
