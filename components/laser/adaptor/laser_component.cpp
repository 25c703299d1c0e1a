// Adaptor of the laser that the robot file chooses: bytes of its cable in, scans out. With `laser: {driver:
// none}` scans come from another program, or from the world, and this component has no ends at all.
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/laser/adaptor/laser_section.hpp"
#include "components/model/robot.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"
#include "runtime/serial/device_link.hpp"
#include "runtime/stamps.hpp"

namespace bw::laser {
namespace {

constexpr Duration kPoll = Duration::milliseconds(5);
constexpr Duration kReport = Duration::milliseconds(500);

}  // namespace

class LaserComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    const auto robot = setup.shared<Robot>("robot");
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    if (robot.laser.driver == "none") {
      diagnostics_->report(DiagnosticReporter::Level::ok, "scans come from another program");
      return;
    }
    section_ = read_laser_section(setup, robot);
    frame_ = setup.frame(section_.frame);
    link_ = device_link(setup, "laser", section_.cable);
    device_.emplace(section_.rplidar, *link_);
    scan_ = setup.output<sensor_msgs::msg::LaserScan>("scan");
    setup.every(kPoll, "cable", [this](const Tick& tick) { poll(tick.now); });
    setup.every(kReport, "health", [this](const Tick&) { report(device_->status()); });
  }

  void deactivate(const Tick& tick) override {
    if (device_) device_->stop(tick.now);
  }

 private:
  void poll(Time now) {
    for (const Revolution& revolution : device_->poll(now)) publish(to_scan(revolution, section_.scan));
    tell_news(device_->status());
  }

  void publish(const Scan& scan) {
    sensor_msgs::msg::LaserScan message;
    message.header().frame_id(frame_);
    message.header().stamp(to_stamp(scan.time));
    const double angle_max =
        -std::numbers::pi + scan.angle_increment * static_cast<double>(scan.ranges.size() - 1);
    message.angle_min(static_cast<float>(-std::numbers::pi));
    message.angle_max(static_cast<float>(angle_max));
    message.angle_increment(static_cast<float>(scan.angle_increment));
    message.time_increment(static_cast<float>(scan.time_increment));
    message.scan_time(static_cast<float>(scan.scan_time));
    message.range_min(static_cast<float>(section_.scan.range_min));
    message.range_max(static_cast<float>(section_.scan.range_max));
    message.ranges(scan.ranges);
    message.intensities(scan.qualities);
    scan_.publish(message);
  }

  /// Once when something is wrong, when it is something else, and when it is over.
  void tell_news(const RplidarStatus& status) {
    using Level = RplidarStatus::Level;
    if (!wrong_.is_news(status.level == Level::good ? "" : said(status))) return;
    if (status.level == Level::good) log_.info("laser {}: {}", section_.cable.port, device_->info()->text());
    if (status.is_starting) log_.info("{}", said(status));
    if (status.level == Level::warning && !status.is_starting) log_.warn("{}", said(status));
    if (status.level == Level::error) log_.error("{}", said(status));
    report(status);
  }

  std::string said(const RplidarStatus& status) const {
    return fmt::format("laser {}: {}", section_.cable.port, status.text);
  }

  void report(const RplidarStatus& status) {
    diagnostics_->report(static_cast<DiagnosticReporter::Level>(status.level), said(status));
    diagnostics_->set_value("rate", fmt::format("{:.2f} Hz", status.rate));
    diagnostics_->set_value("points", std::to_string(status.points));
    if (device_->info()) diagnostics_->set_value("device", device_->info()->text());
    for (const auto& [name, count] : status.counters) diagnostics_->set_value(name, std::to_string(count));
  }

  LaserSection section_;
  std::string frame_;
  std::unique_ptr<ByteLink> link_;
  std::optional<Rplidar> device_;
  Complaint wrong_{"nothing is heard yet"};
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  Output<sensor_msgs::msg::LaserScan> scan_;
};

BW_COMPONENT(LaserComponent, "laser")

}  // namespace bw::laser
