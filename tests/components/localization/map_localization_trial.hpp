// One drive of the particle filter with wheels and a laser through a map: start known, start anywhere, and
// carried away meanwhile.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "components/localization/particle_filter/particle_filter.hpp"
#include "tests/components/localization/laser_robot.hpp"

namespace bw::localization::test {

inline double thread_milliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// What came of a drive, at the sweeps that were used.
struct DriveRecord {
  std::vector<double> errors;          ///< of the position [m]
  std::vector<double> heading_errors;  ///< [rad]
  std::vector<double> nees;            ///< of (x, y, theta)
  std::vector<double> particles;
  std::vector<double> milliseconds;  ///< thread CPU time since the last of them: sweeps and wheel steps
  double longest_call = 0.0;         ///< [ms]
  std::optional<double> lost_after;  ///< health first LOST, since the beginning [s]
  double longest_unreported = 0.0;   ///< estimate off by more than 0.5 m, and health not LOST [s]
  int lost_sweeps = 0;               ///< sweeps, used or not, after which health was LOST
  int sweeps = 0;
  double seconds = 0.0;

  double rmse() const {
    double sum = 0.0;
    for (const double e : errors) sum += e * e;
    return std::sqrt(sum / static_cast<double>(errors.size()));
  }
  double worst() const { return *std::max_element(errors.begin(), errors.end()); }
  static double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
  }
  /// Used sweeps until five in a row were within 0.4 m, these included.
  std::optional<int> found_after() const {
    int run = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      run = errors[i] <= 0.4 ? run + 1 : 0;
      if (run == 5) return static_cast<int>(i) + 1;
    }
    return std::nullopt;
  }
};

/// Wheel steps at 20 Hz, sweeps at 10 Hz. Goes on where the last drive ended in time, and anywhere in space.
class TrialDrive {
 public:
  TrialDrive(const OccupancyGrid& map, const ParticleFilterOptions& options, const SensorNoise& noise,
             std::uint64_t seed)
      : filter_(options, seed), robot_(map, noise, seed + 1) {
    filter_.set_map(map);
  }

  ParticleFilter& filter() { return filter_; }
  Time now() const { return now_; }

  /// Until the end of the route, or until `most` sweeps were used.
  DriveRecord drive(const std::vector<Pose2>& truth, int most) {
    DriveRecord record;
    const Time begun = now_;
    double spent = 0.0;
    double unreported = 0.0;
    for (std::size_t i = 1; i < truth.size(); ++i) {
      now_ = now_ + Duration::milliseconds(50);
      const WheelStep step = robot_.wheel_step(now_, truth[i - 1], truth[i]);
      spent += timed(record, [&] { filter_.add(step, now_); });
      if (i % 2 != 0) continue;
      const LaserReading sweep = robot_.sweep(now_, truth[i]);
      Outcome outcome;
      spent += timed(record, [&] { outcome = filter_.add(sweep, now_); });
      ++record.sweeps;
      record.seconds = (now_ - begun).to_seconds();
      const bool lost = filter_.health(now_).state == HealthState::lost;
      if (lost) {
        ++record.lost_sweeps;
        if (!record.lost_after) record.lost_after = record.seconds;
      }
      const bool off = (filter_.estimate_at(now_).X_MB.position() - truth[i].position()).norm() > 0.5;
      unreported = off && !lost ? unreported + 2.0 * kStepSeconds : 0.0;
      record.longest_unreported = std::max(record.longest_unreported, unreported);
      if (!used(outcome.verdict)) continue;
      note(record, truth[i]);
      record.milliseconds.push_back(spent);
      spent = 0.0;
      if (static_cast<int>(record.errors.size()) >= most) break;
    }
    return record;
  }

 private:
  template <class Call>
  static double timed(DriveRecord& record, Call call) {
    const double before = thread_milliseconds();
    call();
    const double spent = thread_milliseconds() - before;
    record.longest_call = std::max(record.longest_call, spent);
    return spent;
  }

  void note(DriveRecord& record, const Pose2& truth) const {
    const Estimate estimate = filter_.estimate_at(now_);
    const Eigen::Vector3d error(estimate.X_MB.x - truth.x, estimate.X_MB.y - truth.y,
                                wrap_angle(estimate.X_MB.theta - truth.theta));
    record.errors.push_back(error.head<2>().norm());
    record.heading_errors.push_back(std::abs(error(2)));
    record.nees.push_back(error.dot(estimate.covariance.ldlt().solve(error)));
    record.particles.push_back(static_cast<double>(filter_.particles()->size()));
  }

  ParticleFilter filter_;
  SensedRobot robot_;
  Time now_{1'000'000'000'000};
};

inline Eigen::Matrix3d known_start() { return Eigen::Vector3d(0.04, 0.04, 0.01).asDiagonal(); }

inline DriveRecord track(const OccupancyGrid& map, const Roads& roads, const ParticleFilterOptions& options,
                         const SensorNoise& noise, std::uint64_t seed, int updates) {
  Random random(seed);
  const std::vector<Pose2> truth = route(roads, random, 0.27 * updates);
  TrialDrive drive(map, options, noise, seed);
  drive.filter().start_at(truth.front(), known_start(), drive.now());
  return drive.drive(truth, updates);
}

inline DriveRecord start_anywhere(const OccupancyGrid& map, const Roads& roads,
                                  const ParticleFilterOptions& options, const SensorNoise& noise,
                                  std::uint64_t seed, int updates) {
  Random random(seed);
  const std::vector<Pose2> truth = route(roads, random, 0.27 * updates);
  TrialDrive drive(map, options, noise, seed);
  drive.filter().start_anywhere(drive.now());
  return drive.drive(truth, updates);
}

/// The drive after the robot was carried away by at least `away` [m].
inline DriveRecord kidnap(const OccupancyGrid& map, const Roads& roads, const ParticleFilterOptions& options,
                          const SensorNoise& noise, std::uint64_t seed, int updates, double away) {
  Random random(seed);
  const std::vector<Pose2> before = route(roads, random, 10.0);
  std::vector<Pose2> after;
  do {
    after = route(roads, random, 0.27 * updates);
  } while ((after.front().position() - before.back().position()).norm() < away);
  TrialDrive drive(map, options, noise, seed);
  drive.filter().start_at(before.front(), known_start(), drive.now());
  drive.drive(before, 1000);
  return drive.drive(after, updates);
}

}  // namespace bw::localization::test
