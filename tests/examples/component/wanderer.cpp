// Drives straight on, and turns on the spot while the laser sees something near ahead.
#include <algorithm>

#include <geometry_msgs/msg/twist.hpp>
#include <runtime/component.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

using geometry_msgs::msg::Twist;
using sensor_msgs::msg::LaserScan;

struct WandererOptions {
  double speed = 0.3;
  double clearance = 1.0;

  void fields(auto& v) {
    v("speed", speed, {.unit = "m/s", .min = 0, .max = 1, .doc = "while the way is free"});
    v("clearance", clearance, {.unit = "m", .min = 0.1, .max = 10, .doc = "turns while something is nearer"});
  }
};

class Wanderer final : public bw::Component {
  void configure(bw::Setup& setup) override {
    options_ = setup.parameters<WandererOptions>();
    cmd_vel_ = setup.command<Twist>("cmd_vel");
    setup.input<LaserScan>("scan", bw::Qos::sensor(), [this](const LaserScan& scan, const bw::Tick&) {
      const auto& ranges = scan.ranges();
      const auto aside = static_cast<std::ptrdiff_t>(ranges.size() / 3);
      const bool is_free = std::none_of(ranges.begin() + aside, ranges.end() - aside,
                                        [this](float range) { return range < options_.clearance; });
      Twist twist;
      is_free ? twist.linear().x(options_.speed) : twist.angular().z(0.5);
      cmd_vel_.publish(twist);
    });
  }

  WandererOptions options_;
  bw::Output<Twist> cmd_vel_;
};

BW_COMPONENT(Wanderer, "wanderer")
