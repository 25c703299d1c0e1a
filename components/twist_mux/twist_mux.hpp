// One of several who want to drive, by priority: the highest that speaks is obeyed, alone, until it has been silent for its
// time-out. As twist_mux of ROS, with a hold between two who drive.
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
    std::uint64_t outranked = 0;   ///< somebody of higher priority drives
    std::uint64_t not_finite = 0;  ///< refused
    std::uint64_t stale = 0;       ///< refused for their stamps
    StampAge last_stale;           ///< the last of these
    std::uint64_t steps = 0;       ///< of clocks that stamp them
  };

  /// `options` keep their rule.
  explicit TwistMux(const TwistMuxOptions& options);

  /// A command of source i (index in the options), with the stamp if it has one, and by whose clock. What was heard after `now`, as
  /// before a clock went back, is forgotten. What goes on to the robot, if anything: the command itself, or zero when the source
  /// that drives sends what is no number.
  std::optional<Twist2> command(Time now, std::size_t i, const Twist2& twist,
                                std::optional<Time> stamp = std::nullopt, const StampSource& writer = {});
  /// To be called every few milliseconds. Zero, once, when the source that drives has been silent for its time-out and left
  /// the robot moving.
  std::optional<Twist2> check(Time now);

  /// Index of the source that drives; nothing when nobody does.
  std::optional<std::size_t> active(Time now) const;
  const Count& count(std::size_t i) const { return counts_[i]; }

 private:
  void see(Time now);
  bool is_within(Time now, std::size_t i, double seconds) const;
  bool is_outranked(Time now, std::size_t i) const;

  std::vector<TwistSourceOptions> sources_;
  std::vector<std::optional<Time>> heard_;  ///< the newest command of each that was passed on
  std::vector<StampAges> stamps_;
  std::vector<Count> counts_;
  std::optional<std::size_t> last_;  ///< whose command went on last
  bool is_moving_ = false;           ///< what went on last was not zero
};

}  // namespace bw
