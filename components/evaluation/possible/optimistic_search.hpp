// Whether any motion can stay clear of everybody, asked so that "no" is a proof (theory.md 8.10).
//
// Kept is a set of cells (x, y, heading) that holds every position a robot can be at t_k = t_0 + k h without
// having been in contact at t_1 ... t_k. It is too large, never too small, because
//  - speed and turn rate may take any value, at any moment, between what the accelerations allow since t_0:
//    v_0 -+ A (t - t_0) and omega_0 -+ B (t - t_0), cut at the limits. A real motion changes them steadily.
//  - A step takes the whole cell along. From heading bin i to bin j at most at the rate W the heading stays
//    within [(i + j - 1) q - W h, (i + j + 1) q + W h] / 2 (q: width of a bin, bins about their multiples of
//    q), so the step is h times a mean of velocities v dir(theta), which lies in the convex hull of those of
//    its extreme speeds and of that arc. All cells that any corner of the cell may come to under any vector
//    of the hull are taken.
//  - What has been rounded outward is cut again only by what no motion can leave: the half-planes n . (p -
//    p_0) <= integral of the largest n . v dir(theta) of each instant, widened by the reach of a cell, and
//    the headings between the integrals of the extreme turn rates.
//  - A cell is taken away at t_k only where its centre is deeper than half its diagonal c / sqrt(2) in
//    somebody, so that all of it is in contact: the contact radius is less by that grid error. Between t_k
//    nothing is looked at. A polygon counts as the largest disc in it.
// So when no cell is left, no motion within the bounds exists. When cells are left, nothing is said.
#pragma once

#include "components/evaluation/possible/search_scene.hpp"

namespace bw::possible {

struct OptimisticSearchOptions {
  double step = 0.1;         ///< h [s]
  double cell = 0.01;        ///< c [m]
  double half_width = 5.0;   ///< of the area looked at, around the start [m]; who leaves it has escaped
  double escape_area = 4.0;  ///< so much room left [m^2]: given up as unlikely to be a proof
};

enum class SearchOutcome {
  none,  ///< no motion within the bounds stays clear: proven
  some   ///< cells are left, or it was given up
};

/// From `start` until `until` [s].
SearchOutcome search_optimistically(const SearchScene& scene, const MotionState& start,
                                    const MotionBounds& bounds, double until,
                                    const OptimisticSearchOptions& options = {});

}  // namespace bw::possible
