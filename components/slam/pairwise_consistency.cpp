#include "components/slam/pairwise_consistency.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace bw::slam {
namespace {

constexpr double kConsistent = 11.3;   // chi^2 of three degrees of freedom, 99 %
constexpr double kSure = 0.5;          // [m] a search so narrow needs no second loop
constexpr std::size_t kSupport = 3;    // loops that agree
constexpr std::size_t kFarApart = 10;  // [submaps] the way between them says nothing any more

// Pose of submap b in submap a along the drive. Where a map was continued the drive has a fork.
UncertainPose along_drive(std::size_t a, std::size_t b, std::span<const Submap> submaps) {
  if (a > b) return inverse(along_drive(b, a, submaps));
  std::vector<std::size_t> way;
  UncertainPose from_a;  // of the fork, in a
  while (a != b) {
    if (b > a) {
      way.push_back(b);
      b = submaps[b].parent(b);
    } else {
      from_a = from_a * inverse(submaps[a].X_PS);
      a = submaps[a].parent(a);
    }
  }
  for (auto k = way.rbegin(); k != way.rend(); ++k) from_a = from_a * submaps[*k].X_PS;
  return from_a;
}

// Submaps on that way, as far as it matters.
std::size_t apart(std::size_t a, std::size_t b, std::span<const Submap> submaps) {
  std::size_t steps = 0;
  for (; a != b && steps <= kFarApart; ++steps) {
    std::size_t& later = a > b ? a : b;
    later = submaps[later].parent(later);
  }
  return steps;
}

}  // namespace

double inconsistency(const Loop& a, const Loop& b, std::span<const Submap> submaps) {
  if (apart(a.edge.from, b.edge.from, submaps) > kFarApart ||
      apart(a.edge.to, b.edge.to, submaps) > kFarApart)
    return std::numeric_limits<double>::infinity();
  const UncertainPose by_a = a.edge.X * along_drive(a.edge.to, b.edge.to, submaps);
  const UncertainPose by_b = along_drive(a.edge.from, b.edge.from, submaps) * b.edge.X;
  return squared_distance(by_a, by_b);
}

std::vector<std::size_t> supporters(std::size_t with, std::span<const Loop> loops,
                                    std::span<const Submap> submaps) {
  struct Rival {
    std::size_t loop = 0;
    double distance = 0.0;
  };
  std::vector<Rival> rivals;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (i == with || (loops[i].edge.from == loops[with].edge.from && loops[i].edge.to == loops[with].edge.to))
      continue;
    const double distance = inconsistency(loops[with], loops[i], submaps);
    if (distance <= kConsistent) rivals.push_back({i, distance});
  }
  std::sort(rivals.begin(), rivals.end(), [](const Rival& a, const Rival& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.loop < b.loop;
  });
  std::vector<std::size_t> clique{with};
  for (const Rival& rival : rivals) {
    const bool agrees = std::all_of(clique.begin() + 1, clique.end(), [&](std::size_t other) {
      return inconsistency(loops[other], loops[rival.loop], submaps) <= kConsistent;
    });
    if (agrees) clique.push_back(rival.loop);
  }
  return clique;
}

std::vector<bool> believed(std::span<const Loop> loops, std::span<const Submap> submaps) {
  std::vector<bool> result(loops.size(), false);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (result[i]) continue;
    result[i] = loops[i].window <= kSure;
    if (result[i]) continue;
    const std::vector<std::size_t> clique = supporters(i, loops, submaps);
    if (clique.size() < kSupport) continue;
    for (const std::size_t k : clique) result[k] = true;
  }
  return result;
}

}  // namespace bw::slam
