// Measurements of the last seconds in the order of their stamps, each with the state after it. A late one
// goes to its place, and what follows is computed again from there. Memory is taken once, at construction.
#pragma once

#include <vector>

#include "components/localization/ekf/fusion.hpp"

namespace bw::localization {

class EventRing {
 public:
  /// Fusion must outlive the ring.
  EventRing(const Fusion& fusion, Duration window, int capacity, int sources);

  /// Forgets all measurements and goes on from `state`.
  void restart(const EkfState& state);

  struct Insertion {
    FusionResult result;
    int replayed = 0;  ///< measurements computed again behind this one
  };
  /// Verdict::too_old when stamped before the window or before the state the ring started from;
  /// Verdict::duplicate when kind, source and stamp are there already. Measurements of one stamp are ordered
  /// by kind and source: the result does not depend on the order of arrival.
  Insertion insert(const Measurement& measurement);

  /// State after all measurements.
  const EkfState& newest() const { return size_ == 0 ? base_ : at(size_ - 1).after; }
  int size() const { return size_; }
  /// Measurements that left before the window ended because capacity was short.
  std::uint64_t squeezed_out() const { return squeezed_out_; }

 private:
  struct Event {
    Measurement measurement;
    EkfState after;
  };

  Event& at(int i) { return events_[order_[index(i)]]; }
  const Event& at(int i) const { return events_[order_[index(i)]]; }
  std::size_t index(int i) const { return static_cast<std::size_t>(first_ + i) % order_.size(); }
  void drop_first();

  const Fusion& fusion_;
  Duration window_;
  EkfState base_;                   // state before the first event
  Time base_stamp_;                 // of the last event that left: nothing older can be put in order
  std::vector<Event> events_;       // slots, in no order
  std::vector<std::size_t> order_;  // circular: slots by stamp, unused slots behind the last
  int first_ = 0;
  int size_ = 0;
  std::uint64_t squeezed_out_ = 0;
};

}  // namespace bw::localization
