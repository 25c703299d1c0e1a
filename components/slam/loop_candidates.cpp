#include "components/slam/loop_candidates.hpp"

#include <algorithm>
#include <cmath>

namespace bw::slam {
namespace {

constexpr std::size_t kOverlapping = 3;  // [submaps] along the drive
constexpr std::size_t kMostCandidates = 6;
constexpr double kAllRound = 0.2;
constexpr std::size_t kMostFar = 32;

}  // namespace

bool overlap(std::size_t earlier, std::size_t later, std::span<const Submap> submaps) {
  if (later - earlier >= kOverlapping) return false;
  for (; later > earlier; --later)
    if (submaps[later].found_in) return false;
  return true;
}

std::vector<std::size_t> loop_candidates(std::span<const Submap> submaps,
                                         std::span<const UncertainPose> others, double reach,
                                         std::size_t& turn) {
  const std::size_t later = submaps.size() - 1;
  struct Candidate {
    std::size_t submap = 0;
    double distance = 0.0;  // [m], or in standard deviations
  };
  std::vector<Candidate> near;
  std::vector<Candidate> far;
  for (std::size_t j = 0; j < later; ++j) {
    if (submaps[j].marginalised || overlap(j, later, submaps)) continue;
    const double sigma = std::sqrt(others[j].covariance.topLeftCorner<2, 2>().trace());
    const double distance = (others[j].X * submaps[j].centre - submaps[later].centre).norm();
    if (distance - 3.0 * sigma > reach) continue;
    if (3.0 * sigma <= kWide)
      near.push_back({j, distance});
    else if (submaps[later].all_round > kAllRound && submaps[j].all_round > kAllRound)
      far.push_back({j, std::max(0.0, distance - reach) / sigma});
  }
  const auto nearer = [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.submap < b.submap;
  };
  std::sort(near.begin(), near.end(), nearer);
  if (near.size() > kMostCandidates) near.resize(kMostCandidates);
  std::vector<std::size_t> chosen;
  for (const Candidate& candidate : near) chosen.push_back(candidate.submap);
  // Of many, some each time, so that all have their turn.
  std::sort(far.begin(), far.end(), nearer);
  for (std::size_t k = 0; k < std::min(far.size(), kMostFar); ++k)
    chosen.push_back(far[turn++ % far.size()].submap);
  return chosen;
}

}  // namespace bw::slam
