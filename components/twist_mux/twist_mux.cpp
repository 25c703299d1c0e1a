#include "components/twist_mux/twist_mux.hpp"

#include <algorithm>
#include <cmath>

namespace bw {

TwistMux::TwistMux(const TwistMuxOptions& options)
    : sources_(options.sources),
      heard_(sources_.size()),
      stamps_(sources_.size()),
      counts_(sources_.size()) {}

std::optional<Twist2> TwistMux::command(Time now, std::size_t i, const Twist2& twist,
                                        std::optional<Time> stamp, const StampSource& writer) {
  see(now);
  if (!std::isfinite(twist.v) || !std::isfinite(twist.omega)) {
    ++counts_[i].not_finite;
    if (last_ != i || !is_moving_) return std::nullopt;
    is_moving_ = false;
    return Twist2{};
  }
  if (stamp && *stamp != Time{}) {
    const StampAge seen = stamps_[i].add(now, *stamp, writer, Duration::seconds(sources_[i].max_age));
    if (seen.has_stepped) ++counts_[i].steps;
    if (seen.fault != StampFault::none) {
      ++counts_[i].stale;
      counts_[i].last_stale = seen;
      return std::nullopt;
    }
  }
  const bool is_hand = sources_[i].hand;
  if (const auto other = who_outranks(now, i)) {
    ++counts_[i].outranked;
    if (sources_[*other].hand && !is_hand && twist != Twist2{}) interrupt_below(sources_[*other].priority);
    return std::nullopt;
  }
  if (is_hand) {
    take_over(now, i);
  } else if (interrupted_below_ && sources_[i].priority < *interrupted_below_) {
    ++counts_[i].interrupted;
    return std::nullopt;
  }
  ++counts_[i].passed;
  heard_[i] = now;
  last_ = i;
  is_moving_ = twist != Twist2{};
  return twist;
}

std::optional<Twist2> TwistMux::check(Time now) {
  see(now);
  if (!is_moving_ || is_within(now, *last_, sources_[*last_].timeout)) return std::nullopt;
  is_moving_ = false;
  return Twist2{};
}

std::optional<std::size_t> TwistMux::active(Time now) const {
  if (!last_ || !is_within(now, *last_, sources_[*last_].timeout)) return std::nullopt;
  return last_;
}

void TwistMux::see(Time now) {
  for (std::optional<Time>& heard : heard_) {
    if (heard && *heard > now) heard.reset();  // the clock went back
  }
}

bool TwistMux::is_within(Time now, std::size_t i, double seconds) const {
  return heard_[i] && *heard_[i] <= now && now - *heard_[i] <= Duration::seconds(seconds);
}

std::optional<std::size_t> TwistMux::who_outranks(Time now, std::size_t i) const {
  for (std::size_t other = 0; other < sources_.size(); ++other) {
    const TwistSourceOptions& source = sources_[other];
    if (source.priority > sources_[i].priority && is_within(now, other, source.timeout)) return other;
  }
  return std::nullopt;
}

void TwistMux::take_over(Time now, std::size_t i) {
  bool is_driving = has_goal_;
  for (std::size_t other = 0; other < sources_.size(); ++other) {
    const TwistSourceOptions& source = sources_[other];
    const bool is_below = !source.hand && source.priority < sources_[i].priority;
    is_driving = is_driving || (is_below && is_within(now, other, source.timeout));
  }
  if (is_driving) interrupt_below(sources_[i].priority);
}

void TwistMux::interrupt_below(std::int64_t priority) {
  interrupted_below_ = std::max(priority, interrupted_below_.value_or(priority));
}

}  // namespace bw
