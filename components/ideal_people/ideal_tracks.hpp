// Tracks of people from the world's truth: those in range, with seeded noise if wanted, and a
// constant-velocity prediction
//
//   p(t) = p + v t,   cov(t) = (s_p^2 + s_v^2 t^2 + (a t^2 / 2)^2) I
//
// with a the acceleration by which a walker may deviate from the prediction.
#pragma once

#include <vector>

#include "components/model/random.hpp"
#include "components/model/tracked_person.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct IdealPeopleOptions {
  double rate = 10.0;
  double range = 15.0;
  double position_noise = 0.0;
  double velocity_noise = 0.0;
  double velocity_memory = 0.0;
  /// [m/s^2] spread of the predictions: 1.6 m after 4 s, two steps
  static constexpr double kWalkerAcceleration = 0.2;
  /// [s] how far ahead positions are predicted (set by code alone)
  double prediction_horizon = 4.0;
  /// [s] time between predicted positions (set by code alone)
  double prediction_step = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 1, .max = 100, .doc = "track messages per second"});
    v("range", range,
      {.unit = "m", .min = 0.5, .max = 1000, .doc = "people farther from the robot are not seen"});
    v("position_noise", position_noise,
      {.unit = "m", .min = 0, .max = 2, .doc = "standard deviation per axis and message"});
    v("velocity_noise", velocity_noise,
      {.unit = "m/s", .min = 0, .max = 2, .doc = "standard deviation per axis and message"});
    v("velocity_memory", velocity_memory,
      {.unit = "s",
       .min = 0,
       .max = 10,
       .doc = "velocities are means over about this time, as those of recorded people carry the errors of "
              "annotation; 0: as they are"});
    v.retired({"walker_acceleration", "prediction_horizon"}, "a constant of ideal_tracks.hpp");
  }
};

/// `people` as they truly are, and `robot`, in map. Predictions are filled in; the covariance now has s_p^2
/// and s_v^2 on its diagonal.
std::vector<TrackedPerson> ideal_tracks(const std::vector<Mover>& people, const Vector2& robot,
                                        const IdealPeopleOptions& options, Random& random);

}  // namespace bw
