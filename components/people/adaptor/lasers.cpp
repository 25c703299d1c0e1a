#include "components/people/adaptor/lasers.hpp"

#include <algorithm>

#include "runtime/stamps.hpp"

namespace bw::people {
namespace {

constexpr Duration kSilence = Duration::milliseconds(500);

}  // namespace

void Lasers::listen(Setup& setup, const std::vector<std::string>& topics, const DetectorOptions& options,
                    std::function<void(const Tick&)> on_scan) {
  log_ = setup.log();
  order_ = ScanOrder(topics.size());
  for (const std::string& topic : topics)
    lasers_.push_back({.topic = topic, .detector = std::make_unique<Detector>(options)});
  for (std::size_t i = 0; i < topics.size(); ++i)
    setup.input<sensor_msgs::msg::LaserScan>(
        topics[i], Qos::sensor(),
        [this, i, on_scan](const sensor_msgs::msg::LaserScan& scan, const Tick& tick) {
          if (from_stamp(scan.header().stamp()) == Time{}) return refuse(i, "it has no stamp");
          if (!order_.add(i, scan, tick.now)) refuse(i, "no odometry at its stamp");
          on_scan(tick);
        });
}

void Lasers::set_options(const DetectorOptions& options) {
  for (Laser& laser : lasers_) laser.detector->set_options(options);
}

const DetectionSet& Lasers::detect(std::size_t laser, const LaserSweep& sweep,
                                   const Surroundings& surroundings, Time now) {
  Laser& own = lasers_[laser];
  if (own.refused.is_news("")) log_.info("scans{} are sound again", of(own));
  own.last_look = now;
  return own.detector->detect(sweep, surroundings);
}

void Lasers::refuse(std::size_t laser, const std::string& why) {
  ++refusals_;
  if (lasers_[laser].refused.is_news(why))
    log_.warn("a scan{} is not looked at: {}", of(lasers_[laser]), why);
}

bool Lasers::is_silent(const Laser& laser, Time now) const {
  return !laser.last_look || now - *laser.last_look > kSilence;
}

bool Lasers::all_silent(Time now) const {
  return std::ranges::all_of(lasers_, [&](const Laser& laser) { return is_silent(laser, now); });
}

/// Nothing needs to be said of the only one.
std::string Lasers::of(const Laser& laser) const {
  return lasers_.size() > 1 ? " of '" + laser.topic + "'" : "";
}

std::string Lasers::complaint(Time now) const {
  for (const Laser& laser : lasers_)
    if (laser.refused) return "scans" + of(laser) + " are refused: " + laser.refused.what();
  for (const Laser& laser : lasers_)
    if (is_silent(laser, now)) return "no scan" + of(laser) + " to look at";
  return {};
}

}  // namespace bw::people
