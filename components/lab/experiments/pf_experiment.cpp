#include "components/lab/experiments/pf_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "components/localization/particle_filter/particle_filter.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using namespace localization;

// particle_filter/theory.md 4.3.
constexpr double kSpeed = 1.0;   // [m/s]
constexpr double kPeriod = 0.1;  // [s]
constexpr double kRadius = kPfRadius;
constexpr int kSteps = 840;
constexpr int kRoofFrom = static_cast<int>(kPfRoofFrom / kPeriod + 0.5);
constexpr int kRoofTo = static_cast<int>(kPfRoofTo / kPeriod + 0.5);
constexpr double kSigma = 0.2;  // of every reading [m, rad]

struct Step {
  Pose2 truth;
  Pose2 reading;
  bool position;
  bool heading;
};

// Wheels say an exact circle; the robot really errs from it by the noise of every step (reading D2), along,
// across and in heading. All draws are made, used or not.
std::vector<Step> drive(const PfRow& row, std::uint64_t seed) {
  const ParticleMotionOptions noise;
  Random random(seed);
  std::vector<Step> steps;
  Pose2 truth;
  for (int i = 1; i <= kSteps; ++i) {
    truth = advance_exact(truth, {kSpeed, kSpeed / kRadius}, kPeriod);
    const double along = noise.kStepAlong * random.normal();
    const double across = noise.kStepAcross * random.normal();
    truth = truth * Pose2{along, across, noise.kStepHeading * random.normal()};
    const double x = truth.x + kSigma * random.normal();
    const double y = truth.y + kSigma * random.normal();
    const double theta = wrap_angle(truth.theta + kSigma * random.normal());
    const bool roof = i > kRoofFrom && i <= kRoofTo;
    steps.push_back({truth, {x, y, theta}, !roof || row.position, !roof || row.heading});
  }
  return steps;
}

double mean_error(const std::vector<PfSample>& samples) {
  double sum = 0.0;
  for (const PfSample& sample : samples) sum += (sample.estimate - sample.truth).norm();
  return sum / static_cast<double>(samples.size());
}

std::vector<Vector2> by_wheels(const std::vector<Step>& steps, bool with_fixes) {
  std::vector<Vector2> estimates;
  Pose2 pose;
  for (const Step& step : steps) {
    pose = advance_exact(pose, {kSpeed, kSpeed / kRadius}, kPeriod);
    if (with_fixes && step.position)
      pose = {step.reading.x, step.reading.y, step.heading ? step.reading.theta : pose.theta};
    estimates.push_back(pose.position());
  }
  return estimates;
}

ParticleFilterOptions filter_options(PfMethod method, int particles) {
  ParticleFilterOptions options;
  options.count.min_particles = options.count.max_particles = particles;
  options.motion.noise = MotionNoise::per_step;
  options.motion.longest_distance = 0.0;  // Algorithm 1 moves them every step
  options.motion.walk = options.motion.heading_walk = 0.0;
  options.gate.enabled = false;  // Algorithm 1 has none
  if (method == PfMethod::printed) options.weight_law = WeightLaw::printed;
  if (method == PfMethod::printed_unscaled) options.weight_law = WeightLaw::printed_unscaled;
  return options;
}

std::vector<Vector2> by_filter(const std::vector<Step>& steps, PfMethod method, std::uint64_t seed,
                               int particles) {
  ParticleFilter filter(filter_options(method, particles), seed);
  const Time start = Time::seconds(1000.0);
  filter.start_at({}, 1e-6 * Eigen::Matrix3d::Identity(), start);
  const Duration period = Duration::seconds(kPeriod);
  std::vector<Vector2> estimates;
  Time now = start;
  for (const Step& step : steps) {
    now = now + period;
    WheelStep wheels;
    wheels.time = now;
    wheels.over = period;
    wheels.distance = kSpeed * kPeriod;
    wheels.rotation = kSpeed / kRadius * kPeriod;
    filter.add(wheels, now);
    if (step.position && step.heading) {
      filter.add(PoseReading{now, 1, step.reading, kSigma * kSigma * Eigen::Matrix3d::Identity()}, now);
    } else if (step.position) {
      PositionFix fix;
      fix.time = now;
      fix.source = 2;
      fix.position = step.reading.position();
      fix.covariance = kSigma * kSigma * Eigen::Matrix2d::Identity();
      filter.add(fix, now);
    } else if (step.heading) {
      filter.add(HeadingReading{now, 3, step.reading.theta, kSigma * kSigma}, now);
    }
    estimates.push_back(filter.estimate_at(now).X_MB.position());
  }
  return estimates;
}

