// Adaptor: odometry and scans in; pose, map->odom and a map that grows out. Topics: README.md.
#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/model/obstacles.hpp"
#include "components/slam/adaptor/map_output.hpp"
#include "components/slam/graph_file.hpp"
#include "components/slam/map_odom.hpp"
#include "components/slam/map_painter.hpp"
#include "components/slam/odometry_history.hpp"
#include "components/slam/relocalization.hpp"
#include "components/slam/slam.hpp"
#include "components/slam/slam_health.hpp"
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
  void offer_graph_services(Setup& setup);
  /// A file of the map. `take`: what is to be written, as the work that is left for another thread; called when all
  /// work on loops is done.
  void save(std::function<std::function<void()>()> take);
  void write_next();
  /// Some pieces of that work, if a file is asked for.
  void advance_saves();
  /// All that is asked for, here and now.
  void finish_saves();
  void begin_map();
  void set_slam(std::unique_ptr<Slam> slam);
  /// Goes on with a map that was saved: where the robot is in it is looked for, about X_MB if that is given.
  void continue_map(SavedGraph graph, const std::optional<Pose2>& X_MB);
  void on_initial_pose(const geometry_msgs::msg::PoseWithCovarianceStamped& message);
  /// True when the robot's place is found, and the map goes on from there.
  bool find_place(const Scan& scan, const Pose2& X_OB);
  void begin_at(const Place& place);
  std::string doubt() const;
  void on_odometry(const nav_msgs::msg::Odometry& message, const Tick& tick);
  void on_scan(const sensor_msgs::msg::LaserScan& message);
  void use_waiting_scans();
  void use(const sensor_msgs::msg::LaserScan& message);
  void take_in(const Scan& scan, const Pose2& X_OB);
  /// Discs in odom.
  std::vector<Disc> people_at(Time time) const;
  void publish_map();
  void gather_map();
  void publish_graph();
  void report(Time now);

  SlamParameters parameters_;
  std::filesystem::path folder_;
  SlamOptions options_;  ///< of the map under way: a saved one brings its resolution
  Pose2 X_MW_;           ///< where the first scan was taken, in map
  std::unique_ptr<Slam> slam_;
  std::unique_ptr<MapPainter> painter_;
  OdometryHistory odometry_;
  MapToOdom map_to_odom_;
  bool is_told_ = false;  ///< map->odom
  bool jumps_ = true;     ///< the next scan begins a drive
  std::optional<Scan> newest_;
  Pose2 newest_X_OB_;
  // Between a map that was read and the robot's place in it.
  bool looks_for_place_ = false;
  std::optional<Pose2> given_;       ///< X_MB, for the next scan
  std::optional<Pose2> given_X_MO_;  ///< as it follows from that
  std::unique_ptr<PlaceSearch> search_;
  std::string initial_pose_remark_ = "none";
  bool is_lockstep_ = false;
  std::deque<std::function<std::function<void()>()>> saves_;  ///< that wait
  std::atomic<bool> is_saving_ = false;
  std::deque<sensor_msgs::msg::LaserScan> waiting_;  ///< for odometry of their time
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  Time map_time_;               ///< of the newest scan in the map
  std::vector<MapTile> tiles_;  ///< of the map, to be published
  std::size_t to_gather_ = 0;   ///< tiles that are missing among them
  bool is_gathering_ = false;
  /// What was told of the graph: submaps, loops, and how often it was optimised.
  std::array<std::int64_t, 3> told_graph_{};
  std::int64_t too_early_ = 0;  ///< scans that odometry did not reach
  std::int64_t told_too_early_ = 0;
  double inliers_ = 0.0;  ///< of the newest scan
  HealthWatch watch_;
  bool is_kidnapped_ = false;    ///< and looks for its place
  std::optional<Time> carried_;  ///< when that was noticed last
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
  Output<visualization_msgs::msg::MarkerArray> graph_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  MapOutput map_;  ///< last: its thread ends before what it uses
};

}  // namespace bw::slam
