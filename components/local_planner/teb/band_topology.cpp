#include "components/local_planner/teb/band_topology.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace bw::teb {

homotopy::Route route_of(const Band& band) {
  homotopy::Route route;
  route.reserve(band.size());
  double time = 0.0;
  for (const BandPose& pose : band.poses) {
    route.push_back({pose.position(), time});
    time += pose.dt;
  }
  return route;
}

std::vector<Pose2> path_of(const homotopy::Route& route, const Pose2& goal) {
  std::vector<Pose2> path;
  for (const homotopy::RoutePoint& point : route)
    path.push_back({point.position.x(), point.position.y(), 0.0});
  path.back() = goal;
  return path;
}

void merge_classes(std::vector<BandCandidate>& candidates, const homotopy::Exploration& explored,
                   const homotopy::HomotopyOptions& options) {
  std::vector<BandCandidate> distinct;
  std::vector<homotopy::Signature> signatures;
  for (BandCandidate& candidate : candidates) {
    if (!candidate.report.usable) continue;
    homotopy::Signature signature =
        homotopy::signature_of(route_of(candidate.band), explored.bodies, explored.course, options);
    const auto same = std::find_if(signatures.begin(), signatures.end(), [&](const homotopy::Signature& s) {
      return homotopy::same_class(s, signature, options);
    });
    if (same == signatures.end()) {
      signatures.push_back(std::move(signature));
      distinct.push_back(std::move(candidate));
      continue;
    }
    BandCandidate& known = distinct[static_cast<std::size_t>(same - signatures.begin())];
    const bool driven = known.driven || candidate.driven;
    const auto rank = [](const BandCandidate& c) {
      return std::tuple(!c.safety.free, !c.report.finished, c.cost);
    };
    if (rank(candidate) < rank(known)) known = std::move(candidate);
    known.driven = driven;
  }
  if (!distinct.empty()) candidates = std::move(distinct);
}

}  // namespace bw::teb
