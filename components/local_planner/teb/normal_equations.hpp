// The normal equations of a band, J'J x = -J'r, and their Cholesky factorisation. Terms tie at most three
// successive poses together, so that J'J is a band of 4 x 4 blocks.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace bw::teb {

/// One row of blocks: rows of the four variables (x, y, theta, dt) of pose k, columns of those of poses k, k
/// + 1 and k + 2.
using BlockRow = std::array<std::array<double, 12>, 4>;
/// Four variables of every pose.
using BandVector = std::vector<std::array<double, 4>>;

struct NormalEquations {
  std::vector<BlockRow> rows;  ///< the upper triangle; those of the goal, and one more, are not used
  BandVector gradient;         ///< J'r

  /// All zero, of a band of so many poses. Allocates only when that are more than ever before.
  void reset(std::size_t poses);
  /// A residual with its derivatives by poses k, k + 1 and k + 2.
  void add(std::size_t k, const double* jacobian, double residual);
  /// A residual of the pose at this fraction of segment k, with its derivatives by x, y and theta.
  void add(std::size_t k, double fraction, const Eigen::Vector3d& gradient, double residual);
  /// The goal and the pose of the start stay where they are.
  void fix_ends();
  /// Largest diagonal entry, x and y of a pose taken together.
  double largest_information() const;
};

/// R of R'R = J'J + damping I, upper triangular.
struct BandFactor {
  std::vector<BlockRow> rows;
  BandVector inverse;  ///< of the diagonal of R

  /// False when the sum is not positive definite.
  bool factorise(const NormalEquations& equations, double damping);
  /// y of R'y = b, in place.
  void solve_transposed(BandVector& b) const;
  /// x of Rx = y, in place.
  void solve(BandVector& y) const;
};

}  // namespace bw::teb
