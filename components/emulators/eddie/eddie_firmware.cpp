#include "components/emulators/eddie/eddie_firmware.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "components/emulators/eddie/eddie_sensors.hpp"

namespace bw::emulators {
namespace {

constexpr Duration kWatch = Duration::milliseconds(1000);
constexpr Duration kSpeedWindow = Duration::milliseconds(500);
constexpr double kIdleCurrent = 0.5, kCurrentPerSpeed = 2.0;  // [A], [A s/m]

int positions_per_revolution(EddieBoard board) { return board == EddieBoard::quadrature ? 144 : 36; }

/// Upper case, with zeros in front; negative ones in two's complement of so many digits.
std::string hex(std::int64_t value, int digits) {
  std::string text(static_cast<std::size_t>(digits), '0');
  auto rest = static_cast<std::uint64_t>(value);
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, rest >>= 4U)
    *digit = "0123456789ABCDEF"[rest & 15U];
  return text;
}

std::int64_t floor_div(std::int64_t value, double by) {
  return static_cast<std::int64_t>(std::floor(static_cast<double>(value) / by));
}

std::int64_t wrapped_difference(std::int32_t now, std::int32_t before) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(now) - static_cast<std::uint32_t>(before));
}

}  // namespace

EddieFirmware::EddieFirmware(const EddieOptions& options, const Robot& robot)
    : options_(options),
      wheel_radius_(robot.wheel_radius),
      ticks_per_position_(static_cast<double>(robot.ticks_per_revolution) /
                          positions_per_revolution(options.board)),
      metres_per_position_(2.0 * std::numbers::pi * robot.wheel_radius /
                           positions_per_revolution(options.board)),
      speed_factor_(options.speed_unit == SpeedUnit::per_half_second ? 2.0 : 1.0),
      drive_(Duration::seconds(options.latency), options.first_acceleration / metres_per_position_),
      battery_(options.battery),
      watch_(options.has_watch ? kWatch : Duration{}) {}

std::vector<Beam> EddieFirmware::beams() const { return eddie_beams(); }

WheelSpeeds EddieFirmware::motors() const {
  const auto wheel_speed = [&](double positions_per_second) {
    return std::clamp(positions_per_second * metres_per_position_, -options_.top_speed, options_.top_speed);
  };
  return {wheel_speed(drive_.speeds().left), wheel_speed(drive_.speeds().right)};
}

std::span<const std::uint8_t> EddieFirmware::receive(Time now, std::span<const std::uint8_t> bytes) {
  if (!bytes.empty()) heard_ = now;
  reply_.clear();
  for (const std::uint8_t byte : bytes) {
    if (const std::optional<EditedLine> line = editor_.take(byte)) obey(now, parse_line(*line, options_));
  }
  out_.assign(reply_.begin(), reply_.end());
  return out_;
}

void EddieFirmware::obey(Time now, const EddieCommand& command) {
  if (!command.error.empty()) {
    reply_ += is_verbose_ ? "ERROR - " + command.error + "\r" : std::string("ERROR\r");
    return;
  }
  if (command.name.empty()) return;
  if (!move(now, command)) reply_ += answer(command);
  reply_ += "\r";
}

bool EddieFirmware::move(Time now, const EddieCommand& command) {
  using Kind = EddieMotion::Kind;
  const auto value = [&](std::size_t i) { return static_cast<double>(command.values[i]); };
  const auto begin = [&](Kind kind, WheelPair wheels, double distance) {
    drive_.move(now, {.kind = kind, .wheels = wheels, .distance = distance});
    return true;
  };
  if (command.name == "GO") {
    const double at_full = options_.top_speed / metres_per_position_ / 127.0;
    return begin(Kind::power, {std::max(value(0), -127.0) * at_full, std::max(value(1), -127.0) * at_full},
                 0.0);
  }
  if (command.name == "GOSPD")
    return begin(Kind::speed, {value(0) * speed_factor_, value(1) * speed_factor_}, 0.0);
  if (command.name == "STOP") return begin(Kind::stop, {}, value(0));
  if (command.name == "TRVL") return begin(Kind::travel, {value(0), value(0)}, value(1) * speed_factor_);
  if (command.name == "TURN") {
    const double arc = value(0) * std::numbers::pi / 180.0 * options_.separation / 2.0 / metres_per_position_;
    return begin(Kind::travel, {arc, -arc}, value(1) * speed_factor_);  // clockwise counts positive
  }
  return false;
}

