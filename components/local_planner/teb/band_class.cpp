#include "components/local_planner/teb/band_class.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::teb {
namespace {

constexpr double kWaitingStep = 0.5;  // [s] at the goal, where only the mover moves

double turning(const Vector2& from, const Vector2& to) { return std::atan2(cross(from, to), from.dot(to)); }

}  // namespace

std::vector<double> winding(const Band& band, const std::vector<Vector2>& fixed,
                            const std::vector<Mover>& movers, double horizon) {
  std::vector<double> sums;
  sums.reserve(fixed.size() + movers.size());
  for (const Vector2& obstacle : fixed) {
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < band.size(); ++k) {
      sum += turning(band.poses[k].position() - obstacle, band.poses[k + 1].position() - obstacle);
    }
    sums.push_back(sum);
  }
  for (const Mover& mover : movers) {
    double sum = 0.0;
    double time = 0.0;
    Vector2 seen = band.poses.front().position() - mover.position_at(0.0);
    const auto move_to = [&](const Vector2& position, double then) {
      const Vector2 next = position - mover.position_at(then);
      sum += turning(seen, next);
      seen = next;
      time = then;
    };
    for (std::size_t k = 0; k + 1 < band.size(); ++k) {
      move_to(band.poses[k + 1].position(), time + band.poses[k].dt);
    }
    while (time < horizon) move_to(band.poses.back().position(), std::min(time + kWaitingStep, horizon));
    sums.push_back(sum);
  }
  return sums;
}

bool same_class(const std::vector<double>& a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) > std::numbers::pi) return false;
  }
  return true;
}

}  // namespace bw::teb
