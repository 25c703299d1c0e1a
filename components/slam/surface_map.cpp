#include "components/slam/surface_map.hpp"

#include <cmath>

namespace bw::slam {
namespace {

constexpr int kMostHits = 50;     // of which the mean is; more would hold on to what has moved
constexpr float kMoved = 0.004F;  // [m] a surface that moved by less is not spread again

std::int32_t likelihood_at(float squared) {
  constexpr float kInverse = 1.0F / static_cast<float>(2.0 * SurfaceMap::kSpread * SurfaceMap::kSpread);
  return static_cast<std::int32_t>(255.0F * std::exp(-squared * kInverse) + 0.5F);
}

}  // namespace

SurfaceMap::SurfaceMap(double resolution)
    : resolution_(resolution),
      cells_per_metre_(1.0 / resolution),
      reach_(static_cast<int>(std::ceil(kReach / resolution))) {}

SurfaceMap::SurfaceMap(double resolution, std::span<const Surface> surfaces) : SurfaceMap(resolution) {
  surfaces_.assign(surfaces.begin(), surfaces.end());
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    near_.ref(cell(static_cast<double>(surfaces_[i].x)), cell(static_cast<double>(surfaces_[i].y))).own =
        static_cast<std::int32_t>(i);
    stamp(static_cast<std::int32_t>(i));
  }
}

SurfaceMap::SurfaceMap(double resolution, const State& state) : SurfaceMap(resolution) {
  surfaces_ = state.surfaces;
  for (std::size_t k = 0; k < state.own.size(); ++k)
    near_.ref(state.own[k].i, state.own[k].j).own = static_cast<std::int32_t>(k);
  for (const State::Near& known : state.near) {
    Near& near = near_.ref(known.i, known.j);
    near.surface = known.surface;
    near.squared = known.squared;
    near.likelihood = likelihood_at(known.squared);
  }
}

SurfaceMap::State SurfaceMap::state() const {
  State state;
  state.surfaces = surfaces_;
  state.own.resize(surfaces_.size());
  near_.for_each([&](int i, int j, const Near& near) {
    if (near.own >= 0) state.own[static_cast<std::size_t>(near.own)] = {i, j};
    if (near.surface >= 0) state.near.push_back({i, j, near.surface, near.squared});
  });
  return state;
}

void SurfaceMap::insert(std::span<const SurfacePoint> points, const Pose2& X_SB) {
  const auto c2 = static_cast<float>(std::cos(2.0 * X_SB.theta));
  const auto s2 = static_cast<float>(std::sin(2.0 * X_SB.theta));
  for (const SurfacePoint& point : points) {
    const Vector2 at = X_SB * point.position();
    const SurfacePoint turned{static_cast<float>(at.x()), static_cast<float>(at.y()),
                              c2 * point.normal_cos2 - s2 * point.normal_sin2,
                              s2 * point.normal_cos2 + c2 * point.normal_sin2};
    std::int32_t& own = near_.ref(cell(at.x()), cell(at.y())).own;
    if (own < 0) {
      own = static_cast<std::int32_t>(surfaces_.size());
      surfaces_.push_back({turned.x, turned.y, turned.normal_cos2, turned.normal_sin2, 1});
      stamp(own);
      continue;
    }
    Surface& surface = surfaces_[static_cast<std::size_t>(own)];
    const float share = 1.0F / static_cast<float>(std::min(surface.hits + 1, kMostHits));
    const float dx = share * (turned.x - surface.x);
    const float dy = share * (turned.y - surface.y);
    surface.x += dx;
    surface.y += dy;
    surface.normal_cos2 += share * (turned.normal_cos2 - surface.normal_cos2);
    surface.normal_sin2 += share * (turned.normal_sin2 - surface.normal_sin2);
    ++surface.hits;
    if (std::abs(dx) + std::abs(dy) > kMoved) stamp(own);
  }
}

void SurfaceMap::stamp(std::int32_t index) {
  const Surface& surface = surfaces_[static_cast<std::size_t>(index)];
  const int i0 = cell(static_cast<double>(surface.x));
  const int j0 = cell(static_cast<double>(surface.y));
  for (int j = j0 - reach_; j <= j0 + reach_; ++j) {
    const float dy = static_cast<float>((j + 0.5) * resolution_) - surface.y;
    for (int i = i0 - reach_; i <= i0 + reach_; ++i) {
      const float dx = static_cast<float>((i + 0.5) * resolution_) - surface.x;
      const float squared = dx * dx + dy * dy;
      if (squared > static_cast<float>(kReach * kReach)) continue;
      Near& near = near_.ref(i, j);
      if (near.surface != index && squared >= near.squared) continue;
      near.surface = index;
      near.squared = squared;
      near.likelihood = likelihood_at(squared);
    }
  }
}

}  // namespace bw::slam
