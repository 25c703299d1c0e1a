// Weights of a set, and drawing it anew.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "components/localization/particle_filter/particle_set.hpp"

namespace bw::localization {

/// weight[i] <- weight[i] exp(log_weight[i]) / sum, the largest taken out before so that nothing overflows.
/// False, and the weights stay, when nothing finite above zero comes out.
bool reweigh(std::vector<double>& weight, std::span<const double> log_weight);

/// 1 / sum of w^2: how many particles count (Kong, Liu and Wong 1994); `weight` sums to 1.
double effective_size(std::span<const double> weight);

/// Systematic resampling: which[k] is the particle that holds the point (u + k) / count of the running sum of
/// weights, u in [0, 1). Particle i is taken floor or ceil of count * weight[i] times. O(N + count).
void systematic_draw(std::span<const double> weight, std::size_t count, double u,
                     std::vector<std::size_t>& which);

/// result <- the particles `which`, with equal weights.
void take(const ParticleSet& particles, std::span<const std::size_t> which, ParticleSet& result);

/// Particles for which a set over `bins` bins differs from the true distribution by less than `error`
/// (Kullback-Leibler) with the probability whose normal quantile is z: Fox, "Adapting the Sample Size in
/// Particle Filters Through KLD-Sampling", 2003, equation 7.
double kld_bound(double bins, double error, double z);

}  // namespace bw::localization
