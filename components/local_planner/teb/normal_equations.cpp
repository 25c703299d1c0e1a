#include "components/local_planner/teb/normal_equations.hpp"

#include <algorithm>
#include <cmath>

namespace bw::teb {
namespace {

constexpr std::size_t kWidth = 12;

// row += a * values, from column `first` on. Fixed lengths, so that it is unrolled and vectorised.
template <std::size_t kLength>
void add_scaled(double a, const double* values, double* row) {
  for (std::size_t j = 0; j < kLength; ++j) row[j] += a * values[j];
}

// row -= what the rows of `at` have in column `column`, times those rows from the block of that column on. In
// a copy, so that the compiler knows that nothing overlaps.
template <std::size_t kLength>
void subtract_products(const BlockRow& at, std::size_t column, double* row) {
  double sum[kLength];
  std::copy_n(row, kLength, sum);
  for (std::size_t m = 0; m < 4; ++m)
    add_scaled<kLength>(-at[m][column], at[m].data() + kWidth - kLength, sum);
  std::copy_n(sum, kLength, row);
}

// The block of pose p of three, and what follows it in its row.
template <std::size_t kPose>
void add_block(const double* jacobian, double residual, BlockRow& rows, std::array<double, 4>& gradient) {
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = jacobian[4 * kPose + i];
    if (a == 0.0) continue;
    gradient[i] += a * residual;
    add_scaled<kWidth - 4 * kPose>(a, jacobian + 4 * kPose, rows[i].data());
  }
}

}  // namespace

void NormalEquations::reset(std::size_t poses) {
  rows.assign(poses + 1, BlockRow{});
  gradient.assign(poses + 1, {});
}

void NormalEquations::add(std::size_t k, const double* jacobian, double residual) {
  add_block<0>(jacobian, residual, rows[k], gradient[k]);
  add_block<1>(jacobian, residual, rows[k + 1], gradient[k + 1]);
  add_block<2>(jacobian, residual, rows[k + 2], gradient[k + 2]);
}

void NormalEquations::add(std::size_t k, double fraction, const Eigen::Vector3d& gradient_in,
                          double residual) {
  const double at[2] = {1.0 - fraction, fraction};
  for (std::size_t p = 0; p < 2; ++p) {
    if (at[p] == 0.0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = at[p] * gradient_in[static_cast<Eigen::Index>(i)];
      gradient[k + p][i] += a * residual;
      for (std::size_t q = p; q < 2; ++q) {
        double* row = rows[k + p][i].data() + 4 * (q - p);
        for (std::size_t j = 0; j < 3; ++j) row[j] += a * at[q] * gradient_in[static_cast<Eigen::Index>(j)];
      }
    }
  }
}

void NormalEquations::fix_ends() {
  const std::size_t goal = rows.size() - 2;
  for (std::size_t i = 0; i < 3; ++i) {
    rows[0][i] = {};
    rows[0][i][i] = 1.0;
    gradient[0][i] = 0.0;
  }
  rows[goal] = rows[goal + 1] = {};
  gradient[goal] = gradient[goal + 1] = {};
  for (std::size_t i = 0; i < 4; ++i) {
    std::fill_n(rows[goal - 1][i].begin() + 4, 8, 0.0);
    if (goal >= 2) std::fill_n(rows[goal - 2][i].begin() + 8, 4, 0.0);
  }
}

double NormalEquations::largest_information() const {
  double largest = rows[0][3][3];
  for (std::size_t k = 1; k + 2 < rows.size(); ++k) {
    const BlockRow& at = rows[k];
    // x and y together: the trace of their block is the same in every frame.
    largest = std::max({largest, at[0][0] + at[1][1], at[2][2], at[3][3]});
  }
  return largest;
}

bool BandFactor::factorise(const NormalEquations& equations, double damping) {
  rows = equations.rows;
  inverse.resize(rows.size());
  for (std::size_t k = 0; k + 2 < rows.size(); ++k) {
    BlockRow& at = rows[k];
    for (std::size_t i = 0; i < 4; ++i) {
      const double pivot = at[i][i] + damping;
      if (!(pivot > 0.0)) return false;
      inverse[k][i] = 1.0 / std::sqrt(pivot);
      at[i][i] = pivot;
      for (std::size_t j = 0; j < kWidth; ++j) at[i][j] *= inverse[k][i];
      for (std::size_t j = 0; j < i; ++j) at[i][j] = 0.0;
      for (std::size_t j = i + 1; j < 4; ++j) add_scaled<kWidth>(-at[i][j], at[i].data(), at[j].data());
    }
    for (std::size_t i = 0; i < 4; ++i) {
      subtract_products<8>(at, 4 + i, rows[k + 1][i].data());
      subtract_products<4>(at, 8 + i, rows[k + 2][i].data());
    }
  }
  return true;
}

void BandFactor::solve_transposed(BandVector& b) const {
  for (std::size_t k = 0; k + 2 < rows.size(); ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::array<double, kWidth>& row = rows[k][i];
      const double y = b[k][i] *= inverse[k][i];
      for (std::size_t j = i + 1; j < 4; ++j) b[k][j] -= y * row[j];
      add_scaled<4>(-y, row.data() + 4, b[k + 1].data());
      add_scaled<4>(-y, row.data() + 8, b[k + 2].data());
    }
  }
}

void BandFactor::solve(BandVector& y) const {
  for (std::size_t k = rows.size() - 2; k-- > 0;) {
    for (std::size_t i = 4; i-- > 0;) {
      const std::array<double, kWidth>& row = rows[k][i];
      // Two sums side by side: neither waits for the other.
      double sum = y[k][i], after = 0.0;
      for (std::size_t j = 0; j < 4; ++j) sum -= row[4 + j] * y[k + 1][j];
      for (std::size_t j = 0; j < 4; ++j) after += row[8 + j] * y[k + 2][j];
      for (std::size_t j = i + 1; j < 4; ++j) after += row[j] * y[k][j];
      y[k][i] = (sum - after) * inverse[k][i];
    }
  }
}

}  // namespace bw::teb
