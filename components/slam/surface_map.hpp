// Where walls are, from the scans of one submap: a point with a normal for each cell that was hit, and for
// the cells around the nearest of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "components/slam/scan.hpp"
#include "components/slam/tiled_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::slam {

/// Mean of the hits in one cell, in the submap's frame.
struct Surface {
  float x = 0.0F;  ///< [m]
  float y = 0.0F;
  float normal_cos2 = 0.0F;  ///< SurfacePoint's, averaged
  float normal_sin2 = 0.0F;
  std::int32_t hits = 0;

  SurfacePoint point() const { return {x, y, normal_cos2, normal_sin2}; }
  bool operator==(const Surface&) const = default;
};

/// A surface of B, in A.
inline Surface moved(const Surface& surface, const Pose2& X_AB) {
  const Vector2 p = X_AB * Vector2{surface.x, surface.y};
  const auto c = static_cast<float>(std::cos(2.0 * X_AB.theta));
  const auto s = static_cast<float>(std::sin(2.0 * X_AB.theta));
  return {static_cast<float>(p.x()), static_cast<float>(p.y()),
          c * surface.normal_cos2 - s * surface.normal_sin2,
          s * surface.normal_cos2 + c * surface.normal_sin2, surface.hits};
}

class SurfaceMap {
 public:
  /// [m] from a wall up to which its cells know of it
  static constexpr double kReach = 0.3;
  /// [m] spread of the likelihood about a wall, for search
  static constexpr double kSpread = 0.08;

  /// All of it, as values: which surface a cell knows depends on the order in which they came.
  struct State {
    struct Own {
      std::int32_t i = 0;  ///< cell in which the surface was hit
      std::int32_t j = 0;
      bool operator==(const Own&) const = default;
    };
    struct Near {
      std::int32_t i = 0;
      std::int32_t j = 0;
      std::int32_t surface = 0;
      float squared = 0.0F;  ///< [m^2]
      bool operator==(const Near&) const = default;
    };
    std::vector<Surface> surfaces;
    std::vector<Own> own;    ///< of each surface
    std::vector<Near> near;  ///< cells that know a surface, in the order of TiledGrid
    bool operator==(const State&) const = default;
  };

  explicit SurfaceMap(double resolution);
  SurfaceMap(double resolution, std::span<const Surface> surfaces);
  SurfaceMap(double resolution, const State& state);
  State state() const;

  void insert(std::span<const SurfacePoint> points, const Pose2& X_SB);

  /// The surface nearest to the centre of the cell that holds (x, y), at most kReach away; null: none. To
  /// within what surfaces have moved in their cells since they were made.
  const Surface* nearest(double x, double y) const {
    const Near& near = near_.at(cell(x), cell(y));
    return near.surface < 0 ? nullptr : &surfaces_[static_cast<std::size_t>(near.surface)];
  }
  /// exp(-d^2 / (2 kSpread^2)) in 255ths, d from the cell's centre to the nearest surface.
  int likelihood(double x, double y) const { return near_.at(cell(x), cell(y)).likelihood; }
  int likelihood_of_cell(int i, int j) const { return near_.at(i, j).likelihood; }

  const std::vector<Surface>& surfaces() const { return surfaces_; }
  double resolution() const { return resolution_; }
  std::size_t bytes() const { return near_.bytes() + surfaces_.capacity() * sizeof(Surface); }

 private:
  struct Near {
    std::int32_t own = -1;      ///< surface in this very cell
    std::int32_t surface = -1;  ///< nearest
    float squared = 1e9F;       ///< its distance [m^2]
    std::int32_t likelihood = 0;
  };
  int cell(double v) const { return static_cast<int>(std::floor(v * cells_per_metre_)); }
  void stamp(std::int32_t surface);

  double resolution_;
  double cells_per_metre_;
  int reach_;  ///< [cells]
  TiledGrid<Near> near_;
  std::vector<Surface> surfaces_;
};

}  // namespace bw::slam
