#include "components/lab/people_training/prediction_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "components/lab/people_training/prediction_crowd.hpp"
#include "components/model/random.hpp"

namespace bw::people {
namespace {

constexpr double kSeconds = 30.0;
constexpr int kEvery = 4;  // instants of a person, kPastStep apart
constexpr std::size_t kBatch = 256;
constexpr double kRate = 1e-3;     // of Adam, falling to 0 by half a cosine
constexpr double kDecay = 1e-3;    // of weights
constexpr double kSteepest = 5.0;  // of one output of one sample: beyond it the gradient is cut
constexpr double kFirst = 0.9;     // memory of Adam's mean and square
constexpr double kSecond = 0.999;

const int kPastRows = static_cast<int>(std::lround(kPastStep / kCrowdStep));
const int kAheadRows = static_cast<int>(std::lround(kAheadStep / kCrowdStep));

void add_samples(std::uint64_t seed, std::vector<WalkSample>& samples) {
  const std::vector<std::vector<Vector2>> crowd = draw_crowd(seed, kSeconds);
  Random random(seed ^ 0x9E3779B97F4A7C15ULL);
  const double noise = random.uniform(0.01, 0.05);
  std::vector<std::vector<Vector2>> seen;
  for (const auto& row : crowd) {
    std::vector<Vector2>& now = seen.emplace_back();
    for (const Vector2& position : row) {
      const double x = random.normal();
      const double y = random.normal();
      now.push_back(position + noise * Vector2(x, y));
    }
  }
  const int rows = static_cast<int>(crowd.size());
  for (int k = kPastRows * (kMostPast - 1); k + kAhead * kAheadRows < rows; k += kPastRows) {
    for (std::size_t i = 0; i < crowd[0].size(); ++i) {
      if ((k / kPastRows + static_cast<int>(i)) % kEvery != 0) continue;
      int known = kMostPast;
      if (random.uniform() < 0.2)
        known = kLeastPast + static_cast<int>(random.bits() % (kMostPast - kLeastPast));
      std::vector<Vector2> past;
      for (int n = 0; n < known; ++n) past.push_back(seen[static_cast<std::size_t>(k - n * kPastRows)][i]);
      const WalkFrame frame = walk_frame(past);
      WalkSample& sample = samples.emplace_back();
      sample.inputs = head_inputs(past, frame);
      for (int n = 0; n < kAhead; ++n) {
        const Vector2& truth = crowd[static_cast<std::size_t>(k + (n + 1) * kAheadRows)][i];
        const double t = (n + 1) * kAheadStep;
        sample.errors[static_cast<std::size_t>(n)] =
            frame.to_walk(truth - frame.position - t * frame.velocity);
      }
    }
  }
}

HeadWeights first_weights(const std::vector<WalkSample>& samples, int hidden, Random& random) {
  HeadWeights weights;
  const auto count = static_cast<double>(samples.size());
  weights.mean = Eigen::VectorXd::Zero(kHeadInputs);
  Eigen::VectorXd square = Eigen::VectorXd::Zero(kHeadInputs);
  for (const WalkSample& sample : samples) weights.mean += sample.inputs / count;
  for (const WalkSample& sample : samples) square += (sample.inputs - weights.mean).cwiseAbs2() / count;
  weights.deviation = square.cwiseSqrt().array() + 1e-3;
  const std::array<int, 4> sizes{kHeadInputs, hidden, hidden, kHeadOutputs};
  for (std::size_t l = 0; l + 1 < sizes.size(); ++l) {
    const double spread = std::sqrt(1.0 / sizes[l]) * (l + 2 == sizes.size() ? 0.05 : 1.0);
    HeadLayer layer{Eigen::MatrixXd(sizes[l + 1], sizes[l]), Eigen::VectorXd::Zero(sizes[l + 1])};
    for (double& weight : layer.W.reshaped()) weight = spread * random.normal();
    weights.layers.push_back(std::move(layer));
  }
  return weights;
}

Eigen::MatrixXd inputs_of(const std::vector<const WalkSample*>& samples) {
  Eigen::MatrixXd inputs(kHeadInputs, static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    inputs.col(static_cast<Eigen::Index>(i)) = samples[i]->inputs;
  return inputs;
}

/// Adam over one matrix or vector.
template <class M>
struct Adam {
  M mean;
  M square;

  void step(M& values, const M& gradient, double rate, double decay, int n) {
    if (mean.size() == 0) mean = square = M::Zero(values.rows(), values.cols());
    mean = kFirst * mean + (1.0 - kFirst) * gradient;
    square = kSecond * square + (1.0 - kSecond) * gradient.cwiseAbs2();
    const double by_mean = 1.0 - std::pow(kFirst, n);
    const double by_square = 1.0 - std::pow(kSecond, n);
    values.array() -= rate * (mean.array() / by_mean) / ((square.array() / by_square).sqrt() + 1e-8);
    values *= 1.0 - rate * decay;
  }
};

}  // namespace

std::vector<WalkSample> walk_samples(std::uint64_t first, int crowds) {
  std::vector<WalkSample> samples;
  for (int i = 0; i < crowds; ++i) add_samples(first + static_cast<std::uint64_t>(i), samples);
  return samples;
}

double step_loss(const double* outputs, const Vector2& error, double t, double* gradient) {
  const StepNormal normal = step_normal(outputs, t);
  const double rho = normal.correlation;
  const double rest = 1.0 - rho * rho;
  const Vector2 z = (error - normal.mean).cwiseQuotient(normal.deviation);
  const double distance = (z.squaredNorm() - 2.0 * rho * z.x() * z.y()) / rest;
  if (gradient != nullptr) {
    const Vector2 by_z((z.x() - rho * z.y()) / rest, (z.y() - rho * z.x()) / rest);
    const double unit = error_unit(t);
    gradient[0] = -by_z.x() * unit / normal.deviation.x();
    gradient[1] = -by_z.y() * unit / normal.deviation.y();
    gradient[2] = 1.0 - by_z.x() * z.x();
    gradient[3] = 1.0 - by_z.y() * z.y();
    const double by_rho = (-rho - z.x() * z.y() + rho * distance) / rest;
    gradient[4] = by_rho * (kLargestCorrelation - rho * rho / kLargestCorrelation);
  }
  return std::log(2.0 * std::numbers::pi) + std::log(normal.deviation.prod()) + 0.5 * std::log(rest) +
         0.5 * distance;
}

std::array<double, kAhead> losses(const HeadWeights& weights, const std::vector<WalkSample>& samples) {
  std::array<double, kAhead> sums{};
  for (const WalkSample& sample : samples) {
    const Eigen::MatrixXd outputs = layer_values(weights, sample.inputs).back();
    for (std::size_t k = 0; k < kAhead; ++k)
      sums[k] += step_loss(outputs.data() + k * kPerStep, sample.errors[k],
                           (static_cast<double>(k) + 1.0) * kAheadStep, nullptr);
  }
  for (double& sum : sums) sum /= static_cast<double>(samples.size());
  return sums;
}

double batch_loss(const HeadWeights& weights, const std::vector<const WalkSample*>& samples,
                  std::vector<HeadLayer>* gradient) {
  const std::vector<Eigen::MatrixXd> values = layer_values(weights, inputs_of(samples));
  Eigen::MatrixXd slope(kHeadOutputs, values.back().cols());
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    for (int k = 0; k < kAhead; ++k)
      sum += step_loss(values.back().col(column).data() + k * kPerStep,
                       samples[i]->errors[static_cast<std::size_t>(k)], (k + 1) * kAheadStep,
                       slope.col(column).data() + k * kPerStep);
  }
  const double count = static_cast<double>(samples.size()) * kAhead;
  if (gradient != nullptr) {
    slope = slope.cwiseMax(-kSteepest).cwiseMin(kSteepest) / count;
    gradient->resize(weights.layers.size());
    for (std::size_t l = weights.layers.size(); l-- > 0;) {
      (*gradient)[l] = {slope * values[l].transpose(), slope.rowwise().sum()};
      if (l > 0)
        slope =
            ((weights.layers[l].W.transpose() * slope).array() * (1.0 - values[l].array().square())).matrix();
    }
  }
  return sum / count;
}

HeadWeights fit_head(const std::vector<WalkSample>& samples, const FitOptions& options) {
  Random random(options.seed);
  HeadWeights weights = first_weights(samples, options.hidden, random);
  std::vector<Adam<Eigen::MatrixXd>> matrices(weights.layers.size());
  std::vector<Adam<Eigen::VectorXd>> offsets(weights.layers.size());
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::size_t batches = samples.size() / kBatch;
  const double steps = static_cast<double>(batches) * options.epochs;
  std::vector<HeadLayer> gradient;
  int n = 0;
  for (int epoch = 0; epoch < options.epochs; ++epoch) {
    for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[random.bits() % (i + 1)]);
    for (std::size_t batch = 0; batch < batches; ++batch) {
      std::vector<const WalkSample*> drawn;
      for (std::size_t i = 0; i < kBatch; ++i) drawn.push_back(&samples[order[batch * kBatch + i]]);
      batch_loss(weights, drawn, &gradient);
      const double rate = kRate * 0.5 * (1.0 + std::cos(std::numbers::pi * n / steps));
      ++n;
      for (std::size_t l = 0; l < weights.layers.size(); ++l) {
        matrices[l].step(weights.layers[l].W, gradient[l].W, rate, kDecay, n);
        offsets[l].step(weights.layers[l].b, gradient[l].b, rate, 0.0, n);
      }
    }
  }
  return weights;
}

}  // namespace bw::people
