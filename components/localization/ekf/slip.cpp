#include "components/localization/ekf/slip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bw::localization {
namespace {

constexpr double kForgetting = 30.0;   // [s] over which slip is added up for the doubt
constexpr double kApart = 2.0;         // [s] over which wheels and gyro go apart while one of them fails
constexpr double kSuspect = 0.36;      // of the gate: from here on the speed may be that of slipping wheels
constexpr double kCalm = 0.6;          // of the largest acceleration: between one window and the next
constexpr double kSpeedShare = 0.05;   // that wheels may measure a speed wrong
constexpr double kWorthKeeping = 0.1;  // of the best hypothesis' likelihood
constexpr double kNoFit = 3e-4;        // likelihood beyond four standard deviations

// Excess of the distance by each hypothesis, for sums of one span; whether it is possible at all.
struct Hypothesis {
  double excess = 0.0;
  bool possible = false;
};

std::array<Hypothesis, 3> hypotheses(double travel, double rotation, double disagreement, double separation) {
  const double one_wheel = separation / 2.0 * disagreement;
  const bool known = separation > 0.0;
  // Both alike cannot rotate the robot against the wheels; sliding, it moves at most a few times as far.
  const double share = rotation != 0.0 ? disagreement / rotation : 2.0;
  return {{{one_wheel, known}, {-one_wheel, known}, {travel * share, share < 1.0 && share > -3.0}}};
}

void weigh(SlipWatch& watch, double separation, double acceleration, double window) {
  const auto all = hypotheses(watch.travel, watch.rotation, watch.disagreement, separation);
  const double sigma = kCalm * acceleration * window + kSpeedShare * std::abs(watch.speed);
  std::array<double, 3>& weights = watch.excess.weights;
  for (std::size_t h = 0; h < all.size(); ++h) {
    const double off = ((watch.travel - all[h].excess) / watch.time - watch.speed) / std::max(sigma, 1e-3);
    weights[h] = all[h].possible ? std::exp(-0.5 * off * off) : 0.0;
  }
  const double best = *std::max_element(weights.begin(), weights.end());
  double sum = kNoFit;
  for (double& w : weights) {
    if (w < kWorthKeeping * best) w = 0.0;
    sum += w;
  }
  for (double& w : weights) w /= sum;
}

void note_speed(SlipWatch& watch, const ComparedStep& step, double window) {
  watch.block_travel += step.distance;
  watch.block_time += step.seconds;
  if (watch.block_time < window) return;
  watch.speed = watch.last_speed;
  watch.last_speed = watch.block_travel / watch.block_time;
  watch.block_travel = watch.block_time = 0.0;
}

void begin(SlipWatch& watch, Time time) {
  watch.since = time;
  watch.excess = {};
  // It began within the window before it was seen.
  watch.excess.disagreement = watch.disagreement;
  watch.excess.travel = watch.travel;
  watch.excess.rotation = watch.rotation;
}

}  // namespace

void watch_slip(SlipWatch& watch, const ComparedStep& step, double bias_variance, Time time,
                double acceleration, const SlipOptions& options) {
  const double lambda = std::exp(-step.seconds / options.kWindow);
  watch.disagreement = lambda * watch.disagreement + step.disagreement;
  watch.variance = lambda * lambda * watch.variance + step.variance;
  watch.time = lambda * watch.time + step.seconds;
  watch.travel = lambda * watch.travel + step.distance;
  watch.rotation = lambda * watch.rotation + step.rotation;
  const double forgotten = std::exp(-step.seconds / kApart);
  watch.apart = forgotten * watch.apart + step.disagreement;
  watch.apart_variance = forgotten * forgotten * watch.apart_variance + step.variance;
  const double e = watch.disagreement;
  const double variance = watch.variance + watch.time * watch.time * bias_variance + 2.0 * step.rounding;
  const bool sign = e * e > options.kGate * variance && std::abs(e) > options.kLeastRate * watch.time;
  // Weak slip hides now and then; while it goes on, half of its largest disagreement is a sign too.
  if (sign || (slipping(watch) && std::abs(e) > 0.5 * watch.excess.peak)) {
    watch.seen = time;
    if (!slipping(watch)) {
      begin(watch, time);
    } else {
      watch.excess.disagreement += step.disagreement;
      watch.excess.travel += step.distance;
      watch.excess.rotation += step.rotation;
    }
    if (std::abs(e) >= watch.excess.peak) {  // never as full of slip as now
      watch.excess.peak = std::abs(e);
      weigh(watch, step.separation, acceleration, options.kWindow);
    }
  } else if (slipping(watch) && time - watch.seen > Duration::seconds(options.kHold)) {
    watch.since = kNever;
    watch.last_speed = watch.speed;
    watch.block_travel = watch.block_time = 0.0;
  }
  if (!slipping(watch) && e * e < kSuspect * options.kGate * variance)
    note_speed(watch, step, options.kWindow);
  watch.lately *= std::exp(-step.seconds / kForgetting);
  if (slipping(watch)) watch.lately += step.seconds;
}

SlipCorrection take_back(SlipWatch& watch, const ComparedStep& step, Time time, const SlipOptions& options) {
  SlipExcess& sum = watch.excess;
  const auto all = hypotheses(sum.travel, sum.rotation, sum.disagreement, step.separation);
  double fitting = 0.0, mean = 0.0, square = 0.0;
  for (std::size_t h = 0; h < all.size(); ++h) {
    if (!all[h].possible) continue;
    fitting += sum.weights[h];
    mean += sum.weights[h] * all[h].excess;
    square += sum.weights[h] * all[h].excess * all[h].excess;
  }
  const double scatter =
      std::max(0.0, square - mean * mean) + std::max(0.0, 1.0 - fitting) * sum.travel * sum.travel;
  const double rest = options.kDistanceShare * sum.travel;
  const double variance = scatter + rest * rest;

  SlipCorrection correction;
  const bool growing = watch.seen == time && std::abs(sum.disagreement) > 1e-6;
  correction.of_step = growing ? mean / sum.disagreement * step.disagreement : 0.0;
  correction.catch_up = mean - sum.taken - correction.of_step;
  correction.variance = std::max(0.0, variance - sum.variance);
  sum.taken = mean;
  sum.variance = std::max(sum.variance, variance);
  return correction;
}

}  // namespace bw::localization
