// A compass contradicts the estimate: is it disturbed, or is the gyro wrong? Sensors as in the hallway
// (config/graphs/hallway.yaml), the fault from 20 s on.
#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "components/localization/ekf/ekf.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace bw::localization {
namespace {

struct SenseFault {
  const char* name;
  double gyro = 0.0;     ///< [rad/s] added to it
  double compass = 0.0;  ///< [rad] added to it
  double seconds = 2.0;
};

DriveOptions hallway(std::uint64_t seed) {
  DriveOptions options;
  options.seed = seed;
  options.seconds = 40.0;
  options.speed = 0.65;
  options.turn_rate_amplitude = 0.2;
  options.separation = 0.39;
  options.gyro_sigma = 0.005;
  options.compass_sigma = 0.02;
  options.gps_sigma = 0.18;
  options.gps_every = 100;
  return options;
}

struct Errors {
  double squares = 0.0;  ///< of the position, each half second from 20 s on [m^2]
  double nees = 0.0;     ///< of the pose, mean of the same
};

Errors follow(const DriveOptions& options, const SenseFault& fault) {
  const Drive drive = simulate(options);
  Ekf ekf({});
  EXPECT_TRUE(ekf.start_at({}, Eigen::Vector3d(0.01, 0.01, 1e-4).asDiagonal(), kStart));
  Errors errors;
  int step = 0, samples = 0;
  for (Measurement m : drive.measurements) {
    const double t = (stamp(m) - kStart).to_seconds();
    const bool fails = t > 20.0 && t <= 20.0 + fault.seconds;
    if (auto* gyro = std::get_if<GyroReading>(&m); gyro != nullptr && fails) gyro->rate += fault.gyro;
    if (auto* heading = std::get_if<HeadingReading>(&m); heading != nullptr && fails)
      heading->heading = wrap_angle(heading->heading + fault.compass);
    ekf.add(m, stamp(m));
    if (!std::holds_alternative<WheelStep>(m) || ++step % 50 != 0 || t < 20.0) continue;
    const Estimate e = ekf.estimate();
    const Pose2& truth = drive.truth[static_cast<std::size_t>(step)];
    const Eigen::Vector3d error(e.X_MB.x - truth.x, e.X_MB.y - truth.y,
                                wrap_angle(e.X_MB.theta - truth.theta));
    errors.squares += error.head<2>().squaredNorm();
    errors.nees += (error.dot(e.covariance.llt().solve(error)) - errors.nees) / ++samples;
  }
  return errors;
}

class EkfDoubt : public ::testing::TestWithParam<SenseFault> {};

// While wheels and gyro leave it open who failed, the fixes have to tell, and that takes some seconds. The bounds are
// what was reached, with some room, and no closed form: of a failing gyro 2.5 times the error without the fault and a
// mean NEES of 20 (of 3 values: 3 would be consistent); of a compass that is disturbed alone 1.1 times and 4.5.
TEST_P(EkfDoubt, IsFoundOrSaid) {
  double clean = 0.0, failing = 0.0, nees = 0.0;
  constexpr int kRuns = 10;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    clean += follow(hallway(seed), {"none"}).squares;
    const Errors errors = follow(hallway(seed), GetParam());
    failing += errors.squares;
    nees += errors.nees / kRuns;
  }
  RecordProperty("failing_over_clean", std::to_string(std::sqrt(failing / clean)));
  RecordProperty("nees", std::to_string(nees));
  const bool is_gyro = GetParam().gyro != 0.0;
  EXPECT_LE(std::sqrt(failing / clean), is_gyro ? 2.5 : 1.1);
  EXPECT_LE(nees, is_gyro ? 20.0 : 4.5);
}

INSTANTIATE_TEST_SUITE_P(Faults, EkfDoubt,
                         ::testing::Values(SenseFault{"GyroSlightly", 0.05}, SenseFault{"Gyro", 0.1},
                                           SenseFault{"GyroMuch", 0.2}, SenseFault{"GyroBack", -0.1},
                                           SenseFault{"GyroForLong", 0.05, 0.0, 8.0},
                                           SenseFault{"CompassSlightly", 0.0, 0.1},
                                           SenseFault{"Compass", 0.0, 0.3},
                                           SenseFault{"CompassForLong", 0.0, 0.2, 16.0}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace bw::localization
