#include "components/lab/report/thin_line.hpp"

#include <algorithm>
#include <utility>

namespace bw {
namespace {

double distance(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 along = b - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + share * along - p).norm();
}

}  // namespace

std::vector<Vector2> thin_line(const std::vector<Vector2>& points, double tolerance) {
  std::vector<Vector2> sound;
  for (const Vector2& p : points) {
    if (p.allFinite()) sound.push_back(p);
  }
  if (sound.size() < 3) return sound;
  std::vector<bool> kept(sound.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, sound.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance(sound[i], sound[first], sound[last]);
      if (off <= most) continue;
      most = off;
      farthest = i;
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<Vector2> thinned;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    if (kept[i]) thinned.push_back(sound[i]);
  }
  return thinned;
}

std::vector<Vector2> thin_dots(const std::vector<Vector2>& points, double apart) {
  std::vector<Vector2> kept;
  for (const Vector2& p : points) {
    if (p.allFinite() && (kept.empty() || (p - kept.back()).norm() >= apart)) kept.push_back(p);
  }
  return kept;
}

}  // namespace bw
