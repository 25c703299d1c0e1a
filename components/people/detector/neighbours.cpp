#include "components/people/detector/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

void meet(Neighbours& one, double distance, double width) {
  if (distance <= Neighbours::kAbout) ++one.about;
  if (distance < one.nearest) {
    one.second = one.nearest;
    one.nearest = distance;
    one.width = width;
  } else {
    one.second = std::min(one.second, distance);
  }
}

}  // namespace

const std::vector<Neighbours>& NeighbourSearch::find(const Beams& beams, const Clusters& clusters) {
  narrow_.clear();
  found_.assign(clusters.all.size(), {});
  for (std::size_t i = 0; i < clusters.all.size(); ++i) {
    const auto members = clusters.beams_of(clusters.all[i]);
    const Vector2& first = beams.points[static_cast<std::size_t>(members.front())];
    const Vector2& last = beams.points[static_cast<std::size_t>(members.back())];
    const double width = (last - first).norm();
    if (width <= Neighbours::kWidest) narrow_.push_back({(first + last) / 2.0, width, i});
  }
  std::ranges::sort(narrow_, [](const Narrow& a, const Narrow& b) {
    return a.middle.x() != b.middle.x() ? a.middle.x() < b.middle.x() : a.cluster < b.cluster;
  });
  for (std::size_t a = 0; a < narrow_.size(); ++a) {
    for (std::size_t b = a + 1; b < narrow_.size(); ++b) {
      if (narrow_[b].middle.x() - narrow_[a].middle.x() >= Neighbours::kFarthest) break;
      const double distance = (narrow_[b].middle - narrow_[a].middle).norm();
      if (distance >= Neighbours::kFarthest) continue;
      meet(found_[narrow_[a].cluster], distance, narrow_[b].width);
      meet(found_[narrow_[b].cluster], distance, narrow_[a].width);
    }
  }
  return found_;
}

}  // namespace bw::people
