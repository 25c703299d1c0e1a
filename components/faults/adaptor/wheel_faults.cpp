// What goes wrong with the wheels of a simulated robot: between its base and the world. Encoders and floor then tell what a real
// robot's would.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <bandwagon_msgs/msg/wheel_ticks.hpp>
#include <sensor_msgs/msg/joint_state.hpp>

#include "runtime/base/choice.hpp"
#include "runtime/fault.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::WheelTicks;
using sensor_msgs::msg::JointState;

/// A counter that counts more than the floor gives: what the wheel rotated. It keeps what it has gained, and wraps.
class SlippingCount {
 public:
  std::int32_t next(std::int32_t true_count, double gain) {
    if (last_) {
      const auto step = static_cast<std::int32_t>(static_cast<std::uint32_t>(true_count) -
                                                  static_cast<std::uint32_t>(*last_));
      gained_ += (gain - 1.0) * step;
    }
    last_ = true_count;
    const auto whole = static_cast<std::int64_t>(std::llround(gained_));
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(true_count) +
                                     static_cast<std::uint32_t>(whole));
  }

 private:
  std::optional<std::int32_t> last_;
  double gained_ = 0.0;
};

struct SlipParameters {
  double left = 0.5, right = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("left", left,
      {.min = 0, .max = 0.95, .doc = "share of the wheel's rotation that the floor does not take"});
    v("right", right, {.min = 0, .max = 0.95, .doc = "likewise"});
  }
};

/// What the floor takes of a wheel's rotation. A robot has mass: its speed follows within half a second.
double grip(double slip, const FaultTick& tick) {
  constexpr double kOnset = 0.5;  // [s]
  return tick.acts ? 1.0 - slip * std::min(1.0, tick.since.to_seconds() / kOnset) : 1.0;
}

struct WheelSlip final : Fault {
  void configure(FaultSetup& setup) override {
    const auto slip = setup.parameters<SlipParameters>();
    setup.held_messages<JointState>("sim/wheel_commands", [slip](JointState& wheels, const FaultTick& tick) {
      if (wheels.velocity().size() != 2) return kPasses;
      wheels.velocity()[0] *= grip(slip.left, tick);
      wheels.velocity()[1] *= grip(slip.right, tick);
      return kPasses;
    });
    setup.all_messages<WheelTicks>("sim/wheel_ticks", [this, slip](WheelTicks& ticks, const FaultTick& tick) {
      ticks.left(left_.next(ticks.left(), 1.0 / grip(slip.left, tick)));
      ticks.right(right_.next(ticks.right(), 1.0 / grip(slip.right, tick)));
      return kPasses;
    });
  }
  SlippingCount left_, right_;
};

enum class Wheel : std::uint8_t { left, right };

constexpr auto choice_table(Wheel) {
  return choices<Wheel>({{Wheel::left, "left"}, {Wheel::right, "right"}});
}

struct StallParameters {
  Wheel wheel = Wheel::left;

  template <class Visitor>
  void fields(Visitor& v) {
    v("wheel", wheel, {.doc = "left or right"});
  }
};

struct WheelStalled final : Fault {
  void configure(FaultSetup& setup) override {
    const auto wheel = static_cast<std::size_t>(setup.parameters<StallParameters>().wheel);
    setup.held_messages<JointState>("sim/wheel_commands", [wheel](JointState& wheels, const FaultTick&) {
      if (wheels.velocity().size() == 2) wheels.velocity()[wheel] = 0.0;
      return kPasses;
    });
  }
};

}  // namespace

BW_FAULT(WheelSlip, "wheel_slip", "wheels rotate as told and the robot moves less (simulated robots)")
BW_FAULT(WheelStalled, "wheel_stalled", "one wheel stands whatever it is told (simulated robots)")

}  // namespace bw
