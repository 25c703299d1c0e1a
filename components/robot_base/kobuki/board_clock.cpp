#include "components/robot_base/kobuki/board_clock.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace bw::kobuki {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;
constexpr std::int64_t kSooner = 100 * kMillisecond;
constexpr std::int64_t kLater = 1000 * kMillisecond;
constexpr std::int64_t kLaterForLong = 50 * kMillisecond;
constexpr std::int64_t kRise = 20 * kMillisecond;  ///< at most, in a silence however long
constexpr Duration kWindow = Duration::milliseconds(1000);
constexpr int kEnough = 10;  ///< arrivals in a window that are no single delay

}  // namespace

std::int64_t BoardClock::unwrap(std::uint16_t stamp, Time arrival) const {
  if (!newest_) return stamp * kMillisecond;
  const std::int64_t expected = (arrival - newest_->arrival).nanoseconds / kMillisecond;
  const auto difference = static_cast<std::uint16_t>(stamp - newest_->stamp);
  const auto beside = static_cast<std::int16_t>(static_cast<std::uint16_t>(difference - expected));
  return newest_->board + (expected + beside) * kMillisecond;
}

void BoardClock::begin(Time arrival, std::int64_t sample) {
  offset_ = window_least_ = sample;
  window_start_ = arrival;
  window_arrivals_ = 1;
  may_step_ = true;
}

/// `sample`: the least arrival minus stamp of what was read together.
void BoardClock::take(Time arrival, std::int64_t sample, bool went_back) {
  if (!taken_) {
    begin(arrival, sample);
    taken_ = arrival;
    return;
  }
  const double seconds = std::max(0.0, (arrival - *taken_).to_seconds());
  taken_ = arrival;
  offset_ += std::min(static_cast<std::int64_t>(kDriftMax * seconds * 1e9), kRise);
  if (went_back || sample < offset_ - kSooner || sample > offset_ + kLater) {
    ++jumps_;
    begin(arrival, sample);
    return;
  }
  offset_ = std::min(offset_, sample);
  window_least_ = std::min(window_least_, sample);
  ++window_arrivals_;
  if (arrival - window_start_ < kWindow) return;
  if (window_arrivals_ >= kEnough && window_least_ > offset_ + kLaterForLong) {
    ++jumps_;
    begin(arrival, window_least_);
  }
  window_start_ = arrival;
  window_arrivals_ = 0;
  window_least_ = std::numeric_limits<std::int64_t>::max();
}

std::vector<Time> BoardClock::times(Time arrival, std::span<const std::uint16_t> stamps) {
  std::vector<Time> times(stamps.size());
  if (stamps.empty()) return times;
  std::vector<std::int64_t> board;
  std::optional<Newest> before = newest_;
  bool went_back = false;
  for (const std::uint16_t stamp : stamps) {
    const std::int64_t unwrapped = unwrap(stamp, arrival);
    went_back |= newest_ && unwrapped < newest_->board;
    newest_ = {stamp, unwrapped, arrival, Time{}};
    board.push_back(unwrapped);
  }
  take(arrival, arrival.nanoseconds - (went_back ? board.back() : *std::ranges::max_element(board)),
       went_back);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    Time time{board[i] + offset_};
    // A lower offset must not squeeze what was measured evenly.
    if (before && !may_step_) {
      const auto elapsed = std::max<std::int64_t>(board[i] - before->board, 0);
      time = std::max(time, before->time + Duration{elapsed / 4 * 3});
    }
    may_step_ = false;
    times[i] = time;
    before = Newest{stamps[i], board[i], arrival, time};
  }
  newest_ = before;
  return times;
}

}  // namespace bw::kobuki
