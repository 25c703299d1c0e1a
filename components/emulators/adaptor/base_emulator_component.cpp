// Adaptor of the emulated base: a firmware between a cable and the wheels of the simulated world. It lives in
// the world's time, one step with each reading of the encoders, so that what it sends is of that very moment.
// While the world is held up it says nothing: a board whose clock goes on and whose wheels do not is one that
// stalls.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/wheel_ticks.hpp>
#include <sensor_msgs/msg/joint_state.hpp>

#include "components/emulators/adaptor/emulator_options.hpp"
#include "components/emulators/adaptor/true_body.hpp"
#include "components/emulators/faulty_line.hpp"
#include "components/messages/wheel_joints.hpp"
#include "runtime/component.hpp"
#include "runtime/serial/device_link.hpp"

namespace bw {
namespace {

using namespace emulators;

constexpr Duration kBehind = Duration::milliseconds(15);  // with --emulate the world comes every 10 ms

class BaseEmulatorComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<BaseEmulatorOptions>(
        [this](const BaseEmulatorOptions& changed, const Tick&) { options_.faults = changed.faults; },
        {"eddie"});
    robot_ = setup.shared<Robot>("robot");
    firmware_ = make_firmware(options_, robot_, robot_.base.driver, setup.seed());
    unknown_device_ =
        make_firmware(options_, robot_, robot_.base.driver == "eddie" ? "kobuki" : "eddie", setup.seed());
    line_.emplace(setup.seed() + 1);
    link_ = emulator_link(setup, "base");
    body_.emplace(setup, inscribed_radius(robot_.outline()), options_.kBumperGap, firmware_->beams());
    wheels_ = setup.command<sensor_msgs::msg::JointState>("sim/wheel_commands");
    setup.input<bandwagon_msgs::msg::WheelTicks>("sim/wheel_ticks", Qos::standard(),
                                                 [this](const auto& ticks, const Tick& tick) {
                                                   body_->count(ticks.left(), ticks.right());
                                                   step(from_stamp(ticks.header().stamp()), tick.now);
                                                 });
    // A board answers within milliseconds.
    setup.every(Duration::milliseconds(5), "line",
                [this](const Tick& tick) { listen(tick.now, options_.faults); });
  }

  void deactivate(const Tick& tick) override { drive_wheels({}, tick.now); }

 private:
  EmulatedBase& answering(const Faults& faults) { return faults.other_model ? *unknown_device_ : *firmware_; }

  /// `now` is of the world, `real_now` of the component clock.
  void step(Time now, Time real_now) {
    if (last_step_ && now <= *last_step_) return;
    last_step_ = now;
    const Faults& faults = options_.faults;
    listen(real_now, faults);
    if (!faults.hung) send(answering(faults).step(now, seen_with(body_->now(), faults)), faults);
    drive_wheels(with_faults(firmware_->motors(), faults), now);
  }

  void listen(Time now, const Faults& faults) {
    plug(!faults.cable_pulled, now);
    if (last_step_ && now - *last_step_ > kBehind) return;  // the bytes wait
    const std::span<const std::uint8_t> heard = link_->read();
    const bool hears = !faults.cable_pulled && !faults.hung && !heard.empty();
    if (hears) send(answering(faults).receive(now, heard), faults);
  }

  void send(std::span<const std::uint8_t> bytes, const Faults& faults) {
    const std::span<const std::uint8_t> passed = line_->pass(bytes, faults);
    if (!passed.empty()) static_cast<void>(link_->write(passed));
  }

  void plug(bool is_plugged, Time now) {
    if (is_plugged) static_cast<void>(link_->update(now));
    if (!is_plugged && is_plugged_) link_->close(now, "cable pulled");
    is_plugged_ = is_plugged;
  }

  void drive_wheels(const WheelSpeeds& wheels, Time now) {
    if (!told_.is_due(wheels, now)) return;
    wheels_.publish(to_joint_state(wheels, {firmware_->wheel_radius(), firmware_->wheel_radius()}, now));
  }

  BaseEmulatorOptions options_;
  Robot robot_;
  std::unique_ptr<EmulatedBase> firmware_;
  std::unique_ptr<EmulatedBase> unknown_device_;  ///< of another model, in place of it
  std::optional<FaultyLine> line_;
  std::unique_ptr<ByteLink> link_;
  std::optional<TrueBody> body_;
  std::optional<Time> last_step_;  ///< of the world
  bool is_plugged_ = true;
  ToldWheels told_;
  Output<sensor_msgs::msg::JointState> wheels_;
};

}  // namespace

BW_COMPONENT(BaseEmulatorComponent, "base_emulator")

}  // namespace bw
