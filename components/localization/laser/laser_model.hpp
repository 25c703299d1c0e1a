// A laser sweep against a map: log weights for many poses at once, and how well one pose fits.
#pragma once

#include <span>

#include "components/localization/laser/beam_ends.hpp"
#include "components/localization/laser/likelihood_field.hpp"
#include "components/localization/particle_filter/particle_set.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::localization {

/// log_weight[i] += share * sum over beams of log p(end | particle i)
/// share = min(1, effective_beams / beams)
///
/// Beams of one sweep err together, and their plain product would be far too sure. `log_weight` is as long as
/// the set. A particle that is not finite gets what the corner of the map gives.
void add_log_weights(const LikelihoodField& field, const BeamEnds& ends, const ParticleSet& particles,
                     std::span<double> log_weight);

/// How well a sweep fits the map from one pose.
struct ScanFit {
  double hit = 0.0;    ///< mean of exp(-d^2 / (2 sigma_hit^2)) over the ends in the known part, 0 to 1
  double known = 0.0;  ///< share of the ends that lie in the known part, 0 to 1
  /// Share of all beams that went through an obstacle of the map, 0 to 1. People only shorten beams: where
  /// the pose is right this stays near 0 in any crowd.
  double through = 0.0;

  /// Of the beams that say anything of the map, those that agree with it: 0 to 1. Beams that end early, at
  /// people, count for neither. A good pose has 0.8 or more, a wrong one 0.1 to 0.7.
  double agreement() const { return hit < kLeastHit ? 0.0 : hit / (hit + through); }
  static constexpr double kLeastHit = 0.2;  ///< with fewer there is nothing to agree
};

/// Zeros without beams. Costs some 20 us with 60 beams: their paths through the map are followed.
ScanFit scan_fit(const LikelihoodField& field, const BeamEnds& ends, const Pose2& X_MB);

}  // namespace bw::localization
