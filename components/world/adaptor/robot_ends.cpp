#include "components/world/adaptor/robot_ends.hpp"

#include <utility>

namespace bw {
namespace {

template <class Message>
void send(const Output<Message>& output, Message message, const std::string& frame) {
  message.header().frame_id(frame);
  output.publish(message);
}

}  // namespace

RobotEnds::RobotEnds(Setup& setup, World& world, std::size_t robot, const std::string& name,
                     const Robot& kind, const WorldOptions& options)
    : world_(&world), robot_(robot), log_(setup.log()), map_frame_(setup.frame("map")) {
  const std::string below = name.empty() ? "" : name + "/";
  setup.input<sensor_msgs::msg::JointState>(
      below + "sim/wheel_commands", Qos::command(),
      [this](const auto& message, const Tick& tick) { command(message, tick.now); });
  footprint_.listen(
      setup, kind, [this](const Footprint& now) { world_->set_footprint(now, robot_); }, below);
  ticks_ = setup.output<bandwagon_msgs::msg::WheelTicks>(below + "sim/wheel_ticks");
  truth_ = setup.output<bandwagon_msgs::msg::GroundTruth>(below + "sim/ground_truth");
  scan_ = setup.output<sensor_msgs::msg::LaserScan>(below + "scan");
  for (const MoreLaserOptions& one : options.more_lasers) {
    more_scans_.push_back(setup.output<sensor_msgs::msg::LaserScan>(below + one.topic));
    more_frames_.push_back(setup.frame(below + one.frame));
  }
  imu_ = setup.output<sensor_msgs::msg::Imu>(below + "imu");
  fix_ = setup.output<sensor_msgs::msg::NavSatFix>(below + "gps/fix");
  base_frame_ = setup.frame(below + "base_link");
  imu_frame_ = setup.frame(below + ImuOptions::kFrame);
  gps_frame_ = setup.frame(below + GpsOptions::kFrame);
  scan_message_.header().frame_id(setup.frame(below + options.laser.frame));
}

void RobotEnds::command(const sensor_msgs::msg::JointState& message, Time now) {
  commanded_ = now;
  const auto& rates = message.velocity();
  const bool usable = rates.size() == 2 && world_->command({rates[0], rates[1]}, robot_);
  if (!usable) world_->command({}, robot_);
  if (!usable && was_usable_)
    log_.warn("wheel commands must hold two finite rates, left and right; the base brakes");
  was_usable_ = usable;
}

void RobotEnds::publish(const WorldOptions& options, Time start) {
  const WorldSample& sample = world_->samples()[robot_];
  const Time stamp = start + sample.time;
  if (commanded_ && stamp - *commanded_ > kCommandTimeout) {
    world_->command({}, robot_);
    commanded_.reset();
  }
  if (sample.ticks) send(ticks_, to_message(*sample.ticks, stamp), base_frame_);
  if (sample.imu) send(imu_, to_message(*sample.imu, options.imu, stamp), imu_frame_);
  for (const GpsFix& fix : sample.fixes) send(fix_, to_message(fix, options.gps, start), gps_frame_);
  if (sample.truth_due) send(truth_, ground_truth(*world_, robot_, stamp), map_frame_);
  if (sample.scan) {
    to_message(*sample.scan, options.laser, stamp, scan_message_);
    scan_.publish(scan_message_);
  }
  for (std::size_t i = 0; i < more_scans_.size(); ++i) {
    if (!sample.more_scans[i]) continue;
    sensor_msgs::msg::LaserScan message;
    to_message(*sample.more_scans[i], options.more_lasers[i], stamp, message);
    send(more_scans_[i], std::move(message), more_frames_[i]);
  }
}

}  // namespace bw
