// The type-erased ends of topics: what the templates of component.hpp hand to the host, which alone knows
// lanes, clocks and DDS.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/time.hpp"

namespace bw {

/// Whether the inputs a component declared essential (graph: max_age, on_stale) are fresh.
enum class Health { ok, degraded, stop };

/// One call of a component: the frozen time and the state of its inputs. No other clock may be read.
struct Tick {
  Time now;
  Health health = Health::ok;  ///< stop: bring the robot to a safe stop in this very call
  std::uint64_t sequence = 0;  ///< counts the calls of this callback from 0
};

/// Names of a message type as the wire knows them.
struct MessageType {
  std::string_view ros_name;   ///< nav_msgs/msg/Odometry
  std::string_view dds_name;   ///< nav_msgs::msg::dds_::Odometry_
  std::string_view type_hash;  ///< RIHS01_...
};

class OutputPort {
 public:
  virtual ~OutputPort() = default;
  virtual void publish(std::span<const std::uint8_t> cdr) = 0;
  /// Somebody listens; a costly message may be skipped when nobody does. Always true in lock-step, so that
  /// runs stay equal.
  virtual bool has_readers() const = 0;
  std::vector<std::uint8_t> buffer;  ///< reused by Output::publish
};

/// Gives the bytes of one sample to the component; false when they do not hold the message.
using SampleHandler = std::function<bool(std::span<const std::uint8_t> cdr, const Tick& tick)>;
using TickHandler = std::function<void(const Tick& tick)>;

}  // namespace bw
