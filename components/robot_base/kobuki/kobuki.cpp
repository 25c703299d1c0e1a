#include "components/robot_base/kobuki/kobuki.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

namespace bw::kobuki {
namespace {

constexpr int kPeriod = 20;                ///< [ms] between packets
constexpr int kTicksPerPeriod = 400;       ///< at 0.7 m/s there are 164
constexpr double kFirmwareRadius = 0.035;  ///< [m] by which the board turns mm/s into wheel revolutions
constexpr Duration kWritePeriod = Duration::milliseconds(30);
constexpr Duration kAskAgain = Duration::milliseconds(1000);
constexpr Duration kStrange = Duration::milliseconds(500);
constexpr Duration kGiveUp = Duration::milliseconds(2000);
/// At top speed half a wrap of a counter takes 4 s.
constexpr Duration kHalfWrap = Duration::milliseconds(3900);

std::string seconds_text(Duration time) {
  const auto tenths = time.nanoseconds / 100'000'000;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s";
}

void add(ContactReading& to, const Core& core) {
  to.bumper_right |= (core.bumper & 1) != 0;
  to.bumper_centre |= (core.bumper & 2) != 0;
  to.bumper_left |= (core.bumper & 4) != 0;
  to.cliff_right |= (core.cliff & 1) != 0;
  to.cliff_centre |= (core.cliff & 2) != 0;
  to.cliff_left |= (core.cliff & 4) != 0;
  to.drop_right |= (core.wheel_drop & 1) != 0;
  to.drop_left |= (core.wheel_drop & 2) != 0;
}

/// A state of the charger that no document has counts as plugged in: who is in doubt does not drive off.
BatteryReading battery(const Core& core) {
  constexpr double kFull = 16.5, kEmpty = 13.2;
  const double voltage = 0.1 * core.battery;
  return {.voltage = voltage,
          .charge = std::clamp((voltage - kEmpty) / (kFull - kEmpty), 0.0, 1.0),
          .is_charging = core.charger == 6 || core.charger == 22,
          .is_plugged = core.charger != 0};
}

GyroReading gyro(Time time, const Feedback& packet, Heading& heading) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  if (packet.inertia)
    return {.time = time,
            .rate = packet.inertia->rate * 0.01 * kDegree,
            .angle = heading.add(packet.inertia->angle)};
  double sum = 0.0;
  for (const auto& sample : packet.gyro->samples) sum += sample[2];
  return {.time = time, .rate = 0.00875 * kDegree * sum / static_cast<double>(packet.gyro->samples.size())};
}

}  // namespace

Kobuki::Kobuki(const KobukiOptions& options, const WheelRadii& radii, std::unique_ptr<ByteLink> link)
    : options_(options), radii_(radii), link_(std::move(link)) {}

void Kobuki::begin_session(Time now) {
  session_ = {.opened = now};
  reader_.reset();
  unknown_device_.reset();
}

Readings Kobuki::poll(Time now) {
  Readings readings;
  const LinkState& link = link_->update(now);
  if (link.is_open && link.openings != openings_) {
    openings_ = link.openings;
    begin_session(now);
  }
  const std::span<const std::uint8_t> bytes = link_->read();
  reader_.add(bytes);
  std::vector<Feedback> packets;
  for (auto payload = reader_.next(); !payload.empty(); payload = reader_.next())
    packets.push_back(parse(payload));
  if (packets.empty()) {
    unknown_device_.add(bytes);
  } else {
    unknown_device_.reset();
    session_.heard = now;
    session_.packets += packets.size();
    session_.was_heard_since_write = true;
    take(now, packets, readings);
  }
  readings.link = heard(now, link);
  tell(now, readings);
  return readings;
}

