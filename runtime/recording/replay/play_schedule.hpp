// When what is due, while a bag is played in real time: pure arithmetic between the bag's time and a steady
// clock. Every due time is reckoned from one anchor, so that nothing adds up over an hour.
#pragma once

#include <cstdint>
#include <optional>

#include "runtime/base/time.hpp"

namespace bw::replay {

struct PlayScheduleOptions {
  Time start;              ///< bag time at which it begins
  double rate = 1.0;       ///< bag seconds per second; 0: as fast as possible
  double clock_hz = 0.0;   ///< /clock so many times a second, also while it is paused; 0: never
  bool is_paused = false;  ///< at the beginning
};

struct PlayStep {
  enum class What {
    message,  ///< the next message is due
    clock,    ///< /clock is due, with position()
    wait,     ///< nothing before `until`
  };
  What what = What::wait;
  std::optional<Duration> until = std::nullopt;  ///< steady clock; nothing: until somebody presses a key
  Duration late{};                               ///< of a message: that long ago it was due
};

class PlaySchedule {
 public:
  /// `now`, here and below: the steady clock.
  PlaySchedule(const PlayScheduleOptions& options, Duration now);

  /// What is due at `now`, when the next message was recorded at `message`. A message or clock that it names
  /// counts as given. At rate 0 the clock goes by the bag's time.
  PlayStep next(Time message, Duration now);

  /// The next message is due at once, also while it is paused, and the bag's time jumps to it.
  void step() { is_stepping_ = true; }
  void set_paused(bool is_paused, Duration now);
  /// Above 0. Changes nothing at rate 0.
  void set_rate(double rate, Duration now);

  [[nodiscard]] Time position(Duration now) const;
  [[nodiscard]] bool is_paused() const { return is_paused_; }
  [[nodiscard]] double rate() const { return rate_; }

 private:
  void anchor(Time position, Duration now);
  [[nodiscard]] std::optional<Duration> due(Time message) const;
  [[nodiscard]] std::optional<Duration> next_tick() const;
  PlayStep next_unlimited(Time message, Duration now);

  double rate_;
  double clock_hz_;
  bool is_paused_;
  bool is_stepping_ = false;
  Time anchor_;           ///< bag time at ...
  Duration anchored_at_;  ///< ... this steady time
  Duration clock_start_;
  std::int64_t clock_ticks_ = 0;    ///< given so far
  std::optional<Time> last_clock_;  ///< bag time of the last tick at rate 0
};

}  // namespace bw::replay
