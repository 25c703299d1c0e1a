// Experiment E1 (protocols.md 8.1): the EKF of the dissertation's Figure 2.3 on a sine-like path and a
// circle, with wheels alone, + receiver, + compass, + both. Setup of ekf/theory.md 3.3.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

enum class EkfPath { sinus, circle };

/// What the filter believes of its wheels.
enum class EkfWheelNoise {
  placed,  ///< k_f = 0.03 m: places the fused errors where they were published; far above the true noise
  matched  ///< the true k and (0.0085 ds)^2 for the unequal wheels
};

struct EkfSensorSet {
  std::string_view name;
  bool receiver;
  bool compass;
  /// Published, sinus and circle: mean error [m] and "mean square error", a variance about the mean [m^2].
  std::array<double, 2> published_mean;
  std::array<double, 2> published_variance;
};

constexpr std::array<EkfSensorSet, 4> kEkfSensorSets{{
    {"encoder", false, false, {37.4074, 35.1793}, {6.1162, 5.9312}},
    {"encoder + GPS", true, false, {0.2303, 0.2477}, {0.0289, 0.0217}},
    {"encoder + compass", false, true, {0.1630, 0.2032}, {0.0189, 0.0243}},
    {"encoder + GPS + compass", true, true, {0.1455, 0.1533}, {0.0081, 0.0115}},
}};

/// Errors of the position along one run, (2.1) of the dissertation: NE_k = |estimate - truth| at every step.
struct EkfErrors {
  double mean = 0.0;      ///< ME [m]
  double variance = 0.0;  ///< the published "MSE" [m^2]: mean of (NE - ME)^2
  double rms = 0.0;       ///< root of the mean of NE^2 [m]
};

/// One step of a run.
struct EkfSample {
  double time = 0.0;  ///< [s]
  Vector2 truth{0.0, 0.0};
  Vector2 estimate{0.0, 0.0};
};

/// The course of one run; the same seed draws the same noise for every sensor set and wheel noise.
std::vector<EkfSample> drive_ekf(EkfPath path, const EkfSensorSet& sensors, EkfWheelNoise noise,
                                 std::uint64_t seed);

/// One run.
EkfErrors run_ekf_experiment(EkfPath path, const EkfSensorSet& sensors, EkfWheelNoise noise,
                             std::uint64_t seed);

/// Seeds 1 to `seeds`, in that order.
std::vector<EkfErrors> run_ekf_experiments(EkfPath path, const EkfSensorSet& sensors, EkfWheelNoise noise,
                                           int seeds);

}  // namespace bw
