#include "components/lab/experiments/ekf_experiment.hpp"

#include <cmath>
#include <numbers>

#include "components/localization/ekf/ekf.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "components/model/wheel_step.hpp"

namespace bw {
namespace {

using namespace localization;

// ekf/theory.md 3.3.
constexpr double kSpeed = 1.0;       // [m/s]
constexpr double kPeriod = 0.1;      // [s]
constexpr double kSeparation = 0.4;  // [m]
constexpr double kRadius = 33.0;     // [m]
constexpr double kMismatch = 0.0085;
constexpr double kWheelVariance = 2.5e-4;  // k [m]
constexpr double kPlacedVariance = 0.03;   // k_f [m]
constexpr double kReceiverSigma = 0.18;    // [m]
constexpr double kCompassSigma = 0.0175;   // [rad]
constexpr int kStepsPerReading = 10;       // 1 Hz
constexpr double kSinusTime = 120.0;       // [s]

double heading(EkfPath path, double t) {
  if (path == EkfPath::circle) return std::numbers::pi / 2.0 + kSpeed / kRadius * t;
  return 0.8 * std::cos(2.0 * std::numbers::pi * t / 30.0);
}

int step_count(EkfPath path) {
  const double time = path == EkfPath::circle ? 2.0 * std::numbers::pi * kRadius / kSpeed : kSinusTime;
  return static_cast<int>(std::lround(time / kPeriod));
}

double believed_variance(EkfWheelNoise noise, double ds) {
  if (noise == EkfWheelNoise::placed) return kPlacedVariance * std::abs(ds);
  return kWheelVariance * std::abs(ds) + kMismatch * kMismatch * ds * ds;
}

WheelStep measured_step(Time time, const WheelSpeeds& true_travel, EkfWheelNoise noise, Random& random) {
  const auto measure = [&](double ds, double side) {
    return ds * (1.0 + side * kMismatch / 2.0) + std::sqrt(kWheelVariance * std::abs(ds)) * random.normal();
  };
  const double left = measure(true_travel.left, -1.0);
  const double right = measure(true_travel.right, 1.0);
  WheelStep step = step_from_wheels(time, Duration::seconds(kPeriod), left, right, kSeparation, 0.0);
  const double var_left = believed_variance(noise, left);
  const double var_right = believed_variance(noise, right);
  const double cross = (var_right - var_left) / (2.0 * kSeparation);
  step.covariance << (var_left + var_right) / 4.0, cross, cross,
      (var_left + var_right) / (kSeparation * kSeparation);
  return step;
}

EkfErrors summarise(const std::vector<EkfSample>& samples) {
  std::vector<double> errors;
  for (const EkfSample& sample : samples) errors.push_back((sample.estimate - sample.truth).norm());
  const double n = static_cast<double>(errors.size());
  EkfErrors result;
  double squares = 0.0;
  for (const double e : errors) {
    result.mean += e / n;
    squares += e * e / n;
  }
  for (const double e : errors) result.variance += (e - result.mean) * (e - result.mean) / n;
  result.rms = std::sqrt(squares);
  return result;
}

}  // namespace

std::vector<EkfSample> drive_ekf(EkfPath path, const EkfSensorSet& sensors, EkfWheelNoise noise,
                                 std::uint64_t seed) {
  Random random(seed);
  Pose2 truth{0.0, 0.0, heading(path, 0.0)};
  EkfOptions options;
  options.bias.gyro_bias = false;
  Ekf ekf(options);
  const Time start = Time::seconds(1000.0);
  ekf.start_at(truth, 1e-6 * Eigen::Matrix3d::Identity(), start);

  std::vector<EkfSample> samples;
  const int steps = step_count(path);
  for (int i = 1; i <= steps; ++i) {
    const Time now = start + Duration::milliseconds(100) * i;
    const double rotation = heading(path, i * kPeriod) - heading(path, (i - 1) * kPeriod);
    const Twist2 travel{kSpeed * kPeriod, rotation};
    truth = advance_exact(truth, travel, 1.0);
    ekf.add(measured_step(now, to_wheel_speeds(travel, kSeparation), noise, random), now);
    if (i % kStepsPerReading == 0) {
      // Drawn whether used or not, so that every sensor set sees the same noise.
      const Vector2 east_north(random.normal(), random.normal());
      const double compass_error = random.normal();
      PositionFix fix;
      fix.time = now;
      fix.source = 1;
      fix.position = truth.position() + kReceiverSigma * east_north;
      fix.covariance = kReceiverSigma * kReceiverSigma * Eigen::Matrix2d::Identity();
      if (sensors.receiver) ekf.add(fix, now);
      const HeadingReading compass{now, 2, wrap_angle(truth.theta + kCompassSigma * compass_error),
                                   kCompassSigma * kCompassSigma};
      if (sensors.compass) ekf.add(compass, now);
    }
    samples.push_back({i * kPeriod, truth.position(), ekf.estimate().X_MB.position()});
  }
  return samples;
}

EkfErrors run_ekf_experiment(EkfPath path, const EkfSensorSet& sensors, EkfWheelNoise noise,
                             std::uint64_t seed) {
  return summarise(drive_ekf(path, sensors, noise, seed));
}

std::vector<EkfErrors> run_ekf_experiments(EkfPath path, const EkfSensorSet& sensors, EkfWheelNoise noise,
                                           int seeds) {
  std::vector<EkfErrors> result;
  for (int seed = 1; seed <= seeds; ++seed)
    result.push_back(run_ekf_experiment(path, sensors, noise, static_cast<std::uint64_t>(seed)));
  return result;
}

}  // namespace bw
