#include "components/robot_base/adaptor/odometry_reader.hpp"

#include <fmt/format.h>

namespace bw {

OdometryReader::OdometryReader(Setup& setup, const Robot& robot, const OdometryOptions& options,
                               Duration silence)
    : robot_(robot),
      odometry_(EncoderOdometry(robot, options)),
      silence_(silence),
      log_(setup.log()),
      diagnostics_(&setup.diagnostics()),
      outputs_(setup, robot),
      joints_(setup.output<sensor_msgs::msg::JointState>("joint_states")) {}

std::optional<WheelTravel> OdometryReader::read(Time now, const EncoderCounts& counts) {
  const Time before = odometry_->state().time;
  const CountsStatus status = odometry_->add(now, counts);
  const bool is_new = status == CountsStatus::moved || status == CountsStatus::rebased;
  if (status == CountsStatus::jump || status == CountsStatus::reset) tell_fault(status, counts.time);
  if (is_new && (status == CountsStatus::rebased || counts.time - before >= silence_))
    tell_gap(status, (counts.time - before).to_seconds());
  if (status != CountsStatus::stale) publish();
  if (status != CountsStatus::moved) return std::nullopt;
  return odometry_->travel();
}

void OdometryReader::tell_fault(CountsStatus status, Time stamp) {
  // At most a line a second: encoders that fail do so at every reading.
  if (fault_told_ && stamp - *fault_told_ < Duration::milliseconds(1000)) return;
  fault_told_ = stamp;
  log_.warn("encoder {} dropped (jumps {}, resets {})", status == CountsStatus::jump ? "jump" : "reset",
            odometry_->faults().jumps, odometry_->faults().resets);
}

void OdometryReader::tell_gap(CountsStatus status, double seconds) {
  const WheelTravel& travel = odometry_->travel();
  const double distance = (travel.left + travel.right) / 2.0;
  ++gaps_;
  gap_seconds_ += seconds;
  if (status == CountsStatus::moved) {
    gap_distance_ += distance;
    log_.warn(
        "no counts for {:.2f} s, in which the base went {:.3f} m and turned {:.3f} rad: odometry takes it for one arc",
        seconds, distance, (travel.right - travel.left) / robot_.wheel_separation);
  } else {
    ++unknown_gaps_;
    log_.warn("counts begin anew after {:.2f} s: how far the base went meanwhile is not in the odometry",
              seconds);
  }
  diagnostics_->set_value("odometry without counts",
                          fmt::format("{} times, {:.2f} s, {:.3f} m as arcs; {} times not known how far",
                                      gaps_, gap_seconds_, gap_distance_, unknown_gaps_));
}

void OdometryReader::publish() {
  const OdometryState& state = odometry_->state();
  outputs_.publish_odometry(state);
  sensor_msgs::msg::JointState joints = to_joint_state(measured(), robot_.wheel_radii(), state.time);
  joints.position({state.left_angle, state.right_angle});
  joints_.publish(joints);
  outputs_.publish_transform(state);
}

}  // namespace bw