void Kobuki::take(Time now, const std::vector<Feedback>& packets, Readings& readings) {
  std::vector<std::uint16_t> stamps;
  for (const Feedback& packet : packets)
    if (packet.core) stamps.push_back(packet.core->stamp);
  const std::uint64_t jumps = clock_.jumps();
  const std::vector<Time> times = clock_.times(now, stamps);
  clock_jumped_ = clock_.jumps() != jumps;
  if (clock_jumped_) {
    faults_.say(now, "clock", "the board's clock or the computer's jumped: the board restarted?");
    heading_.forget();
  }
  if (!times.empty()) {
    gap_ = now - arrival_.value_or(now);
    arrival_ = now;
  }
  std::size_t index = 0;
  for (const Feedback& packet : packets) {
    const Time time = packet.core ? times[index++] : now;
    if (packet.core) take_core(now, time, *packet.core, readings);
    if (packet.inertia || (packet.gyro && !packet.gyro->samples.empty()))
      readings.gyro.push_back(gyro(time, packet, heading_));
    if (packet.currents) {
      CurrentReading& currents = readings.currents ? *readings.currents : readings.currents.emplace();
      currents.left = 0.01 * packet.currents->left;
      currents.right = 0.01 * packet.currents->right;
      currents.is_over_left |= packet.core && (packet.core->overcurrent & 1) != 0;
      currents.is_over_right |= packet.core && (packet.core->overcurrent & 2) != 0;
    }
    remember(packet);
  }
}

void Kobuki::take_core(Time now, Time stamp, const Core& core, Readings& readings) {
  count(now, core);
  readings.counts.push_back({stamp, left_.count(), right_.count()});
  add(readings.contacts ? *readings.contacts : readings.contacts.emplace(), core);
  readings.battery = battery(core);
  readings.buttons = readings.buttons.value_or(0) | core.buttons;
}

void Kobuki::count(Time now, const Core& core) {
  const std::int32_t left = left_.moved(core.left_encoder), right = right_.moved(core.right_encoder);
  const std::int32_t moved = std::abs(left) > std::abs(right) ? left : right;
  const int periods = periods_since(core.stamp);
  const bool is_jump = std::abs(moved) > kTicksPerPeriod * (clock_jumped_ ? 2 : periods);
  if (stamp_) missed_ += static_cast<std::uint64_t>(periods - 1);
  if (gap_ > kHalfWrap)
    warnings_.say(
        now, "gap",
        "unheard for " + seconds_text(gap_) +
            ": what the wheels turned meanwhile is known up to whole wraps of their counters (5.6 m)");
  if (is_jump) {
    ++encoder_jumps_;
    heading_.forget();
    faults_.say(now, "ticks",
                "a wheel's counter jumped by " + std::to_string(moved) + " in " +
                    std::to_string(periods * kPeriod) + " ms: the board restarted, or packets are damaged");
  }
  // A board that restarted counts from zero: how far it is there says nothing.
  if (is_jump && clock_jumped_) {
    left_.go_on_from(core.left_encoder);
    right_.go_on_from(core.right_encoder);
  }
  left_.add(core.left_encoder);
  right_.add(core.right_encoder);
  stamp_ = core.stamp;
}

/// By the stamps, as far as the arrivals bear them out: after a restart of the board they say anything.
int Kobuki::periods_since(std::uint16_t stamp) const {
  if (!stamp_) return 1;
  const int elapsed = static_cast<std::uint16_t>(stamp - *stamp_);
  const auto arrived = std::clamp<std::int64_t>(gap_.nanoseconds / 1'000'000, 0, 3'600'000);
  return std::clamp((elapsed + kPeriod / 2) / kPeriod, 1, static_cast<int>(arrived) / kPeriod + 2);
}

void Kobuki::remember(const Feedback& packet) {
  skipped_ += static_cast<std::uint64_t>(packet.skipped);
  if (packet.hardware) hardware_ = packet.hardware;
  if (packet.firmware) firmware_ = packet.firmware;
  session_.has_versions |= packet.firmware.has_value();
  if (!packet.controller) return;
  const auto is = [](std::uint32_t told, double wanted) { return told == std::lround(wanted * 1000.0); };
  const Gains& gains = options_.gains.gains;
  session_.has_gains = packet.controller->is_user && is(packet.controller->p, gains.p) &&
                       is(packet.controller->i, gains.i) && is(packet.controller->d, gains.d);
}