std::string EddieFirmware::answer(const EddieCommand& command) {
  const std::string& name = command.name;
  const std::int64_t value = command.values.empty() ? 0 : command.values.front();
  if (name == "VER") return options_.board == EddieBoard::quadrature ? "0103" : "0101";
  if (name == "HWVER") return "0001";
  if (name == "VERB") is_verbose_ = value != 0;
  if (name == "WATCH")
    watch_ = options_.watch_in_seconds ? Duration::milliseconds(1000 * value)
                                       : Duration{kWatch.nanoseconds * value};
  if (name == "ACC") drive_.set_acceleration(static_cast<double>(value));
  if (name == "RST") reset_ = now_;
  if (name == "SPD") return speeds();
  if (name == "DIST") return hex(since_reset().left, 8) + " " + hex(since_reset().right, 8);
  if (name == "HEAD") return heading();
  if (name == "PING") return pings();
  if (name == "ADC") return converter();
  if (const auto mask = pins_.get(name)) return hex(*mask, 8);
  pins_.set(name, static_cast<std::uint32_t>(value));
  return {};
}

EddieFirmware::Positions EddieFirmware::since_reset() const {
  return {now_.left - reset_.left, now_.right - reset_.right};
}

std::string EddieFirmware::speeds() const {
  const Positions before = last_half_second_.empty() ? now_ : last_half_second_.front().positions;
  const auto told = [&](std::int64_t moved) {
    const double per_second = static_cast<double>(moved) / kSpeedWindow.to_seconds();
    return hex(std::llround(per_second / speed_factor_), 4);
  };
  return told(now_.left - before.left) + " " + told(now_.right - before.right);
}

std::string EddieFirmware::heading() const {
  const auto difference =
      static_cast<double>(since_reset().left - since_reset().right) * metres_per_position_;
  const double degrees = difference / options_.separation * 180.0 / std::numbers::pi;
  return hex(std::llround(degrees - 360.0 * std::floor(degrees / 360.0)), 3);
}

std::string EddieFirmware::pings() const {
  std::string text;
  for (std::uint32_t pin = 0; pin < 16; ++pin) {
    if ((pins_.sonars() >> pin & 1U) == 0) continue;
    const bool is_fitted = pin < 2 && pin < body_.ranges.size();
    const std::uint32_t value = is_fitted ? ping_value(body_.ranges[pin], options_.ping_units_per_mm) : 0U;
    text += (text.empty() ? "" : " ") + hex(value, 3);
  }
  return text;
}

std::string EddieFirmware::converter() const {
  std::array<std::uint32_t, 8> channels{};
  for (std::size_t i = 0; i < 2 && i + 2 < body_.ranges.size(); ++i)
    channels[i] = adc_value(infrared_voltage(body_.ranges[i + 2]));
  channels.back() =
      supply_value(std::isnan(body_.battery_voltage) ? battery_.voltage() : body_.battery_voltage);
  std::string text;
  for (const std::uint32_t value : channels) text += (text.empty() ? "" : " ") + hex(value, 3);
  return text;
}

void EddieFirmware::count(Time now, const Body& body) {
  left_ticks_ += wrapped_difference(body.left_ticks, body_.left_ticks);
  right_ticks_ += wrapped_difference(body.right_ticks, body_.right_ticks);
  now_ = {floor_div(left_ticks_, ticks_per_position_), floor_div(right_ticks_, ticks_per_position_)};
  last_half_second_.push_back({now, now_});
  while (last_half_second_.size() > 1 && now - last_half_second_.front().time > kSpeedWindow)
    last_half_second_.pop_front();
}

std::span<const std::uint8_t> EddieFirmware::step(Time now, const Body& body) {
  if (!last_step_) {
    last_step_ = heard_ = now;
    body_ = body;  // it counts from where the wheels are when it is switched on
  }
  const double dt = std::max(0.0, (now - *last_step_).to_seconds());
  last_step_ = std::max(*last_step_, now);
  count(now, body);
  body_ = body;
  if (watch_ > Duration{} && now - heard_ >= watch_) drive_.switch_off();
  drive_.step(now, dt, {static_cast<double>(now_.left), static_cast<double>(now_.right)});
  const double speed = std::abs(motors().left) + std::abs(motors().right);
  battery_.step(body.charger == Charger::none ? kIdleCurrent + kCurrentPerSpeed * speed : -1.0, dt);
  return {};  // it never speaks unasked
}

}  // namespace bw::emulators
