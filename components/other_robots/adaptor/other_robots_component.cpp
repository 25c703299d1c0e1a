// Adaptor: tracks of people, other robots' odometry and scans in; tracks of people and robots out. Topics:
// README.md.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <fmt/format.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/messages/people.hpp"
#include "components/model/robot.hpp"
#include "components/other_robots/adaptor/other_robots_messages.hpp"
#include "components/other_robots/laser_follower.hpp"
#include "components/other_robots/robot_tracks.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::Track;
using bandwagon_msgs::msg::Tracks;

constexpr const char* kSilent = "nothing is heard of it";  // so at the start, which is no news
constexpr std::uint32_t kFirstId = 2'000'000'000;          // far from those of people

class OtherRobotsComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<OtherRobotsOptions>(
        [this](const OtherRobotsOptions& changed, const Tick&) { options_ = changed; }, {"robots"});
    own_radius_ = setup.shared<Robot>("robot").outline().radius;
    map_frame_ = setup.frame("map");
    base_frame_ = setup.frame("base_link");
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    transforms_ = setup.transforms();
    for (const std::string& robot : options_.robots)
      others_.push_back({.name = robot,
                         .odometry = setup.latest<nav_msgs::msg::Odometry>(
                             join_namespaces(join_namespaces("", robot), "odometry/filtered"), Qos::sensor(),
                             Need::optional),
                         .fault = Complaint(kSilent)});
    scan_ = setup.latest<sensor_msgs::msg::LaserScan>("scan", Qos::sensor(), Need::optional);
    tracks_ = setup.output<Tracks>("tracks");
    setup.input<Tracks>("people_tracks", Qos::standard(), [this](const auto& message, const Tick& tick) {
      tracks_.publish(with_robots(message, tick.now));
    });
  }

 private:
  struct Other {
    std::string name;
    Latest<nav_msgs::msg::Odometry> odometry;
    Complaint fault;              ///< why the laser alone tells of it
    LaserFollower follower = {};  ///< from its last word on
  };

  Tracks with_robots(Tracks message, Time now) {
    const std::string& frame = message.header().frame_id();
    const auto X_FM = transforms_->lookup_planar(frame, map_frame_);
    const Time seen = from_stamp(message.header().stamp());
    const double radius = options_.radius > 0.0 ? options_.radius : own_radius_;
    std::vector<TrackedPerson> robots;
    for (std::size_t i = 0; i < others_.size(); ++i) {
      Other& other = others_[i];
      const std::uint32_t id = kFirstId + static_cast<std::uint32_t>(i);
      if (is_usable(other, X_FM.has_value(), now)) {
        robots.push_back(robot_track(report_of(*other.odometry), *X_FM, seen, id, radius, options_));
        other.follower.start({seen, robots.back().position, robots.back().velocity});
      } else if (const auto disc = other.follower.follow(hits_at(seen, frame), radius, seen)) {
        robots.push_back(robot_track(disc->position, disc->velocity,
                                     disc->deviation * disc->deviation * Eigen::Matrix2d::Identity(), seen,
                                     id, radius, options_));
      }
    }
    // What the laser shows of such a robot is not somebody more.
    std::erase_if(message.tracks(), [&](const Track& track) {
      const Vector2 position(track.position().x(), track.position().y());
      return std::ranges::any_of(
          robots, [&](const Mover& robot) { return is_body_of(robot, position, options_.body_margin); });
    });
    const Tracks known = people::to_tracks(robots, message.header());
    message.tracks().insert(message.tracks().end(), known.tracks().begin(), known.tracks().end());
    tell(robots.size());
    return message;
  }

  std::vector<Vector2> hits_at(Time time, const std::string& frame) const {
    if (!scan_ || time_of(*scan_) != time) return {};
    const std::string& laser = scan_->header().frame_id();
    auto X_FL = transforms_->lookup_planar(frame, laser, time);
    if (!X_FL) X_FL = transforms_->lookup_planar(frame, laser);  // the newest is 20 ms older: 2 cm
    return X_FL ? hits_of(*scan_, *X_FL) : std::vector<Vector2>{};
  }

  bool is_usable(Other& other, bool is_placed, Time now) {
    std::string fault;
    if (!other.odometry || (now - other.odometry.received()).to_seconds() > options_.timeout) {
      fault = kSilent;
    } else if (other.odometry->child_frame_id() == base_frame_) {
      other.fault = Complaint();  // it is this robot itself
      return false;
    } else if (other.odometry->header().frame_id() != map_frame_) {
      fault =
          fmt::format("its pose is in '{}', not in '{}'", other.odometry->header().frame_id(), map_frame_);
    } else if (!is_placed) {
      fault = "this robot does not know its own place";
    } else {
      fault = fault_of(report_of(*other.odometry), now, options_);
    }
    if (other.fault.is_news(fault)) {
      if (fault.empty()) {
        log_.info("{} is seen by what it tells", other.name);
      } else {
        log_.warn("{} is seen by the laser alone: {}", other.name, fault);
      }
    }
    return fault.empty();
  }

  void tell(std::size_t used) {
    using Level = DiagnosticReporter::Level;
    diagnostics_->set_value("robots", std::to_string(used));
    const auto silent = std::ranges::find_if(others_, [](const Other& other) { return bool(other.fault); });
    if (silent == others_.end()) return diagnostics_->report(Level::ok, "all robots tell where they are");
    diagnostics_->report(Level::warn, silent->name + ": " + silent->fault.what());
  }

  OtherRobotsOptions options_;
  double own_radius_ = 0.0;
  std::vector<Other> others_;
  std::string map_frame_;
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Latest<sensor_msgs::msg::LaserScan> scan_;
  Output<Tracks> tracks_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
};

}  // namespace

BW_COMPONENT(OtherRobotsComponent, "other_robots")

}  // namespace bw
