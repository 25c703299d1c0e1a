// What time it is for who listens: /clock where somebody publishes it, else the system's at each message.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <vector>

#include "runtime/remote/foxglove/wire_link.hpp"

namespace bw::foxglove {

class WireClock {
 public:
  explicit WireClock(WireLink& link) : link_(link) {}

  void look(const std::vector<dds::Endpoint>& endpoints);
  /// It is heard while somebody wants it.
  void want(bool is_wanted);

  /// False for a moment: /clock is there, and has said nothing yet.
  bool is_known();
  /// When it was, on the robot's clock, when a sample came in at `received` (system clock).
  Time time_of(Time received);
  /// Tells the listener, before what happened then. Of the system clock, which passes anyway, not every step.
  void tell(Time now);
  /// Tells the newest there is, should it be new.
  void tell_newest();
  /// There is a new listener.
  void forget_told() { told_ = Time{}; }

 private:
  void hear();
  void open_or_close();

  WireLink& link_;
  bool is_wanted_ = false;
  bool is_published_ = false;
  std::unique_ptr<dds::Reader> reader_;
  std::chrono::steady_clock::time_point opened_;
  dds::Sample sample_;
  std::map<Time, Time> steps_;  ///< when /clock said what
  Time told_;
};

}  // namespace bw::foxglove
