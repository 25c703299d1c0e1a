// Which detection is which leg of whom, or which other cluster: all at once, for the least sum of
//
//   d^2 + ln det S - ln det S_0   (- unlike ln score, + on_static on background, for legs;
//                                  + people_first, for others)
//
// d: distance in standard deviations, S: spread of the prediction plus noise plus `slack`, S_0: the same of a
// prediction without error. Beyond the gate, and beyond min(reach, step + pace * seconds since it was seen), nothing is
// possible; leaving something unseen costs the gate.
#pragma once

#include <vector>

#include "components/people/tracker/assignment.hpp"
#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

/// Indices into the detections; -1: none.
struct LegMatch {
  int first = -1;
  int second = -1;
};

class Matching {
 public:
  void match(const std::vector<Detection>& detections, const std::vector<PersonTrack>& people,
             const std::vector<ClusterTrack>& clusters, double now, const AssociationOptions& options);

  const LegMatch& of_person(std::size_t i) const { return people_[i]; }
  int of_cluster(std::size_t i) const { return clusters_[i]; }
  bool taken(std::size_t detection) const { return taken_[detection] != 0; }

 private:
  Assignment assignment_;
  std::vector<LegMatch> people_;
  std::vector<int> clusters_;
  std::vector<char> taken_;
  std::vector<double> likeness_;  ///< -ln(score) of each detection
};

}  // namespace bw::people
