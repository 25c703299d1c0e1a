// Fits the learned prediction head: samples of drawn crowds, their negative log-likelihood with its gradient, and Adam. One
// thread, fixed order, from seeds: the same bytes each time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/people/prediction/learned_head.hpp"

namespace bw::people {

/// One person at one instant.
struct WalkSample {
  Eigen::VectorXd inputs;                ///< of the past as a tracker sees it (head_inputs)
  std::array<Vector2, kAhead> errors{};  ///< [m] of going straight on, in the frame of the walk
};

/// Of crowds with seeds `first`, ...: 30 s each, every fourth of each person's instants, positions with 0.01 to 0.05 m of
/// noise, a fifth with a past cut short.
std::vector<WalkSample> walk_samples(std::uint64_t first, int crowds);

/// Negative log-likelihood [nats] of `error` under one step's outputs, `t` [s] ahead; `gradient` (kPerStep) by the outputs
/// unless null.
double step_loss(const double* outputs, const Vector2& error, double t, double* gradient);

/// Mean over `samples`, of each step.
std::array<double, kAhead> losses(const HeadWeights& weights, const std::vector<WalkSample>& samples);

/// Mean loss of `samples`, and its gradient by the weights of all layers, unless null.
double batch_loss(const HeadWeights& weights, const std::vector<const WalkSample*>& samples,
                  std::vector<HeadLayer>* gradient);

struct FitOptions {
  int hidden = 32;  ///< in each of two layers
  int epochs = 10;
  std::uint64_t seed = 1;
};

HeadWeights fit_head(const std::vector<WalkSample>& samples, const FitOptions& options);

}  // namespace bw::people
