// Where people will be: positions with covariance over the planner's horizon (README.md 7.8).
//
//   mean        constant velocity:   p + v t
//               constant turn rate:  an arc whose turn rate dies out, omega exp(-t / kTurnRateMemory)
//               social force:        everybody wants to keep their velocity, and is pushed by the others
//                                    and by walls
//               learned:             by a net of the person's past while it proves right, covariance included
//   covariance  J P J^T + R(heading) diag(spread_along, spread_across) R^T t^3 / 3,   J = [I  t I]
//               P of (position, velocity) as tracked; the second term is what white acceleration adds; all of
//               it scaled so that 95 % of the ellipses hold the truth (calibration.hpp)
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "components/model/tracked_person.hpp"
#include "components/people/prediction/calibration.hpp"
#include "components/people/prediction/learned_prediction.hpp"
#include "components/people/prediction/prediction_options.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

/// Remembers headings, for turn rates, and how good its predictions were, for the size of their ellipses.
class Predictor {
 public:
  /// `head`: of the learned model, for steps of kAheadStep; without it that model is constant_velocity.
  explicit Predictor(const PredictionOptions& options, const std::optional<HeadWeights>& head = std::nullopt)
      : options_(options), calibration_(options.calibration_rate) {
    if (head) learned_.emplace(*head);
  }

  /// For the next predictions. The calibration keeps its rate.
  void set_options(const PredictionOptions& options) { options_ = options; }

  /// Sets the predictions of each of `people` at `now`, at step, 2 step, ... up to the horizon; none of a
  /// person who is not finite. `walls`, in the frame of the people, only matter to social_force.
  void predict(std::vector<TrackedPerson>& people, const StaticObstacles& walls, Time now);

  /// Predictions of the head that were not finite, so far.
  std::int64_t refused() const { return learned_ ? learned_->refused() : 0; }

 private:
  struct HeadingMemory {
    Time time;
    double heading = 0.0;  ///< [rad]
    double rate = 0.0;     ///< [rad/s], averaged
  };

  double turn_rate(const TrackedPerson& person, Time now);

  PredictionOptions options_;
  Calibration calibration_;
  std::optional<LearnedPrediction> learned_;
  std::map<std::uint32_t, HeadingMemory> headings_;
};

/// Covariance of the position `t` [s] ahead.
Eigen::Matrix2d predicted_covariance(const TrackedPerson& person, double t, const PredictionOptions& options);

}  // namespace bw::people
