#include "components/robot_base/adaptor/base_outputs.hpp"

#include <limits>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

namespace state = bandwagon_msgs::msg::BaseState_Constants;
static_assert(static_cast<int>(BaseCondition::driving) == state::DRIVING);
static_assert(static_cast<int>(BaseCondition::backing_off) == state::BACKING_OFF);
static_assert(static_cast<int>(BaseCondition::emergency_stop) == state::EMERGENCY_STOP);
static_assert(static_cast<int>(BaseCondition::wheel_drop) == state::WHEEL_DROP);
static_assert(static_cast<int>(BaseCondition::runaway) == state::RUNAWAY);
static_assert(static_cast<int>(BaseCondition::charging) == state::CHARGING);

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

sensor_msgs::msg::Range range_message(const Ranger& ranger, const std::string& frame) {
  namespace range = sensor_msgs::msg::Range_Constants;
  sensor_msgs::msg::Range message;
  message.header().frame_id(frame);
  message.radiation_type(ranger.is_infrared ? range::INFRARED : range::ULTRASOUND);
  message.field_of_view(static_cast<float>(ranger.field_of_view));
  message.min_range(static_cast<float>(ranger.min_range));
  message.max_range(static_cast<float>(ranger.max_range));
  return message;
}

}  // namespace

BaseOutputs::BaseOutputs(Setup& setup, const Driver& driver)
    : has_gyro_(driver.facts().has_gyro),
      has_battery_(driver.facts().has_battery),
      base_frame_(setup.frame("base_link")),
      states_(setup.output<bandwagon_msgs::msg::BaseState>("base_state")) {
  if (has_battery_) battery_ = setup.output<sensor_msgs::msg::BatteryState>("battery_state");
  if (has_gyro_) imu_ = setup.output<sensor_msgs::msg::Imu>("base/imu");
  for (const Ranger& ranger : driver.rangers())
    beams_.push_back({range_message(ranger, setup.frame(ranger.frame)),
                      setup.output<sensor_msgs::msg::Range>("range/" + ranger.frame)});
  state_.current_left(kUnknown);
  state_.current_right(kUnknown);
}

void BaseOutputs::publish(Time now, const Readings& readings) {
  if (has_battery_ && readings.battery) publish_battery(now, *readings.battery);
  if (has_gyro_) {
    for (const GyroReading& reading : readings.gyro) publish_gyro(reading);
  }
  for (const RangeReading& reading : readings.ranges) publish_range(reading);
  if (readings.currents) {
    state_.current_left(static_cast<float>(readings.currents->left));
    state_.current_right(static_cast<float>(readings.currents->right));
  }
  const std::uint32_t buttons = readings.buttons.value_or(state_.buttons());
  is_news_ = is_news_ || buttons != state_.buttons() || readings.link.device != state_.device();
  state_.buttons(buttons);
  state_.device(readings.link.device);
}

void BaseOutputs::publish_battery(Time now, const BatteryReading& reading) {
  namespace supply = sensor_msgs::msg::BatteryState_Constants;
  const std::uint8_t status = reading.is_charging  ? supply::POWER_SUPPLY_STATUS_CHARGING
                              : reading.is_plugged ? supply::POWER_SUPPLY_STATUS_FULL
                                                   : supply::POWER_SUPPLY_STATUS_DISCHARGING;
  const bool is_early = battery_told_ && now - *battery_told_ < Duration::milliseconds(1000);
  if (is_early && status == battery_message_.power_supply_status()) return;
  battery_told_ = now;
  sensor_msgs::msg::BatteryState& message = battery_message_;
  message.header(make_header(base_frame_, now));
  message.voltage(static_cast<float>(reading.voltage));
  message.percentage(static_cast<float>(reading.charge));
  message.temperature(kUnknown);
  message.current(kUnknown);
  message.charge(kUnknown);
  message.capacity(kUnknown);
  message.design_capacity(kUnknown);
  message.present(true);
  message.power_supply_status(status);
  battery_.publish(message);
}

void BaseOutputs::publish_gyro(const GyroReading& reading) {
  sensor_msgs::msg::Imu message;
  message.header(make_header(base_frame_, reading.time));
  message.orientation_covariance()[0] = -1.0;  // there is none
  message.linear_acceleration_covariance()[0] = -1.0;
  message.angular_velocity().z(reading.rate);
  imu_.publish(message);
}

void BaseOutputs::publish_range(const RangeReading& reading) {
  if (reading.ranger >= beams_.size()) return;
  Beam& beam = beams_[reading.ranger];
  beam.message.header().stamp(to_stamp(reading.time));
  beam.message.range(static_cast<float>(reading.range));
  beam.output.publish(beam.message);
}

void BaseOutputs::publish_state(Time now, const BaseOutput& output, const ContactReading& contacts,
                                const WheelSpeeds& measured) {
  is_news_ = false;
  state_.header(make_header(base_frame_, now));
  state_.state(static_cast<std::uint8_t>(output.condition));
  state_.is_latched(output.is_latched);
  state_.reason(output.reason);
  state_.bumper_left(contacts.bumper_left);
  state_.bumper_centre(contacts.bumper_centre);
  state_.bumper_right(contacts.bumper_right);
  state_.cliff_left(contacts.cliff_left);
  state_.cliff_centre(contacts.cliff_centre);
  state_.cliff_right(contacts.cliff_right);
  state_.drop_left(contacts.drop_left);
  state_.drop_right(contacts.drop_right);
  state_.commanded_left(static_cast<float>(output.wheels.left));
  state_.commanded_right(static_cast<float>(output.wheels.right));
  state_.measured_left(static_cast<float>(measured.left));
  state_.measured_right(static_cast<float>(measured.right));
  states_.publish(state_);
}

}  // namespace bw
