#include "components/people/tracker/heading_track.hpp"

#include <vector>

namespace bw::people {
namespace {

constexpr double kLeastApart =
    0.001;  // [s]; two sensors may sweep at once, and say nothing of a velocity then

struct TimedPosition {
  double time;
  SeenPosition position;
};

Eigen::Matrix2d beyond(const HeadingOptions& options) {
  return options.position_noise * options.position_noise * Eigen::Matrix2d::Identity();
}

/// Half way between two legs in the sweeps that showed both, oldest first.
std::vector<TimedPosition> middles(const ClusterTrack& a, const ClusterTrack& b,
                                   const HeadingOptions& options) {
  std::vector<TimedPosition> seen;
  for (int i = a.remembered() - 1; i >= 0; --i) {
    for (int j = b.remembered() - 1; j >= 0; --j) {
      const Sighting& first = a.sighting(i);
      const Sighting& second = b.sighting(j);
      if (first.sweep != second.sweep) continue;
      if (!seen.empty() && first.time - seen.back().time < kLeastApart) continue;
      const double variance = (first.variance + second.variance) / 4.0;
      seen.push_back({first.time,
                      {(first.position + second.position) / 2.0,
                       variance * Eigen::Matrix2d::Identity() + beyond(options)}});
    }
  }
  return seen;
}

}  // namespace

std::optional<SeenPosition> seen_middle(const SeenLegs& seen, const Walker& expected,
                                        const HeadingOptions& options) {
  if (seen.first != nullptr && seen.second != nullptr)
    return SeenPosition{(seen.first->position + seen.second->position) / 2.0,
                        (seen.first->covariance + seen.second->covariance) / 4.0 + beyond(options)};
  const Detection* one = seen.first != nullptr ? seen.first : seen.second;
  if (one == nullptr) return std::nullopt;
  if (one->body_score > one->leg_score)  // both legs in one
    return SeenPosition{one->position, one->covariance + beyond(options)};
  const double side = one == seen.first ? 1.0 : -1.0;
  // Both legs lie as far from the middle, on either side: their spreads share what is not the middle's.
  const Eigen::Matrix2d swing =
      (expected.spread(BodyPart::first_leg) + expected.spread(BodyPart::second_leg)) / 2.0 -
      expected.spread(BodyPart::middle);
  return SeenPosition{one->position - side * expected.to_first_leg(),
                      one->covariance + swing + beyond(options)};
}

HeadingFilter heading_of(const ClusterTrack& first, const ClusterTrack* second, const Walker& walker,
                         const HeadingOptions& options) {
  std::vector<TimedPosition> seen;
  if (second != nullptr) seen = middles(first, *second, options);
  if (seen.size() < 2) {
    Eigen::Vector4d motion;
    motion << walker.position(), walker.velocity();
    return {motion, walker.covariance(), options};
  }
  HeadingFilter filter(seen[0].position, seen[1].position, seen[1].time - seen[0].time, options);
  for (std::size_t k = 2; k < seen.size(); ++k) {
    filter.predict(seen[k].time - seen[k - 1].time, options);
    filter.correct(seen[k].position, options);
  }
  return filter;
}

}  // namespace bw::people
