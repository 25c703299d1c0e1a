#include "components/robot_base/kobuki/board_clock.hpp"

#include <algorithm>
#include <cstddef>

namespace bw::kobuki {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;
constexpr Duration kSooner = Duration::milliseconds(100);  ///< than any before: no delay that ended

}  // namespace

std::int64_t BoardClock::unwrap(std::uint16_t stamp, Time arrival) const {
  if (!newest_) return stamp * kMillisecond;
  const std::int64_t expected = (arrival - newest_->arrival).nanoseconds / kMillisecond;
  const auto difference = static_cast<std::uint16_t>(stamp - newest_->stamp);
  const auto beside = static_cast<std::int16_t>(static_cast<std::uint16_t>(difference - expected));
  return newest_->board + (expected + beside) * kMillisecond;
}

/// `board`: the newest of what was read together.
void BoardClock::take(Time arrival, std::int64_t board, bool is_first, bool went_back) {
  const Duration least = clock_.least();
  if (went_back) clock_ = ForeignClock(ForeignClock::Delivery::direct);
  const bool has_stepped = clock_.add(arrival, Time{board}).has_stepped;
  const bool is_sooner = !is_first && clock_.least() < least - kSooner;
  if (!has_stepped && !went_back && !is_sooner) return;
  ++jumps_;
  may_step_ = true;
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
  take(arrival, went_back ? board.back() : *std::ranges::max_element(board), !before, went_back);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    Time time{board[i] + offset()};
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