const PfCell& cell_of(const PfTable& table, std::size_t row, PfMethod method) {
  return table.cells[row][static_cast<std::size_t>(method)];
}

}  // namespace

std::string_view to_string(PfMethod method) {
  switch (method) {
    case PfMethod::encoder:
      return "encoder";
    case PfMethod::dead_reckoning:
      return "dead reckoning";
    case PfMethod::gaussian:
      return "PF, Gaussian";
    case PfMethod::printed:
      return "PF, printed";
    case PfMethod::printed_unscaled:
      return "PF, printed, unscaled";
  }
  return "unknown";
}

std::vector<PfSample> drive_pf(const PfRow& row, PfMethod method, std::uint64_t seed, int particles) {
  const std::vector<Step> steps = drive(row, seed);
  const bool wheels = method == PfMethod::encoder || method == PfMethod::dead_reckoning;
  const std::vector<Vector2> estimates =
      wheels ? by_wheels(steps, method == PfMethod::encoder) : by_filter(steps, method, seed, particles);
  std::vector<PfSample> samples;
  for (std::size_t i = 0; i < steps.size(); ++i)
    samples.push_back({static_cast<double>(i + 1) * kPeriod, steps[i].truth.position(), estimates[i]});
  return samples;
}

double run_pf_experiment(const PfRow& row, PfMethod method, std::uint64_t seed, int particles) {
  return mean_error(drive_pf(row, method, seed, particles));
}

PfTable run_pf_experiments(const PfExperimentOptions& options, const PfProgress& progress) {
  PfTable table{.options = options};
  int done = 0;
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    for (const PfMethod method : kPfMethods) {
      PfCell cell{.method = method};
      for (std::uint64_t seed = options.first_seed; seed <= options.last_seed; ++seed) {
        std::vector<PfSample> course = drive_pf(kPfRows[row], method, seed, options.particles);
        cell.errors.push_back(mean_error(course));
        if (seed == options.first_seed) cell.example = std::move(course);
        cell.mean += cell.errors.back();
      }
      cell.mean /= static_cast<double>(cell.errors.size());
      cell.low = quantile(cell.errors, 0.05);
      cell.high = quantile(cell.errors, 0.95);
      table.cells[row].push_back(std::move(cell));
      ++done;
      if (progress)
        progress(kPfRows[row], table.cells[row].back(), done,
                 static_cast<int>(kPfRows.size() * kPfMethods.size()));
    }
  }
  table.criteria = pf_criteria(table, PfMethod::gaussian);
  return table;
}

std::vector<Criterion> pf_criteria(const PfTable& table, PfMethod method) {
  const auto mean = [&](std::size_t row, PfMethod of) { return cell_of(table, row, of).mean; };
  const auto from_fix = [&](std::size_t row) { return mean(row, PfMethod::encoder); };
  const double fix_error = std::max(std::abs(from_fix(0) - 0.251), std::abs(from_fix(1) - 0.251));
  double smallest_rise = std::numeric_limits<double>::infinity();
  double smallest_gain = smallest_rise;
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    smallest_gain = std::min(smallest_gain, from_fix(row) - mean(row, method));
    if (row > 0) smallest_rise = std::min(smallest_rise, mean(row, method) - mean(row - 1, method));
  }
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  const double open = std::max(mean(0, method), mean(1, method));
  std::vector<Criterion> criteria = {
      {"encoder, rows [x, y, theta] and [x, y]: largest distance from 0.251 [m]", "<= 0.01", fix_error,
       fix_error <= 0.01},
      {"encoder, row [theta]: mean error [m]", "0.6 to 1.3", from_fix(2), within(from_fix(2), 0.6, 1.3)},
      {"encoder, row []: mean error [m]", "0.6 to 1.3", from_fix(3), within(from_fix(3), 0.6, 1.3)},
      {"filter: smallest rise of the mean error from row to row [m]", "> 0", smallest_rise,
       smallest_rise > 0.0},
      {"filter, rows [x, y, theta] and [x, y]: larger mean error [m]", "< 0.2", open, open < 0.2},
      {"filter, row [theta]: mean error [m]", "0.13 to 0.40", mean(2, method),
       within(mean(2, method), 0.13, 0.40)},
      {"filter, row []: mean error [m]", "0.15 to 0.65", mean(3, method),
       within(mean(3, method), 0.15, 0.65)},
      {"smallest gain of the filter over the encoder in a row [m]", "> 0", smallest_gain,
       smallest_gain > 0.0},
  };
  const std::size_t seeds = cell_of(table, 0, method).errors.size();
  for (Criterion& c : criteria) c = over_seeds(std::move(c), seeds, kPfSeeds);
  return criteria;
}

}  // namespace bw
