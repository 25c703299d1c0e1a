// Adaptor: scans, odometry and what other detectors tell in; tracked people with predictions out. Topics:
// README.md.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <people_msgs/msg/people.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/map_input.hpp"
#include "components/messages/people.hpp"
#include "components/people/adaptor/detection_markers.hpp"
#include "components/people/adaptor/lasers.hpp"
#include "components/people/adaptor/other_detectors.hpp"
#include "components/people/people_parameters.hpp"
#include "components/people/prediction/predictor.hpp"
#include "components/people/tracker/tracker.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/sensor_mounts.hpp"

namespace bw::people {

class PeopleComponent final : public Component {
 public:
  void configure(Setup& setup) override;

 private:
  void on_odometry(const nav_msgs::msg::Odometry& message);
  /// Looks at the scans whose odometry has come, in order, and hears what others told until then.
  void look();
  void look_at(std::size_t laser, const sensor_msgs::msg::LaserScan& scan, const Pose2& X_OB);
  void hear();
  void publish(std::vector<TrackedPerson> people, Time stamp);
  /// What people walk round, in odom; nothing when the obstacles are too old or their position is unknown.
  StaticObstacles walls_at(Time time) const;
  void report_health(const Tick& tick);

  Lasers lasers_;
  OtherDetectors others_;
  std::unique_ptr<Tracker> tracker_;
  std::unique_ptr<Predictor> predictor_;
  std::int64_t refused_ = 0;                          ///< predictions not finite, when health was told last
  TransformTree odometry_;                            ///< of the last seconds
  Latest<bandwagon_msgs::msg::Obstacles> obstacles_;  ///< only for social_force
  double obstacles_timeout_ = 0.0;                    ///< [s]
  std::shared_ptr<const KnownMap> map_;
  Time tracked_at_;  ///< stamp of what the tracker took in last
  Time now_;

  std::string odom_frame_;
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  SensorMounts mounts_;
  Output<bandwagon_msgs::msg::Tracks> tracks_;
  Output<people_msgs::msg::People> people_;
  Output<visualization_msgs::msg::MarkerArray> people_markers_;
  Output<visualization_msgs::msg::MarkerArray> leg_markers_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
};

}  // namespace bw::people
