// The equations of theory.md 7.3: somebody who walks where they face, as state (x, y, theta, v, omega), and
// the same motion without a heading, as (x, y, vx, vy). Lengths [m], angles [rad], in a frame that does not
// turn.
//
//   over dt:  rotation = omega k,  k = T (1 - exp(-dt / T))      a turn rate dies out with the memory T
//             (x, y) += v dt sinc(rotation / 2) (cos, sin)(theta + rotation / 2)      the chord of the arc
//             theta += rotation,  omega *= exp(-dt / T)
//
// With omega = 0, known for sure, these are the four states of the dissertation.
#pragma once

#include <Eigen/Core>

#include "runtime/base/pose2.hpp"

namespace bw::people {

using HeadingState = Eigen::Matrix<double, 5, 1>;  ///< (x, y, theta, v, omega)
using HeadingCovariance = Eigen::Matrix<double, 5, 5>;

/// White noise that drives the motion, as density: its integral over 1 s has this standard deviation.
struct HeadingNoise {
  double heading = 0.0;       ///< on theta' [rad/s/sqrt(Hz)]
  double acceleration = 0.0;  ///< on v' [m/s^2/sqrt(Hz)]
  double turn_rate = 0.0;     ///< on omega' [rad/s^2/sqrt(Hz)]
};

/// Where the state is after dt [s]; the heading is not wrapped.
HeadingState walked(const HeadingState& x, double dt, double turn_rate_memory);
HeadingCovariance walked_jacobian(const HeadingState& x, double dt, double turn_rate_memory);
/// Covariance that the noise adds over a dt [s] in which the heading hardly turns.
HeadingCovariance walked_noise(const HeadingState& x, double dt, const HeadingNoise& noise);

/// (x, y, vx, vy) of a heading state.
Eigen::Vector4d without_heading(const HeadingState& x);
/// Its mean square error when x errs by P: the moments of v (cos, sin)(theta) of a Gaussian, exactly. To
/// first order J P J^T; but that would know who stops exactly across their path, whatever the heading is
/// worth, and let who has no heading be anywhere.
Eigen::Matrix4d covariance_without_heading(const HeadingState& x, const HeadingCovariance& P);

/// The heading state of (x, y, vx, vy), with omega = 0, and its derivative. The velocity must not be zero.
HeadingState with_heading(const Eigen::Vector4d& m);
Eigen::Matrix<double, 5, 4> with_heading_jacobian(const Eigen::Vector4d& m);

/// Constant velocity over dt [s], and what white acceleration of this density adds.
Eigen::Matrix4d glide(double dt);
Eigen::Matrix4d glide_noise(double dt, double acceleration);

}  // namespace bw::people
