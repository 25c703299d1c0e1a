#include "components/lab/bench/odometry_stand_in.hpp"

#include <cmath>

#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {
namespace {

nav_msgs::msg::Odometry odometry(const PeopleTopics& topics, Time stamp, const Pose2& X_OB) {
  nav_msgs::msg::Odometry message;
  message.header(make_header(topics.odom_frame, stamp));
  message.child_frame_id(topics.base_frame);
  message.pose().pose(to_pose(X_OB));
  return message;
}

/// Where the transforms say that the base is, at each of their stamps.
class OdometryOfTransforms final : public Component {
 public:
  explicit OdometryOfTransforms(PeopleTopics topics) : topics_(std::move(topics)) {}

  void configure(Setup& setup) override {
    transforms_ = setup.transforms();
    odom_ = setup.output<nav_msgs::msg::Odometry>(topics_.odom);
    setup.input<tf2_msgs::msg::TFMessage>("/tf", Qos::tf(), [this](const auto& message, const Tick&) {
      for (const auto& transform : message.transforms()) tell(from_stamp(transform.header().stamp()));
    });
  }

 private:
  void tell(Time stamp) {
    if (stamp <= told_) return;
    const auto X_OB = transforms_->lookup_planar(topics_.odom_frame, topics_.base_frame, stamp);
    if (!X_OB) return;
    told_ = stamp;
    odom_.publish(odometry(topics_, stamp, *X_OB));
  }

  PeopleTopics topics_;
  std::shared_ptr<const TransformTree> transforms_;
  Output<nav_msgs::msg::Odometry> odom_;
  Time told_;
};

/// The robot is at the origin of odom, from the first beam of each scan to its last.
class StandingOdometry final : public Component {
 public:
  explicit StandingOdometry(PeopleTopics topics) : topics_(std::move(topics)) {}

  void configure(Setup& setup) override {
    odom_ = setup.output<nav_msgs::msg::Odometry>(topics_.odom);
    setup.input<sensor_msgs::msg::LaserScan>(
        topics_.scan, Qos::sensor(), [this](const sensor_msgs::msg::LaserScan& scan, const Tick&) {
          const Time first = from_stamp(scan.header().stamp());
          const double lasts =
              static_cast<double>(scan.time_increment()) * static_cast<double>(scan.ranges().size());
          odom_.publish(odometry(topics_, first, {}));
          if (std::isfinite(lasts) && std::abs(lasts) < 10.0 && lasts != 0.0)
            odom_.publish(odometry(topics_, first + Duration::seconds(lasts), {}));
        });
  }

 private:
  PeopleTopics topics_;
  Output<nav_msgs::msg::Odometry> odom_;
};

}  // namespace

std::unique_ptr<Component> make_odometry_stand_in(const PeopleTopics& topics) {
  if (topics.odometry == OdometrySource::standing) return std::make_unique<StandingOdometry>(topics);
  return std::make_unique<OdometryOfTransforms>(topics);
}

}  // namespace bw
