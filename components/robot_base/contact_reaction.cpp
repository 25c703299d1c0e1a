#include "components/robot_base/contact_reaction.hpp"

#include <algorithm>

namespace bw {
namespace {

constexpr double kLag = 0.05;  // [s]

}  // namespace

void ContactReaction::touch(Time now, double travelled, const ContactReading& contacts, bool is_driving) {
  if (since_ || contacts.any_drop() || !is_driving || !options_.back_off) return;
  since_ = now;
  from_ = travelled;
}

std::optional<WheelSpeeds> ContactReaction::step(Time now, double travelled, const ContactReading& contacts) {
  if (!since_) return std::nullopt;
  since_ = std::min(*since_, now);     // the clock went back
  from_ = std::max(from_, travelled);  // where it turns round: it goes on for a moment
  const double v = options_.kSpeed;
  const double reserve = v * (kLag + v / (2.0 * stop_deceleration_));
  const bool is_far_enough = from_ - travelled >= options_.distance - reserve;
  const bool is_over = now - *since_ >= Duration::seconds(options_.time_limit);
  if (is_far_enough || is_over || contacts.any_drop()) {
    since_.reset();
    return std::nullopt;
  }
  return WheelSpeeds{-v, -v};
}

}  // namespace bw
