// A base: two wheels behind a serial cable. It is told "V LEFT RIGHT", rates in mrad/s, and says "T LEFT
// RIGHT", encoder counts.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <components/robot_base/driver_registry.hpp>
#include <runtime/serial/port_options.hpp>

struct TrolleyOptions : bw::PortOptions {
  double answer_time = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    PortOptions::fields(v);
    v("answer_time", answer_time,
      {.unit = "s", .min = 0.05, .max = 1, .doc = "silent for longer, it has a fault"});
  }
};

class Trolley final : public bw::Driver {
 public:
  Trolley(const TrolleyOptions& options, const bw::DriverContext& context)
      : patience_(bw::Duration::seconds(options.answer_time)),
        radii_(context.robot.wheel_radii()),
        link_(context.open_link(options, {'V', ' ', '0', ' ', '0', '\n'})) {}

  bw::Readings poll(bw::Time now) override {
    bw::Readings readings;
    readings.link = link_->update(now);
    for (const std::uint8_t byte : link_->read()) {
      constexpr std::size_t kLongest = 40;
      if (byte != '\n' && line_.size() < kLongest) line_ += static_cast<char>(byte);
      if (byte != '\n') continue;
      bw::EncoderCounts counts{.time = now};
      if (std::sscanf(line_.c_str(), "T %d %d", &counts.left, &counts.right) == 2)
        readings.counts.push_back(counts);
      line_.clear();
    }
    if (!readings.counts.empty()) heard_ = now;
    if (now - heard_ > patience_) readings.fault = "the trolley is silent";
    return readings;
  }

  bool command(bw::Time, const bw::WheelSpeeds& wheels) override {
    const std::string line = "V " + std::to_string(std::lround(1e3 * wheels.left / radii_.left)) + " " +
                             std::to_string(std::lround(1e3 * wheels.right / radii_.right)) + "\n";
    return link_->write(std::vector<std::uint8_t>(line.begin(), line.end()));
  }

 private:
  bw::Duration patience_;
  bw::WheelRadii radii_;
  std::unique_ptr<bw::ByteLink> link_;
  std::string line_;
  bw::Time heard_;
};

BW_DRIVER(Trolley, TrolleyOptions, "trolley")
