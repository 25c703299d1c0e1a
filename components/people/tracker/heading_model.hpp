// The equations of theory.md 7.3: somebody who walks where they face, as state (x, y, theta, v) of the
// dissertation, and the same motion without a heading, as (x, y, vx, vy). Lengths [m], angles [rad], in a frame
// that does not turn.
//
//   over dt:  (x, y) += v dt (cos, sin)(theta);  theta and v stay, but for the noise
#pragma once

#include <Eigen/Core>

#include "runtime/base/pose2.hpp"

namespace bw::people {

using HeadingState = Eigen::Vector4d;  ///< (x, y, theta, v)
using HeadingCovariance = Eigen::Matrix4d;

/// White noise that drives the motion, as density: its integral over 1 s has this standard deviation.
struct HeadingNoise {
  double heading = 0.0;       ///< on theta' [rad/s/sqrt(Hz)]
  double acceleration = 0.0;  ///< on v' [m/s^2/sqrt(Hz)]
};

/// Where the state is after dt [s]; the heading is not wrapped.
HeadingState walked(const HeadingState& x, double dt);
HeadingCovariance walked_jacobian(const HeadingState& x, double dt);
/// Covariance that the noise adds over dt [s].
HeadingCovariance walked_noise(const HeadingState& x, double dt, const HeadingNoise& noise);

/// (x, y, vx, vy) of a heading state.
Eigen::Vector4d without_heading(const HeadingState& x);
/// Its mean square error when x errs by P: the moments of v (cos, sin)(theta) of a Gaussian, exactly. To
/// first order J P J^T; but that would know who stops exactly across their path, whatever the heading is
/// worth, and let who has no heading be anywhere.
Eigen::Matrix4d covariance_without_heading(const HeadingState& x, const HeadingCovariance& P);

/// The heading state of (x, y, vx, vy), and its derivative. The velocity must not be zero.
HeadingState with_heading(const Eigen::Vector4d& m);
HeadingCovariance with_heading_jacobian(const Eigen::Vector4d& m);

/// Constant velocity over dt [s], and what white acceleration of this density adds.
Eigen::Matrix4d glide(double dt);
Eigen::Matrix4d glide_noise(double dt, double acceleration);

}  // namespace bw::people
