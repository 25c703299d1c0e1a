// Adaptor: odometry and sensors in; pose, map->odom, particles and health out. Topics: README.md.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tf2_msgs/msg/tf_message.hpp>

#include "components/localization/adaptor/kept_pose_text.hpp"
#include "components/localization/adaptor/localization_messages.hpp"
#include "components/localization/adaptor/sensor_inputs.hpp"
#include "components/localization/localization_parameters.hpp"
#include "components/localization/odometry_steps.hpp"
#include "runtime/component.hpp"

namespace bw::localization {

class LocalizationComponent final : public Component {
 public:
  void configure(Setup& setup) override;
  void activate(const Tick& tick) override;

 private:
  void listen(Setup& setup);
  void offer_services(Setup& setup);
  void on_odometry(const nav_msgs::msg::Odometry& message, const Tick& tick);
  void on_initial_pose(const geometry_msgs::msg::PoseWithCovarianceStamped& message, const Tick& tick);
  void on_map(const OccupancyGrid& map, const Tick& tick);
  void start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time);
  void search(Time time);
  void take_up(const Pose2& X_OB, Time time);
  void keep(const Estimate& estimate) const;
  void publish_pose(const Pose2& X_OB, Time time);
  void report_health(const Tick& tick);

  LocalizationParameters parameters_;
  SensorInputs inputs_;
  OdometrySteps wheels_;
  std::unique_ptr<Localizer> filter_;
  HealthState state_ = HealthState::init;
  Keepsake keepsake_;
  std::optional<KeptPose> left_;  ///< until the odometry is heard

  std::string map_frame_;
  std::string odom_frame_;
  std::string base_frame_;
  Output<nav_msgs::msg::Odometry> filtered_;
  Output<tf2_msgs::msg::TFMessage> tf_;
  Output<geometry_msgs::msg::PoseWithCovarianceStamped> pose_;
  Output<nav2_msgs::msg::ParticleCloud> cloud_;
  Output<geometry_msgs::msg::PoseArray> particle_poses_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
};

}  // namespace bw::localization
