// The topics of one robot of the world: wheel commands in, its sensors and its truth out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sensor_msgs/msg/joint_state.hpp>

#include "components/messages/current_footprint.hpp"
#include "components/world/adaptor/world_messages.hpp"
#include "components/world/world.hpp"
#include "runtime/component.hpp"

namespace bw {

class RobotEnds {
 public:
  /// `name`: of one of several, below which its topics and frames are; empty: the only one. `world` must
  /// outlive it. `kind`: what each of the robots is.
  RobotEnds(Setup& setup, World& world, std::size_t robot, const std::string& name, const Robot& kind,
            const WorldOptions& options);

  const std::string& base_frame() const { return base_frame_; }
  /// What the last step of the world produced. `start`: time of the world's beginning.
  void publish(const WorldOptions& options, Time start);

 private:
  /// A base that hears nothing for longer brakes, as a motor's firmware does: who commanded may be gone.
  static constexpr Duration kCommandTimeout = Duration::milliseconds(300);

  void command(const sensor_msgs::msg::JointState& message, Time now);

  World* world_;
  std::size_t robot_;
  CurrentFootprint footprint_;
  bool was_usable_ = true;
  std::optional<Time> commanded_;  ///< nothing: it stands, or brakes
  Logger log_;
  std::string map_frame_;
  std::string base_frame_;
  std::string imu_frame_;
  std::string gps_frame_;
  sensor_msgs::msg::LaserScan scan_message_;
  Output<bandwagon_msgs::msg::WheelTicks> ticks_;
  Output<bandwagon_msgs::msg::GroundTruth> truth_;
  Output<sensor_msgs::msg::LaserScan> scan_;
  std::vector<Output<sensor_msgs::msg::LaserScan>> more_scans_;
  std::vector<std::string> more_frames_;
  Output<sensor_msgs::msg::Imu> imu_;
  Output<sensor_msgs::msg::NavSatFix> fix_;
};

}  // namespace bw
