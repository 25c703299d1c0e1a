#include "components/people/detector/clusters.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

class Segmentation {
 public:
  Segmentation(const Beams& beams, const std::vector<std::uint8_t>& is_background,
               const ClusterOptions& options)
      : beams_(beams), is_background_(is_background), options_(options) {}

  bool usable(int i) const {
    const auto beam = static_cast<std::size_t>(i);
    return beams_.kinds[beam] == BeamKind::hit && beams_.ranges[beam] <= options_.max_range;
  }

  /// Whether two hits with `steps` beams from one to the other are parts of one thing.
  bool joined(int i, int j, int steps) const {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(j);
    const double range = std::min(beams_.ranges[a], beams_.ranges[b]);
    const double jump = is_background_[a] == is_background_[b] ? options_.kJump : options_.kEdgeJump;
    const double limit = jump + options_.growth * steps * beams_.angle_increment * range;
    return (beams_.points[a] - beams_.points[b]).squaredNorm() <= limit * limit;
  }

  /// The next hit after beam i that belongs with it, or -1.
  int successor(int i) const {
    int j = i;
    for (int steps = 1; steps <= options_.kBridge + 1; ++steps) {
      j = beams_.next(j);
      if (j < 0 || j == i) return -1;
      if (usable(j)) return joined(i, j, steps) ? j : -1;
      if (beams_.kinds[static_cast<std::size_t>(j)] != BeamKind::unknown) return -1;
    }
    return -1;
  }

  ClusterEdge edge(int inside, int outside) const {
    if (outside < 0 || beams_.kinds[static_cast<std::size_t>(outside)] == BeamKind::unknown)
      return {true, 0.0};
    const double jump = static_cast<double>(beams_.ranges[static_cast<std::size_t>(outside)]) -
                        beams_.ranges[static_cast<std::size_t>(inside)];
    return {jump < 0.0, jump};
  }

 private:
  const Beams& beams_;
  const std::vector<std::uint8_t>& is_background_;
  const ClusterOptions& options_;
};

/// A beam that starts a cluster, so that none runs across the seam of a sweep that goes all round.
int first_start(const Beams& beams, const Segmentation& segmentation) {
  if (!beams.closed) return 0;
  for (int i = beams.size() - 1; i >= 0; --i) {
    if (segmentation.usable(i) && segmentation.successor(i) < 0) return beams.next(i);
  }
  return 0;
}

}  // namespace

void find_clusters(const Beams& beams, const std::vector<std::uint8_t>& is_background,
                   const ClusterOptions& options, Clusters& clusters) {
  clusters.members.clear();
  clusters.all.clear();
  const Segmentation segmentation(beams, is_background, options);
  const int count = beams.size();
  const int start = first_start(beams, segmentation);
  int done = 0;
  while (done < count) {
    int beam = (start + done) % count;
    ++done;
    if (!segmentation.usable(beam)) continue;
    Cluster cluster{static_cast<int>(clusters.members.size()), 0, {}, {}};
    const int right_end = beam;
    for (;;) {
      clusters.members.push_back(beam);
      ++cluster.count;
      const int next = segmentation.successor(beam);
      const int steps = next < 0 ? 0 : (next - beam + count) % count;
      if (next < 0 || done + steps > count) break;
      done += steps;
      beam = next;
    }
    if (cluster.count < options.min_points) {
      clusters.members.resize(static_cast<std::size_t>(cluster.first));
      continue;
    }
    cluster.right = segmentation.edge(right_end, beams.previous(right_end));
    cluster.left = segmentation.edge(beam, beams.next(beam));
    clusters.all.push_back(cluster);
  }
}

}  // namespace bw::people
