// Neighbouring beams that end near each other: jump-distance segmentation (Arras et al., ICRA 2007), with a
// threshold that grows with the distance between beams, and a lower one where background meets foreground.
#pragma once

#include <span>
#include <vector>

#include "components/people/detector/beams.hpp"
#include "components/people/detector/detector_options.hpp"

namespace bw::people {

/// What lies just beyond one end of a cluster.
struct ClusterEdge {
  bool occluded =
      false;          ///< something nearer, an unusable beam or the end of the field of view: it may go on
  double jump = 0.0;  ///< how much farther the neighbouring beam sees [m]; 0 when it is unusable
};

struct Cluster {
  int first = 0;  ///< into Clusters::members
  int count = 0;
  ClusterEdge right;  ///< before the first beam
  ClusterEdge left;   ///< after the last beam
};

struct Clusters {
  std::vector<int> members;  ///< beams of all clusters, by rising angle within each
  std::vector<Cluster> all;

  std::span<const int> beams_of(const Cluster& cluster) const {
    return {members.data() + cluster.first, static_cast<std::size_t>(cluster.count)};
  }
};

/// `is_background` holds a flag for every beam. Fills `clusters`, keeping its memory.
void find_clusters(const Beams& beams, const std::vector<std::uint8_t>& is_background,
                   const ClusterOptions& options, Clusters& clusters);

}  // namespace bw::people
