// One of several who want to drive, by priority: the highest that speaks is obeyed, alone, until it has been
// silent for its time-out. As twist_mux of ROS, but for hands: whom a hand took over from, or whoever has a
// goal meanwhile, is not heard again before a release or another goal, so that a robot that somebody moved
// away by hand does not set off when they let go.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/twist_mux/twist_mux_options.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/stamp_age.hpp"
#include "runtime/base/time.hpp"

namespace bw {

class TwistMux {
 public:
  /// What came of the commands of one source.
  struct Count {
    std::uint64_t passed = 0;
    std::uint64_t outranked = 0;    ///< somebody of higher priority drives
    std::uint64_t interrupted = 0;  ///< a hand has driven, and nobody has released it
    std::uint64_t not_finite = 0;   ///< refused
    std::uint64_t stale = 0;        ///< refused for their stamps
    StampAge last_stale;            ///< the last of these
    std::uint64_t steps = 0;        ///< of clocks that stamp them
  };

  /// `options` keep their rule.
  explicit TwistMux(const TwistMuxOptions& options);

  /// A command of source i (index in the options), with the stamp if it has one, and by whose clock. What was
  /// heard after `now`, as before a clock went back, is forgotten. What goes on to the robot, if anything:
  /// the command itself, or zero when the source that drives sends what is no number.
  std::optional<Twist2> command(Time now, std::size_t i, const Twist2& twist,
                                std::optional<Time> stamp = std::nullopt, const StampSource& writer = {});
  /// To be called every few milliseconds. Zero, once, when the source that drives has been silent for its
  /// time-out and left the robot moving.
  std::optional<Twist2> check(Time now);
  /// Whether somebody who is not a hand has a goal in hand.
  void set_goal(bool is_in_hand) { has_goal_ = is_in_hand; }
  /// The deliberate restart: who was interrupted is heard again.
  void release() { interrupted_below_.reset(); }
  bool is_interrupted() const { return interrupted_below_.has_value(); }

  /// Index of the source that drives; nothing when nobody does.
  std::optional<std::size_t> active(Time now) const;
  const Count& count(std::size_t i) const { return counts_[i]; }

 private:
  void see(Time now);
  bool is_within(Time now, std::size_t i, double seconds) const;
  /// The source that is heard instead of i; nothing: none is.
  std::optional<std::size_t> who_outranks(Time now, std::size_t i) const;
  /// Whom hand i finds driving, or with a goal, is interrupted.
  void take_over(Time now, std::size_t i);
  void interrupt_below(std::int64_t priority);

  std::vector<TwistSourceOptions> sources_;
  std::vector<std::optional<Time>> heard_;  ///< the newest command of each that was passed on
  std::vector<StampAges> stamps_;
  std::vector<Count> counts_;
  std::optional<std::size_t> last_;  ///< whose command went on last
  bool is_moving_ = false;           ///< what went on last was not zero
  bool has_goal_ = false;
  std::optional<std::int64_t> interrupted_below_;  ///< sources of lower priority that are no hands
};

}  // namespace bw
