// Parameters of the prediction of people. Defaults: README.md says what they were measured on.
#pragma once

#include <optional>
#include <string>

#include "components/model/social_force.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::people {

enum class PredictionModel { constant_velocity, constant_turn_rate, social_force };
constexpr auto choice_table(PredictionModel) {
  using enum PredictionModel;
  return choices<PredictionModel>({{constant_velocity, "constant_velocity"},
                                   {constant_turn_rate, "constant_turn_rate"},
                                   {social_force, "social_force"}});
}

struct PredictionOptions {
  PredictionModel model = PredictionModel::constant_velocity;
  double horizon = 4.0;
  double step = 0.5;
  double spread_along = 0.0;
  double spread_across = 0.0;
  double walking_speed = 0.2;
  double turn_window = 0.8;
  double turn_memory = 0.6;
  double calibration_rate = 0.3;
  SocialForceOptions forces;

  template <class Visitor>
  void fields(Visitor& v) {
    v("model", model,
      {.doc = "constant_velocity: straight on; constant_turn_rate: the turn goes on and dies out; "
              "social_force: straight "
              "on, but round one another and along walls"});
    v("horizon", horizon, {.unit = "s", .min = 0, .max = 20, .doc = "how far ahead positions are predicted"});
    v("step", step, {.unit = "s", .min = 0.05, .max = 5, .doc = "time between predicted positions"});
    v("spread_along", spread_along,
      {.unit = "m^2/s^3",
       .min = 0,
       .max = 10,
       .doc = "white acceleration along the way that people may show against the prediction"});
    v("spread_across", spread_across,
      {.unit = "m^2/s^3",
       .min = 0,
       .max = 10,
       .doc = "white acceleration across the way that people may show against the prediction"});
    v("walking_speed", walking_speed,
      {.unit = "m/s", .min = 0, .max = 2, .doc = "below this speed a velocity shows no heading and no turn"});
    v("turn_window", turn_window,
      {.unit = "s", .min = 0.1, .max = 10, .doc = "time over which the turn rate is averaged"});
    v("turn_memory", turn_memory,
      {.unit = "s", .min = 0.05, .max = 20, .doc = "a turn dies out within this time (time constant)"});
    v("calibration_rate", calibration_rate,
      {.min = 0,
       .max = 1,
       .doc = "how fast the size of predicted ellipses follows what people do; 0: fixed"});
    v("forces", forces, {.doc = "the forces of model: social_force"});
  }

  std::optional<std::string> violated_rule() const {
    if (horizon / step > 200.0) return "horizon must not exceed 200 step";
    return std::nullopt;
  }
};

}  // namespace bw::people
