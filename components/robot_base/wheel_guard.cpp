#include "components/robot_base/wheel_guard.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bw {
namespace {

constexpr std::array<const char*, 2> kNames = {"left", "right"};

}  // namespace

WheelGuard::WheelGuard(const WheelGuardOptions& options, const Robot& robot, double response)
    : options_(options),
      response_(Duration::seconds(response)),
      acceleration_(robot.limits.acc_max),
      deceleration_(robot.limits.stop_deceleration),
      resolution_(2.0 * robot.metres_per_tick(robot.wheel_radius)),
      limit_(options.slack + resolution_) {}

void WheelGuard::commanded(Time now, const WheelSpeeds& wheels) {
  if (!commands_.empty() && commands_.back().time > now) commands_.clear();  // the clock went back
  const std::array<double, 2> both = {wheels.left, wheels.right};
  if (commands_.empty() || commands_.back().wheels != both) commands_.push_back({now, both});
}

WheelVerdict WheelGuard::measured(Time stamp, const WheelTravel& travel) {
  const Time oldest = stamp - Duration::seconds(travel.seconds) - response_;
  while (commands_.size() > 1 && commands_[1].time <= oldest) commands_.pop_front();
  const std::array<double, 2> distances = {travel.left, travel.right};
  WheelVerdict verdict = WheelVerdict::sound;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    double lowest = commands_.empty() ? 0.0 : commands_.front().wheels[i];
    double highest = lowest;
    for (const Command& command : commands_) {
      if (command.time > stamp) break;
      lowest = std::min(lowest, command.wheels[i]);
      highest = std::max(highest, command.wheels[i]);
    }
    Side& side = sides_[i];
    if (!side.is_known) {
      const double speed = distances[i] / travel.seconds;
      side = {.is_known = true, .lo = std::min(lowest, speed), .hi = std::max(highest, speed)};
      continue;
    }
    follow(side, lowest, highest, travel.seconds);
    if (is_off(side, distances[i], travel.seconds) && verdict == WheelVerdict::sound)
      verdict = judge(side, kNames[i]);
  }
  if (verdict != WheelVerdict::sound) reset();
  return verdict;
}

void WheelGuard::follow(Side& side, double lowest, double highest, double dt) const {
  const double fall = (side.hi > 0.0 ? deceleration_ : acceleration_) * dt;
  const double rise = (side.lo < 0.0 ? deceleration_ : acceleration_) * dt;
  side.hi = std::max(highest, side.hi - fall);
  side.lo = std::min(lowest, side.lo + rise);
}

bool WheelGuard::is_off(Side& side, double distance, double dt) const {
  const double fastest = std::max(std::abs(side.lo), std::abs(side.hi));
  const double margin = (options_.share * fastest + options_.tolerance) * dt;
  side.below = std::max(0.0, side.below + side.lo * dt - distance - margin);
  side.above = std::max(0.0, side.above + distance - side.hi * dt - margin);
  const bool is_suspect = side.below > 0.0 || side.above > 0.0;
  side.seconds = is_suspect ? side.seconds + dt : 0.0;
  side.distance = is_suspect ? side.distance + distance : 0.0;
  return side.below > limit_ || side.above > limit_;
}

WheelVerdict WheelGuard::judge(const Side& side, const char* name) {
  const double speed = side.distance / side.seconds;
  const double told = side.below > limit_ ? side.lo : side.hi;
  // It stalls where it goes the way it is told, and less; a reading's coarseness is no other way.
  const double still = options_.tolerance + resolution_ / side.seconds;
  const bool lags = side.below > limit_ ? told > 0.0 && speed > -still : told < 0.0 && speed < still;
  char text[120];
  std::snprintf(text, sizeof text, "the %s wheel turns at %.2f m/s and is told %.2f m/s", name, speed, told);
  reason_ = text;
  return lags ? WheelVerdict::stall : WheelVerdict::runaway;
}

void WheelGuard::reset() { sides_ = {}; }

}  // namespace bw
