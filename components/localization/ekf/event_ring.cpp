#include "components/localization/ekf/event_ring.hpp"

#include <numeric>
#include <tuple>
#include <utility>

namespace bw::localization {
namespace {

auto rank(const Measurement& m) { return std::tuple(stamp(m), m.index(), source(m)); }

}  // namespace

EventRing::EventRing(const Fusion& fusion, Duration window, int capacity, int sources)
    : fusion_(fusion),
      window_(window),
      events_(static_cast<std::size_t>(capacity)),
      order_(static_cast<std::size_t>(capacity)) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  base_.sources.resize(static_cast<std::size_t>(sources));
  for (Event& event : events_) event.after = base_;
}

void EventRing::restart(const EkfState& state) {
  base_ = state;
  base_stamp_ = state.time;
  size_ = 0;
}

void EventRing::drop_first() {
  std::swap(base_, at(0).after);
  base_stamp_ = stamp(at(0).measurement);
  first_ = (first_ + 1) % static_cast<int>(order_.size());
  --size_;
}

EventRing::Insertion EventRing::insert(const Measurement& measurement) {
  const Time time = stamp(measurement);
  const Time newest_stamp = size_ == 0 ? base_stamp_ : stamp(at(size_ - 1).measurement);
  if (time < base_stamp_ || time < newest_stamp - window_) return {{Verdict::too_old}};

  int position = size_;
  const auto key = rank(measurement);
  while (position > 0 && key < rank(at(position - 1).measurement)) --position;
  if (position > 0 && key == rank(at(position - 1).measurement)) return {{Verdict::duplicate}};

  if (size_ == static_cast<int>(order_.size())) {
    if (position == 0) return {{Verdict::too_old}};
    drop_first();
    --position;
    ++squeezed_out_;
  }
  const std::size_t slot = order_[index(size_)];
  for (int i = size_; i > position; --i) order_[index(i)] = order_[index(i - 1)];
  order_[index(position)] = slot;
  ++size_;
  events_[slot].measurement = measurement;

  Insertion insertion;
  for (int i = position; i < size_; ++i) {
    Event& event = at(i);
    event.after = i == 0 ? base_ : at(i - 1).after;
    const FusionResult result = fusion_.apply(event.after, event.measurement);
    if (i == position) insertion.result = result;
  }
  insertion.replayed = size_ - 1 - position;
  while (size_ > 1 && stamp(at(size_ - 1).measurement) - stamp(at(0).measurement) > window_) drop_first();
  return insertion;
}

}  // namespace bw::localization
