// The complex H-signature of a path (Bhattacharya et al. 2010; theory.md 6.2, literal form). It grows with
// the product of the distances between obstacles, so that its digits do not reach beyond about ten of them:
// the winding vector is the default.
#pragma once

#include <complex>

#include "components/local_planner/homotopy/winding.hpp"

namespace bw::homotopy {

/// Sum over the bodies l at c_l and the legs z1-z2 of
///
///   A_l [ln |z2 - c_l| - ln |z1 - c_l| + i (angle of smallest modulus)]
///   A_l = f0(c_l) / prod_{j != l} (c_l - c_j)
///   f0(z) = (z - BL)^a (z - TR)^b,   a + b = N - 1,   |a - b| <= 1
///
/// with BL and TR the corners of a box well around course and bodies. Movers stand at their representative.
/// The route is joined to start and goal of the course. Coincident representatives (closer than 1 mm) count
/// as one obstacle; zero without bodies.
std::complex<double> h_signature(const Route& route, const std::vector<Body>& bodies, const Course& course);

/// Real and imaginary parts differ by less than the threshold.
bool same_h_signature(const std::complex<double>& h, const std::complex<double>& k, double threshold);

}  // namespace bw::homotopy
