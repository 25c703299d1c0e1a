// Parameters of the prediction of people. Defaults: README.md says what they were measured on.
#pragma once

#include <optional>
#include <string>

#include "components/model/social_force.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::people {

enum class PredictionModel { constant_velocity, constant_turn_rate, social_force, learned };
constexpr auto choice_table(PredictionModel) {
  using enum PredictionModel;
  return choices<PredictionModel>({{constant_velocity, "constant_velocity"},
                                   {constant_turn_rate, "constant_turn_rate"},
                                   {social_force, "social_force"},
                                   {learned, "learned"}});
}

struct PredictionOptions {
  PredictionModel model = PredictionModel::constant_velocity;
  /// text file of the learned head (files/head_file.hpp)
  std::string weights;
  double horizon = 4.0;
  /// [s] time between predicted positions (set by code alone)
  double step = 0.5;
  /// [m^2/s^3] white acceleration along the way that people may show against the prediction (set by code
  /// alone)
  double spread_along = 0.0;
  /// [m^2/s^3] white acceleration across the way that people may show against the prediction (set by code
  /// alone)
  double spread_across = 0.0;
  /// [m/s] below this speed a velocity shows no heading and no turn
  static constexpr double kWalkingSpeed = 0.2;
  /// [s] time over which the turn rate is averaged
  static constexpr double kTurnRateWindow = 0.8;
  /// [s] a turn dies out within this time (time constant)
  static constexpr double kTurnRateMemory = 0.6;
  /// how fast the size of predicted ellipses follows what people do; 0: fixed (set by code alone)
  double calibration_rate = 0.3;
  SocialForceOptions forces;

  template <class Visitor>
  void fields(Visitor& v) {
    v("model", model,
      {.first = true,
       .doc = "constant_velocity: straight on; constant_turn_rate: the turn goes on and dies out; "
              "social_force: straight "
              "on, but round one another and along walls; learned: by a net while it proves right, else as "
              "constant_velocity"});
    v("weights", weights, {.doc = "file of the net of the model learned"});
    v("horizon", horizon, {.unit = "s", .min = 0, .max = 20, .doc = "how far ahead positions are predicted"});
    v.retired({"step", "spread_along", "spread_across", "walking_speed", "turn_window", "turn_memory",
               "calibration_rate", "forces"},
              "a constant of prediction_options.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (model != PredictionModel::learned) return std::nullopt;
    if (weights.empty()) return "model learned needs weights";
    if (horizon > 4.0) return "model learned predicts 4 s: horizon must not be above";
    return std::nullopt;
  }
};

}  // namespace bw::people
