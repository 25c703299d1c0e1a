// Localization that cannot err: passes the world's truth on as /odometry/filtered and map->odom, until a real
// one takes its place.
#include <cmath>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/ideal_localization/map_to_odom.hpp"
#include "components/messages/geometry.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

class IdealLocalizationComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    map_frame_ = setup.frame("map");
    odom_frame_ = setup.frame("odom");
    base_frame_ = setup.frame("base_link");
    filtered_ = setup.output<nav_msgs::msg::Odometry>("odometry/filtered");
    tf_ = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf());
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::standard(), [this](const auto& message, const Tick&) { on_truth(message); });
    setup.input<nav_msgs::msg::Odometry>("odom", Qos::standard(),
                                         [this](const auto& message, const Tick&) { on_odometry(message); });
  }

 private:
  struct Truth {
    Time stamp;
    Pose2 X_MB;
    Twist2 twist;
  };

  void on_truth(const bandwagon_msgs::msg::GroundTruth& message) {
    truth_ =
        Truth{from_stamp(message.header().stamp()), from_pose(message.pose()), from_twist(message.twist())};
    if (!is_finite(truth_->X_MB)) return truth_.reset();
    constexpr double kVariance = 1e-6;  // exact, but consumers divide by it
    nav_msgs::msg::Odometry odometry;
    odometry.header(make_header(map_frame_, truth_->stamp));
    odometry.child_frame_id(base_frame_);
    odometry.pose().pose(message.pose());
    odometry.twist().twist(message.twist());
    for (const std::size_t i : {0U, 7U, 35U}) {
      odometry.pose().covariance()[i] = kVariance;
      odometry.twist().covariance()[i] = kVariance;
    }
    filtered_.publish(odometry);
  }

  void on_odometry(const nav_msgs::msg::Odometry& message) {
    constexpr double kSameMoment = 0.2;  // truth and odometry farther apart do not belong together [s]
    const Time stamp = from_stamp(message.header().stamp());
    const Pose2 X_OB = from_pose(message.pose().pose());
    if (!truth_ || !is_finite(X_OB)) return;
    const double ahead = (stamp - truth_->stamp).to_seconds();
    if (std::abs(ahead) > kSameMoment) return;
    const Pose2 X_MO = map_to_odom(truth_->X_MB, truth_->twist, ahead, X_OB);
    tf2_msgs::msg::TFMessage tf;
    tf.transforms().push_back(to_transform(map_frame_, odom_frame_, stamp, X_MO));
    tf_.publish(tf);
  }

  std::optional<Truth> truth_;
  std::string map_frame_;
  std::string odom_frame_;
  std::string base_frame_;
  Output<nav_msgs::msg::Odometry> filtered_;
  Output<tf2_msgs::msg::TFMessage> tf_;
};

}  // namespace

BW_COMPONENT(IdealLocalizationComponent, "ideal_localization")

}  // namespace bw
