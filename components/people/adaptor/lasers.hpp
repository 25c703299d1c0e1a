// The lasers that look for people: each with its topic and a detector of its own, for what has long stood is
// as that one sees it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/people/adaptor/scan_order.hpp"
#include "components/people/detector/detector.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw::people {

class Lasers {
 public:
  /// `on_scan` is called when one has come and waits.
  void listen(Setup& setup, const std::vector<std::string>& topics, const DetectorOptions& options,
              std::function<void(const Tick&)> on_scan);
  void set_options(const DetectorOptions& options);

  ScanOrder& order() { return order_; }
  std::size_t count() const { return lasers_.size(); }
  const std::string& topic(std::size_t laser) const { return lasers_[laser].topic; }
  /// What the laser's detector makes of a sweep that is not refused.
  const DetectionSet& detect(std::size_t laser, const LaserSweep& sweep, const Surroundings& surroundings,
                             Time now);

  void refuse(std::size_t laser,
              const std::string& why);  ///< counts a scan that is not looked at, and says so once
  std::uint64_t refusals() const { return refusals_; }
  bool all_silent(Time now) const;
  /// Why scans are not looked at, of whichever laser; empty: all are.
  std::string complaint(Time now) const;

 private:
  struct Laser {
    std::string topic;
    std::unique_ptr<Detector> detector;
    Complaint refused{};            ///< why the last scan was not looked at
    std::optional<Time> last_look;  ///< on the component clock
  };
  bool is_silent(const Laser& laser, Time now) const;
  std::string of(const Laser& laser) const;

  std::vector<Laser> lasers_;
  ScanOrder order_;
  std::uint64_t refusals_ = 0;
  Logger log_;
};

}  // namespace bw::people