/// The cable's state; one on which no Kobuki is heard counts as not open.
LinkState Kobuki::heard(Time now, const LinkState& cable) {
  LinkState link = cable;
  if (!link.is_open) return link;
  if (session_.heard && *session_.heard > now) session_.heard = now;
  if (session_.opened > now) session_.opened = now;
  const Duration silence = now - session_.heard.value_or(session_.opened);
  if (silence < Duration::seconds(options_.kSilence) && is_recognised()) return link;
  link.is_open = false;
  link.fault = unknown_device_.is_heard() ? "no packet of a Kobuki, but bytes: " + unknown_device_.likeness()
                                          : "no packet of a Kobuki: nothing comes; is the base switched on?";
  if (!unknown_device_.is_heard()) return link;
  if (silence >= kStrange) faults_.say(now, "stranger", link.fault);
  if (silence >= kGiveUp) link_->close(now, link.fault);
  return link;
}

void Kobuki::tell(Time now, Readings& readings) {
  readings.fault = faults_.text(now);
  readings.warning = warnings_.text(now);
}

std::map<std::string, std::uint64_t> Kobuki::counters() const {
  const ReaderCounts& counts = reader_.counts();
  std::map<std::string, std::uint64_t> all = {{"packets", counts.packets},
                                              {"bad checksums", counts.bad_checksums},
                                              {"bytes thrown away", counts.bytes_thrown_away},
                                              {"packets missed", missed_},
                                              {"sub-payloads skipped", skipped_},
                                              {"encoder jumps", encoder_jumps_},
                                              {"clock jumps", clock_.jumps()}};
  const auto number = [](const Version& version) {
    return std::uint64_t{version.major} * 10'000 + std::uint64_t{version.minor} * 100 + version.patch;
  };
  if (hardware_) all["hardware version"] = number(*hardware_);
  if (firmware_) all["firmware version"] = number(*firmware_);
  return all;
}

bool Kobuki::command(Time now, const WheelSpeeds& wheels) {
  if (openings_ == 0) return false;
  const WheelSpeeds by_firmware = {wheels.left * kFirmwareRadius / radii_.left,
                                   wheels.right * kFirmwareRadius / radii_.right};
  const SpeedAndRadius motion =
      is_recognised() ? speed_and_radius(by_firmware, options_.kFirmwareSeparation) : SpeedAndRadius{};
  const bool is_sudden_stop = motion == SpeedAndRadius{} && session_.motion != motion;
  if (session_.written && *session_.written > now) session_.written = now;
  const bool is_due = session_.was_heard_since_write || is_sudden_stop || !session_.written ||
                      now - *session_.written >= kWritePeriod;
  if (is_due) {
    if (!link_->write(base_control(motion))) return false;
    session_.written = now;
    session_.motion = motion;
    session_.was_heard_since_write = false;
  }
  if (is_recognised()) ask(now);
  return is_recognised();
}

void Kobuki::ask(Time now) {
  const bool wants_gains = options_.gains.is_set && !session_.has_gains;
  if (session_.has_versions && !wants_gains) return;
  if (session_.asked && *session_.asked <= now && now - *session_.asked < kAskAgain) return;
  session_.asked = now;
  if (!session_.has_versions) link_->write(request_versions());
  if (!wants_gains) return;
  link_->write(set_user_gains(options_.gains.gains));
  link_->write(request_gains());
}

Bytes Kobuki::stop_frame() {
  constexpr std::size_t kSwallowed = 0xAA + 4;
  const Bytes one = base_control({});
  Bytes all;
  while (all.size() < kSwallowed + one.size()) all.insert(all.end(), one.begin(), one.end());
  return all;
}

void Kobuki::stop(Time now) {
  if (openings_ == 0 || !link_->write(base_control({}))) return;
  session_.written = now;
  session_.motion = {};
  link_->rest();
}

}  // namespace bw::kobuki
