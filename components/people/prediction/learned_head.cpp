#include "components/people/prediction/learned_head.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

constexpr double kStanding = 0.2;  // [m/s]

}  // namespace

Vector2 WalkFrame::to_walk(const Vector2& v) const { return {along.dot(v), cross(along, v)}; }

WalkFrame walk_frame(std::span<const Vector2> past) {
  WalkFrame frame{.position = past[0], .velocity = (past[0] - past[2]) / (2.0 * kPastStep)};
  if (const double speed = frame.velocity.norm(); speed > 0.0) frame.along = frame.velocity / speed;
  return frame;
}

Eigen::VectorXd head_inputs(std::span<const Vector2> past, const WalkFrame& frame) {
  Eigen::VectorXd inputs = Eigen::VectorXd::Zero(kHeadInputs);
  const double speed = frame.velocity.norm();
  const auto steps = std::min<std::size_t>(past.size(), kMostPast) - 1;
  for (std::size_t k = 0; k < steps; ++k) {
    const Vector2 velocity = frame.to_walk((past[k] - past[k + 1]) / kPastStep);
    inputs.segment<3>(static_cast<Eigen::Index>(3 * k)) << velocity.x() - speed, velocity.y(), 1.0;
  }
  inputs.tail<2>() << speed, std::exp(-speed / kStanding);
  return inputs;
}

double error_unit(double t) { return std::sqrt(0.0025 + 0.0025 * t * t + 0.04 * t * t * t / 3.0); }

StepNormal step_normal(const double* outputs, double t) {
  const double unit = error_unit(t);
  return {.mean = unit * Vector2(outputs[0], outputs[1]),
          .deviation = unit * Vector2(std::exp(outputs[2]), std::exp(outputs[3])),
          .correlation = kLargestCorrelation * std::tanh(outputs[4])};
}

std::vector<Eigen::MatrixXd> layer_values(const HeadWeights& weights, const Eigen::MatrixXd& inputs) {
  std::vector<Eigen::MatrixXd> values{
      ((inputs.colwise() - weights.mean).array().colwise() / weights.deviation.array()).matrix()};
  for (std::size_t l = 0; l < weights.layers.size(); ++l) {
    const HeadLayer& layer = weights.layers[l];
    Eigen::MatrixXd next = (layer.W * values.back()).colwise() + layer.b;
    if (l + 1 < weights.layers.size()) next = next.array().tanh().matrix();
    values.push_back(std::move(next));
  }
  return values;
}

std::optional<std::vector<PredictedPosition>> predict_by_head(const HeadWeights& weights,
                                                              std::span<const Vector2> past) {
  if (past.size() < kLeastPast) return std::nullopt;
  const WalkFrame frame = walk_frame(past);
  const Eigen::MatrixXd outputs = layer_values(weights, head_inputs(past, frame)).back();
  if (!outputs.allFinite()) return std::nullopt;
  Eigen::Matrix2d R;
  R << frame.along.x(), -frame.along.y(), frame.along.y(), frame.along.x();
  std::vector<PredictedPosition> predictions;
  for (int k = 0; k < kAhead; ++k) {
    const double t = (k + 1) * kAheadStep;
    const StepNormal normal = step_normal(outputs.data() + k * kPerStep, t);
    const Eigen::Matrix2d D = normal.deviation.asDiagonal();
    Eigen::Matrix2d C;
    C << 1.0, normal.correlation, normal.correlation, 1.0;
    C = (R * D * C * D * R.transpose()).eval();
    const Vector2 mean = frame.position + t * frame.velocity + R * normal.mean;
    if (!mean.allFinite() || !C.allFinite()) return std::nullopt;
    predictions.push_back({t, mean, 0.5 * (C + C.transpose())});
  }
  return predictions;
}

}  // namespace bw::people
