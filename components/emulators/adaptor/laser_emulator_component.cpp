// Adaptor of the emulated laser: the world's scan in, the bytes of an RPLIDAR out, over the device's end of
// the cable `laser`.
#include <memory>
#include <optional>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/emulators/rplidar/rplidar_device.hpp"
#include "runtime/component.hpp"
#include "runtime/serial/device_link.hpp"

namespace bw::emulators {
namespace {

constexpr Duration kStep = Duration::milliseconds(5);

struct LaserFaults {
  RplidarFaults faults;
  bool cable_pulled = false;

  template <class Visitor>
  void fields(Visitor& v) {
    faults.fields(v);
    v("cable_pulled", cable_pulled, {.doc = "nothing passes, in either direction"});
    v.retired({"from", "until"}, "section faults of the graph: kind parameters, from, for");
  }
};

struct LaserEmulatorOptions {
  RplidarDeviceOptions device;
  LaserFaults faults;

  template <class Visitor>
  void fields(Visitor& v) {
    device.fields(v);
    v("faults", faults, {.doc = "what is wrong with it"});
  }
};

}  // namespace

class LaserEmulatorComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    const auto options = setup.parameters<LaserEmulatorOptions>(
        [this](const LaserEmulatorOptions& changed, const Tick&) { faults_ = changed.faults; },
        {"rate", "sample_time", "spin_up"});
    faults_ = options.faults;
    device_.emplace(options.device, setup.seed());
    link_ = emulator_link(setup, "laser");
    scan_ = setup.latest<sensor_msgs::msg::LaserScan>("sim/scan", Qos::sensor());
    setup.every(kStep, "device", [this](const Tick& tick) { step(tick.now); });
  }

 private:
  void step(Time now) {
    const bool is_pulled = faults_.cable_pulled;
    device_->set_faults(faults_.faults);
    if (is_pulled && !was_pulled_) link_->close(now, "cable pulled");
    was_pulled_ = is_pulled;
    const bool is_open = !is_pulled && link_->update(now).is_open;
    if (is_open) device_->receive(now, link_->read());
    LaserView view;
    if (scan_) view = {scan_->angle_min(), scan_->angle_increment(), scan_->ranges()};
    const auto bytes = device_->step(now, view);
    if (is_open && !bytes.empty()) link_->write(bytes);
  }

  std::optional<RplidarDevice> device_;
  LaserFaults faults_;
  bool was_pulled_ = false;
  std::unique_ptr<ByteLink> link_;
  Latest<sensor_msgs::msg::LaserScan> scan_;
};

BW_COMPONENT(LaserEmulatorComponent, "laser_emulator")

}  // namespace bw::emulators
