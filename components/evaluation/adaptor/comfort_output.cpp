#include "components/evaluation/adaptor/comfort_output.hpp"

#include <cmath>
#include <utility>

#include "components/evaluation/collision_index.hpp"
#include "components/evaluation/comfort.hpp"
#include "components/messages/geometry.hpp"
#include "components/model/mover_weight.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

constexpr double kMaxApart =
    0.5;  // [s] that people are moved along their velocity to the time of the robot's pose

bandwagon_msgs::msg::Comfort to_message(const Comfort& comfort, const TruthSample& sample) {
  bandwagon_msgs::msg::Comfort message;
  message.closest_person_m(comfort.closest_person);
  message.closest_person_id(comfort.closest_person_id);
  message.collision_index(comfort.collision_index);
  message.comfort_limit(kComfortLimit);
  message.physical_limit(kPhysicalLimit);
  message.speed_mps(std::abs(sample.twist.v));
  return message;
}

}  // namespace

void ComfortOutput::offer(Setup& setup, const CurrentFootprint& robot) {
  robot_ = &robot;
  map_frame_ = setup.frame("map");
  odometry_ = setup.latest<nav_msgs::msg::Odometry>("odom", Qos::command(), Need::optional);
  tracks_ = setup.latest<bandwagon_msgs::msg::Tracks>("tracks", Qos::command(), Need::optional);
  output_ = setup.output<bandwagon_msgs::msg::Comfort>("comfort");
}

void ComfortOutput::on_truth(const TruthSample& sample) {
  has_truth_ = true;
  truth_ = sample;
}

std::optional<TruthSample> ComfortOutput::believed() const {
  if (!tracks_) return std::nullopt;
  const std::string& frame = tracks_->header().frame_id();
  const nav_msgs::msg::Odometry* robot = nullptr;
  if (odometry_ && odometry_->header().frame_id() == frame) robot = &*odometry_;
  if (filtered_ && filtered_->header().frame_id() == frame) robot = &*filtered_;
  if (robot == nullptr) return std::nullopt;
  TruthSample sample;
  sample.time = from_stamp(robot->header().stamp());
  const double age = (sample.time - from_stamp(tracks_->header().stamp())).to_seconds();
  if (std::abs(age) > kMaxApart) return std::nullopt;
  sample.X_MB = from_pose(robot->pose().pose());
  sample.twist = from_twist(robot->twist().twist());
  for (const auto& track : tracks_->tracks()) {
    if (!is_confirmed(track.confidence())) continue;
    const Vector2 velocity{track.velocity().x(), track.velocity().y()};
    const Vector2 position{track.position().x(), track.position().y()};
    sample.people.push_back({track.id(), position + age * velocity, velocity, track.radius()});
  }
  return sample;
}

void ComfortOutput::tell(int contacts) {
  namespace source = bandwagon_msgs::msg::Comfort_Constants;
  const std::optional<TruthSample> sample = has_truth_ ? std::exchange(truth_, std::nullopt) : believed();
  if (!sample || (!has_truth_ && told_ == sample->time)) return;
  const std::optional<Comfort> comfort = comfort_of(*sample, robot_->now());
  if (!comfort) return;
  told_ = sample->time;
  bandwagon_msgs::msg::Comfort message = to_message(*comfort, *sample);
  message.header(make_header(has_truth_ ? map_frame_ : tracks_->header().frame_id(), sample->time));
  message.source(has_truth_ ? source::TRUTH : source::TRACKS);
  message.contacts(static_cast<std::uint32_t>(contacts));
  output_.publish(message);
}

}  // namespace bw
