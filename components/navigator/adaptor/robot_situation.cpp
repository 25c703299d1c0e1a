#include "components/navigator/adaptor/robot_situation.hpp"

#include <utility>

#include "components/messages/geometry.hpp"
#include "components/messages/planning_inputs.hpp"
#include "components/model/principal_deviations.hpp"
#include "components/navigator/goal_messages.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {
namespace {

constexpr Duration kOldest = PlanningInputs::kTransformTolerance;

}  // namespace

void RobotSituation::listen(Setup& setup, const NavigatorParameters& parameters,
                            std::shared_ptr<const TransformTree> transforms) {
  by_tf_ = parameters.pose_source == PoseSource::tf;
  map_frame_ = setup.frame("map");
  base_frame_ = setup.frame("base_link");
  transforms_ = std::move(transforms);
  override_ = setup.latest<std_msgs::msg::Bool>("manual_override", Qos::latched(), Need::optional);
  base_.listen(setup);
  odometry_ = setup.latest<nav_msgs::msg::Odometry>(by_tf_ ? "odom" : "odometry/filtered", Qos::command());
}

std::optional<Pose2> RobotSituation::pose(Time now) const {
  if (!by_tf_) return from_pose(odometry_->pose().pose());
  const std::optional<Time> newest = transforms_->newest(map_frame_, base_frame_);
  if (!newest || *newest < now - kOldest) return std::nullopt;
  return transforms_->lookup_planar(map_frame_, base_frame_);
}

Situation RobotSituation::at(const Tick& tick) const {
  Situation s{tick.now, std::nullopt, {}};
  s.is_overridden = override_ && override_->data();
  s.base_stop = base_.at(tick.now);
  if (!odometry_) return s;
  s.twist = from_twist(odometry_->twist().twist());
  const bool fresh = tick.now - odometry_.received() <= kOldest;
  const std::optional<Pose2> X_MB = pose(tick.now);
  if (!by_tf_) {
    const Eigen::Matrix3d C = planar_covariance(odometry_->pose().covariance());
    s.two_sigma = 2.0 * principal_deviations(C.topLeftCorner<2, 2>()).x();
  }
  if (fresh && tick.health != Health::stop && X_MB && is_finite(*X_MB) && is_finite(s.twist)) s.X_MB = X_MB;
  return s;
}

}  // namespace bw
