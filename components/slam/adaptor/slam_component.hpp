// Adaptor: odometry and scans in; pose, map->odom and a map that grows out. Topics: README.md.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/model/obstacles.hpp"
#include "components/slam/adaptor/map_output.hpp"
#include "components/slam/map_odom.hpp"
#include "components/slam/map_painter.hpp"
#include "components/slam/odometry_history.hpp"
#include "components/slam/slam.hpp"
#include "components/slam/slam_parameters.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/sensor_mounts.hpp"

namespace bw::slam {

class SlamComponent final : public Component {
 public:
  void configure(Setup& setup) override;
  void activate(const Tick& tick) override;
  void deactivate(const Tick& tick) override;

 private:
  void offer_services(Setup& setup);
  void begin_map();
  void on_odometry(const nav_msgs::msg::Odometry& message, const Tick& tick);
  void on_scan(const sensor_msgs::msg::LaserScan& message);
  void use_waiting_scans();
  void use(const sensor_msgs::msg::LaserScan& message);
  /// Discs in odom.
  std::vector<Disc> people_at(Time time) const;
  void publish_map();
  void gather_map();
  void report();
  nav_msgs::msg::OccupancyGrid map_message(Time stamp) const;

  SlamParameters parameters_;
  std::filesystem::path folder_;
  Pose2 X_MW_;  ///< where the first scan was taken, in map
  std::unique_ptr<Slam> slam_;
  std::unique_ptr<MapPainter> painter_;
  OdometryHistory odometry_;
  MapToOdom map_to_odom_;
  std::deque<sensor_msgs::msg::LaserScan> waiting_;  ///< for odometry of their time
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  Time map_time_;               ///< of the newest scan in the map
  std::vector<MapTile> tiles_;  ///< of the map, to be published
  std::size_t to_gather_ = 0;   ///< tiles that are missing among them
  bool is_gathering_ = false;
  std::int64_t too_early_ = 0;  ///< scans that odometry did not reach
  std::int64_t told_too_early_ = 0;
  double inliers_ = 0.0;  ///< of the newest scan
  bool unseen_ = false;   ///< it does not show where the robot is along one direction
  bool paused_ = false;

  std::string map_frame_;
  std::string odom_frame_;
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  SensorMounts mounts_;
  Latest<bandwagon_msgs::msg::Tracks> tracks_;
  Output<nav_msgs::msg::Odometry> filtered_;
  Output<tf2_msgs::msg::TFMessage> tf_;
  Output<geometry_msgs::msg::PoseWithCovarianceStamped> pose_;
  MapOutput map_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
};

}  // namespace bw::slam
