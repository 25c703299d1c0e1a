#include "components/robot_base/eddie/command_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace bw::eddie {
namespace {

constexpr double kWindow = 0.2;  ///< [s] over which the speed is measured
constexpr double kShows = 0.3;   ///< [s] for which a command shows after the next
constexpr double kSteady = 1.0;  ///< [s] for which a command must not have changed by more than a tenth
constexpr double kKept = 3.0;    ///< [s] of commands and travels
constexpr int kFastReadings = 3, kSlowReadings = 10;

std::string speed_text(double speed) {
  const long centimetres = std::lround(speed * 100.0);
  const std::string digits = std::to_string(std::abs(centimetres) % 100);
  return (centimetres < 0 ? "-" : "") + std::to_string(std::abs(centimetres) / 100) + "." +
         std::string(2 - digits.size(), '0') + digits + " m/s";
}

}  // namespace

void CommandCheck::reset() {
  commands_.clear();
  travels_.clear();
  fast_in_a_row_ = slow_in_a_row_ = 0;
}

void CommandCheck::told(Time now, const WheelSpeeds& wheels) {
  if (!commands_.empty() && commands_.back().time > now) reset();
  if (commands_.empty() || commands_.back().value != wheels) commands_.push_back({now, wheels});
  while (commands_.size() > 1 && (now - commands_[1].time).to_seconds() > kKept) commands_.pop_front();
}

/// Of what may show in a window that ends now.
CommandCheck::Span CommandCheck::commanded(Time now, double WheelSpeeds::*wheel) const {
  Span span;
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const double speed = commands_[i].value.*wheel;
    if (i + 1 < commands_.size()) {
      const double ramp = (std::abs(speed) + std::abs(commands_[i + 1].value.*wheel)) / acceleration_;
      if ((now - commands_[i + 1].time).to_seconds() > kShows + ramp) continue;
    }
    span.low = std::min(span.low, speed);
    span.high = std::max(span.high, speed);
  }
  return span;
}

std::string CommandCheck::measured(Time now, const WheelSpeeds& travel) {
  if (!travels_.empty() && travels_.back().time >= now) reset();
  travels_.push_back({now, travel});
  while ((now - travels_.front().time).to_seconds() > kSteady) travels_.pop_front();
  if (commands_.empty()) return {};
  const std::string fast = too_fast(now);
  return fast.empty() ? too_slow(now) : fast;
}

std::string CommandCheck::too_fast(Time now) {
  const auto before = std::ranges::find_if(travels_.rbegin(), travels_.rend(), [&](const Sample& sample) {
    return (now - sample.time).to_seconds() >= kWindow;
  });
  if (before == travels_.rend()) return {};
  const double seconds = (now - before->time).to_seconds();
  const double tolerance = 0.05 + 2.0 * metres_per_count_ / seconds;
  std::string found;
  for (const auto wheel : {&WheelSpeeds::left, &WheelSpeeds::right}) {
    const double speed = (travels_.back().value.*wheel - before->value.*wheel) / seconds;
    const Span span = commanded(now, wheel);
    if (speed >= 1.5 * span.low - tolerance && speed <= 1.5 * span.high + tolerance) continue;
    const std::string name = wheel == &WheelSpeeds::left ? "left" : "right";
    found = "the " + name + " wheel turns at " + speed_text(speed);
    const double meant = speed > 0.0 ? span.high : span.low;
    const double other = speed > 0.0 ? span.low : span.high;
    if (meant == 0.0 && other == 0.0) {
      found += " though it was told to stand";
    } else if (meant == 0.0) {
      found += " though it was told " + speed_text(other) + ": motor or encoder the wrong way round?";
    } else {
      found += " though it was told at most " + speed_text(meant);
      const double factor = speed / meant;
      if (factor > 1.6 && factor < 2.4)
        found += ", twice of that: does GOSPD count positions per half second (robot.base.positions_per)?";
    }
  }
  fast_in_a_row_ = found.empty() ? 0 : fast_in_a_row_ + 1;
  return fast_in_a_row_ >= kFastReadings ? found : std::string{};
}

std::string CommandCheck::too_slow(Time now) {
  const double seconds = (now - travels_.front().time).to_seconds();
  const WheelSpeeds newest = commands_.back().value;
  bool is_half = seconds > 0.8 * kSteady;
  for (const auto wheel : {&WheelSpeeds::left, &WheelSpeeds::right}) {
    const double command = newest.*wheel;
    for (std::size_t i = 0; i < commands_.size(); ++i) {
      const bool is_old =
          i + 1 < commands_.size() &&
          (now - commands_[i + 1].time).to_seconds() > kSteady + kShows + std::abs(command) / acceleration_;
      is_half &= is_old || std::abs(commands_[i].value.*wheel - command) <= 0.1 * std::abs(command);
    }
    const double speed = (travels_.back().value.*wheel - travels_.front().value.*wheel) / seconds;
    is_half &=
        std::abs(command) > 0.05 + 4.0 * metres_per_count_ && speed / command > 0.4 && speed / command < 0.6;
  }
  slow_in_a_row_ = is_half ? slow_in_a_row_ + 1 : 0;
  if (slow_in_a_row_ < kSlowReadings) return {};
  return "the wheels turn at half of the " + speed_text(std::max(newest.left, newest.right)) +
         " that they were told: does GOSPD count positions per second (robot.base.positions_per)?";
}

}  // namespace bw::eddie
