#include "components/emulators/rplidar/rplidar_device.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "runtime/base/pose2.hpp"

namespace bw::emulators {
namespace {

constexpr std::uint8_t kStartOfRequest = 0xA5;
constexpr Duration kBoot = Duration::milliseconds(500);
constexpr std::string_view kGreeting = "RP LIDAR System.\r\nFirmware Ver 1.29, HW Ver 7\r\n";
constexpr std::size_t kMaxWaiting = 300;  // more than the longest request

}  // namespace

float LaserView::range_at(double angle) const {
  constexpr auto kNothing = std::numeric_limits<float>::infinity();
  if (ranges.empty() || angle_increment == 0.0) return kNothing;
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  double behind_first = std::remainder(angle - angle_min, kTwoPi);
  if (behind_first < -std::abs(angle_increment) / 2.0) behind_first += kTwoPi;
  const double beam = std::round(behind_first / angle_increment);
  if (beam < 0.0 || beam > static_cast<double>(ranges.size() - 1)) return kNothing;
  return ranges[static_cast<std::size_t>(beam)];
}

void RplidarDevice::receive(Time now, std::span<const std::uint8_t> bytes) {
  if (boots_until_) return;
  in_.insert(in_.end(), bytes.begin(), bytes.end());
  while (take_request(now)) {
  }
  if (in_.size() > kMaxWaiting) in_.clear();
}

/// False when more bytes are needed.
bool RplidarDevice::take_request(Time now) {
  const auto start = std::find(in_.begin(), in_.end(), kStartOfRequest);
  in_.erase(in_.begin(), start);
  if (in_.size() < 2) return false;
  const std::uint8_t command = in_[1];
  if ((command & 0x80) == 0) {
    in_.erase(in_.begin(), in_.begin() + 2);
    obey(now, command, {});
    return true;
  }
  if (in_.size() < 3) return false;
  const std::size_t length = 4U + in_[2];
  if (in_.size() < length) return false;
  std::uint8_t sum = 0;
  for (std::size_t i = 0; i + 1 < length; ++i) sum = static_cast<std::uint8_t>(sum ^ in_[i]);
  const std::vector<std::uint8_t> payload(in_.begin() + 3,
                                          in_.begin() + static_cast<std::ptrdiff_t>(length) - 1);
  const bool is_sound = sum == in_[length - 1];
  in_.erase(in_.begin(), in_.begin() + (is_sound ? static_cast<std::ptrdiff_t>(length) : 1));
  if (is_sound)
    obey(now, command, payload);
  else
    ++refused_requests_;
  return true;
}

void RplidarDevice::obey(Time now, std::uint8_t command, std::span<const std::uint8_t> payload) {
  const bool stops = command == 0x25 || command == 0x40;
  if (is_scanning_ && !stops && (command & 0x80) == 0 && command != 0x20 && command != 0x21) return;
  switch (command) {
    case 0x25:  // stop
      is_scanning_ = false;
      return;
    case 0x40:  // reset
      is_scanning_ = false;
      motor_speed_.reset();
      out_.clear();
      in_.clear();
      boots_until_ = now + kBoot;
      return;
    case 0x20:  // scan
    case 0x21:  // the same whatever its health
      if (command == 0x20 && options_.health == 2) return;
      answer(0x81, true, {}, 5);
      is_scanning_ = true;
      return;
    case 0x50: {
      std::array<std::uint8_t, 20> info{};
      info[0] = static_cast<std::uint8_t>(faults_.other_model ? 0xE1 : options_.model);
      info[1] = 29;  // firmware 1.29
      info[2] = 1;
      info[3] = 7;
      for (std::size_t i = 4; i < info.size(); ++i) info[i] = static_cast<std::uint8_t>(0x11 * (i - 4));
      return answer(0x04, false, info, 20);
    }
    case 0x52: {
      const std::array<std::uint8_t, 3> health = {static_cast<std::uint8_t>(options_.health),
                                                  static_cast<std::uint8_t>(options_.health_code & 0xFF),
                                                  static_cast<std::uint8_t>(options_.health_code >> 8)};
      return answer(0x06, false, health, 3);
    }
    case 0x59: {
      const auto standard = static_cast<std::uint16_t>(std::lround(options_.sample_time * 1e6));
      const auto low = static_cast<std::uint8_t>(standard & 0xFF);
      const auto high = static_cast<std::uint8_t>(standard >> 8);
      return answer(0x15, false, std::array<std::uint8_t, 4>{low, high, low, high}, 4);
    }
    case 0xF0:  // PWM, of 0 to 1023; 600 is full speed here
      if (payload.size() == 2) motor_speed_ = (payload[0] + 256 * payload[1]) / 600.0;
      return;
    case 0xA8:  // rpm
      if (payload.size() == 2) motor_speed_ = (payload[0] + 256 * payload[1]) / (60.0 * options_.rate);
      return;
    default:
      return;
  }
}

void RplidarDevice::answer(std::uint8_t type, bool is_stream, std::span<const std::uint8_t> data,
                           std::uint32_t length) {
  out_.insert(out_.end(), {0xA5, 0x5A, static_cast<std::uint8_t>(length), 0, 0,
                           static_cast<std::uint8_t>(is_stream ? 0x40 : 0x00), type});
  out_.insert(out_.end(), data.begin(), data.end());
}

/// [Hz]. An A1 rotates while it has power; later ones as they are told.
double RplidarDevice::wanted_rate() const {
  const bool is_told = options_.model >> 4 >= 2;
  return options_.rate * faults_.slow * (is_told ? std::min(motor_speed_.value_or(0.0), 1.5) : 1.0);
}

std::span<const std::uint8_t> RplidarDevice::step(Time now, const LaserView& view) {
  if (boots_until_ && now >= *boots_until_) {
    boots_until_.reset();
    out_.insert(out_.end(), kGreeting.begin(), kGreeting.end());
  }
  const Duration between = Duration::seconds(options_.sample_time);
  if (!next_sample_ || now - *next_sample_ > Duration::milliseconds(500) || *next_sample_ - now > between)
    next_sample_ = now;
  for (; *next_sample_ <= now; next_sample_ = *next_sample_ + between) {
    const double wanted = wanted_rate();
    const double most =
        options_.spin_up > 0.0 ? options_.rate * options_.sample_time / options_.spin_up : wanted;
    revolution_rate_ += std::clamp(wanted - revolution_rate_, -std::max(most, 1e-9), std::max(most, 1e-9));
    revolved_ += revolution_rate_ * options_.sample_time;
    begins_revolution_ = revolved_ >= 1.0;
    revolved_ -= std::floor(revolved_);
    const bool is_steady = std::abs(revolution_rate_ - wanted) < 0.05 * options_.rate;
    if (is_scanning_ && is_steady && !boots_until_) measure(view);
  }
  sent_.clear();
  std::swap(sent_, out_);
  spoil();
  return sent_;
}

void RplidarDevice::measure(const LaserView& view) {
  const double angle = 2.0 * std::numbers::pi * revolved_;
  const double noise = options_.range_noise > 0.0 ? options_.range_noise * random_.normal() : 0.0;
  const double range = static_cast<double>(view.range_at(wrap_angle(-angle))) + noise;
  const bool is_seen = std::isfinite(range) && range >= options_.range_min && range <= options_.range_max;
  const auto distance =
      static_cast<std::uint16_t>(is_seen ? std::min(std::lround(range * 4000.0), 65535L) : 0);
  const auto angle_64 = static_cast<std::uint16_t>(std::lround(revolved_ * 360.0 * 64.0) % (360 * 64));
  // Fewer photons come back from afar.
  const int quality = is_seen ? std::clamp(static_cast<int>(47.0 - 2.0 * range), 5, 47) : 0;
  const int first = quality << 2 | (begins_revolution_ ? 0b01 : 0b10);
  out_.insert(out_.end(),
              {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>((angle_64 << 1 & 0xFF) | 1),
               static_cast<std::uint8_t>(angle_64 >> 7), static_cast<std::uint8_t>(distance & 0xFF),
               static_cast<std::uint8_t>(distance >> 8)});
}

/// The faults of what goes over the line.
void RplidarDevice::spoil() {
  if (faults_.silent) sent_.clear();
  if (faults_.lost > 0.0)
    std::erase_if(sent_, [this](std::uint8_t) { return random_.uniform() < faults_.lost; });
  for (std::uint8_t& byte : sent_) {
    if (faults_.garbage) byte = static_cast<std::uint8_t>(random_.bits());
    if (faults_.corrupt > 0.0 && random_.uniform() < faults_.corrupt)
      byte = static_cast<std::uint8_t>(byte ^ 1U << random_.bits() % 8);
  }
}

}  // namespace bw::emulators
