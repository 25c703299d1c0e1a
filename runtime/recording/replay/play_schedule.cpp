#include "runtime/recording/replay/play_schedule.hpp"

#include <algorithm>
#include <cmath>

namespace bw::replay {
namespace {

Duration scaled(Duration d, double factor) {
  return {std::llround(static_cast<double>(d.nanoseconds) * factor)};
}

}  // namespace

PlaySchedule::PlaySchedule(const PlayScheduleOptions& options, Duration now)
    : rate_(options.rate),
      clock_hz_(options.clock_hz),
      is_paused_(options.is_paused),
      anchor_(options.start),
      anchored_at_(now),
      clock_start_(now) {}

void PlaySchedule::anchor(Time position, Duration now) {
  anchor_ = position;
  anchored_at_ = now;
}

void PlaySchedule::set_paused(bool is_paused, Duration now) {
  anchor(position(now), now);
  is_paused_ = is_paused;
}

void PlaySchedule::set_rate(double rate, Duration now) {
  if (rate_ == 0.0) return;
  anchor(position(now), now);
  rate_ = rate;
}

Time PlaySchedule::position(Duration now) const {
  if (is_paused_ || rate_ == 0.0) return anchor_;
  return anchor_ + scaled(now - anchored_at_, rate_);
}

std::optional<Duration> PlaySchedule::due(Time message) const {
  if (is_paused_) return std::nullopt;
  return anchored_at_ + scaled(message - anchor_, 1.0 / rate_);
}

std::optional<Duration> PlaySchedule::next_tick() const {
  if (clock_hz_ <= 0.0) return std::nullopt;
  return clock_start_ + Duration::seconds(static_cast<double>(clock_ticks_) / clock_hz_);
}

PlayStep PlaySchedule::next(Time message, Duration now) {
  if (is_stepping_) {
    is_stepping_ = false;
    anchor(std::max(message, position(now)), now);
    return {PlayStep::What::message};
  }
  if (rate_ == 0.0) return next_unlimited(message, now);
  const std::optional<Duration> message_due = due(message);
  const std::optional<Duration> tick = next_tick();
  if (tick && *tick <= now && (!message_due || *tick <= *message_due)) {
    // Ticks that were missed become one.
    const double passed = (now - clock_start_).to_seconds() * clock_hz_;
    clock_ticks_ = std::max(clock_ticks_, static_cast<std::int64_t>(std::floor(passed))) + 1;
    return {PlayStep::What::clock};
  }
  if (message_due && *message_due <= now)
    return {.what = PlayStep::What::message, .late = now - *message_due};
  if (message_due && tick) return {PlayStep::What::wait, std::min(*message_due, *tick)};
  return {PlayStep::What::wait, message_due ? message_due : tick};
}

PlayStep PlaySchedule::next_unlimited(Time message, Duration now) {
  if (is_paused_) return {PlayStep::What::wait};
  anchor(std::max(anchor_, message), now);
  if (clock_hz_ > 0.0 && (!last_clock_ || (anchor_ - *last_clock_).to_seconds() * clock_hz_ >= 1.0)) {
    last_clock_ = anchor_;
    return {PlayStep::What::clock};
  }
  return {PlayStep::What::message};
}

}  // namespace bw::replay
