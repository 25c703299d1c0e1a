// A small net of two hidden layers: from where somebody was to where they will be, as normal distributions. It sees the
// person's own past alone: others in it did not carry over from drawn crowds to recorded ones (evidence.md). Pure; the same
// bytes on every call. All of it in the frame of the walk: origin at the last position, x along the last 0.8 s; so whoever
// is turned and moved is predicted the same, turned and moved (README.md 7.8).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "components/model/obstacles.hpp"

namespace bw::people {

inline constexpr double kPastStep = 0.4;   ///< [s] between the positions that the head sees
inline constexpr int kMostPast = 7;        ///< of those, the last one among them
inline constexpr int kLeastPast = 3;       ///< with fewer nothing is predicted
inline constexpr double kAheadStep = 0.5;  ///< [s]
inline constexpr int kAhead = 8;           ///< steps
inline constexpr int kHeadInputs = 3 * (kMostPast - 1) + 2;
inline constexpr int kPerStep =
    5;  ///< mean along, across; logarithms of both deviations; what the correlation is of
inline constexpr int kHeadOutputs = kPerStep * kAhead;

/// One layer: W x + b.
struct HeadLayer {
  Eigen::MatrixXd W;
  Eigen::VectorXd b;
};

/// Weights. Hidden layers are tanh, the last one is linear; inputs are used as (x - mean) / deviation.
struct HeadWeights {
  Eigen::VectorXd mean;
  Eigen::VectorXd deviation;
  std::vector<HeadLayer> layers;
};

/// Where the walk is, and how it goes: `velocity` [m/s] over the last 0.8 s, `along` its direction (x, while it stands still).
struct WalkFrame {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  Vector2 along{1.0, 0.0};

  /// `v` of the world as (along, across).
  Vector2 to_walk(const Vector2& v) const;
};

/// `past`: positions [m], the last one first, kPastStep apart; at least kLeastPast, and no more than kMostPast are used.
WalkFrame walk_frame(std::span<const Vector2> past);
/// What the net sees: of each step back velocity less speed along, velocity across, and 1 (0, 0, 0 where nothing is
/// remembered); the speed, and how much of standing it is.
Eigen::VectorXd head_inputs(std::span<const Vector2> past, const WalkFrame& frame);

/// [m] by which errors `t` [s] ahead are measured: 0.05 m and white acceleration of 0.2 m/s/sqrt(s), and 0.05 m/s.
double error_unit(double t);

/// What `outputs` of one step say, in the frame of the walk beside straight on.
struct StepNormal {
  Vector2 mean{0.0, 0.0};       ///< [m]
  Vector2 deviation{1.0, 1.0};  ///< [m]
  double correlation = 0.0;     ///< within kLargestCorrelation
};
inline constexpr double kLargestCorrelation = 0.95;
StepNormal step_normal(const double* outputs, double t);

/// kAhead positions, kAheadStep apart; nothing of a past that is too short or not finite, or if the net gives what is not
/// finite. `weights` must fit (kHeadInputs to kHeadOutputs).
std::optional<std::vector<PredictedPosition>> predict_by_head(const HeadWeights& weights,
                                                              std::span<const Vector2> past);

/// A column for each of `inputs`: the inputs as they are used, then what each layer gives; the outputs are the last.
std::vector<Eigen::MatrixXd> layer_values(const HeadWeights& weights, const Eigen::MatrixXd& inputs);

}  // namespace bw::people
