// The firmware of an RPLIDAR and its rotating head, emulated byte by byte from the protocol of its maker; it
// shares no code with our driver. Values in, result out: no clock, no file, no middleware.
//
// Modelled: requests and their checksums, answers, health, the motor's start, one measurement after the other
// while the head rotates, each of what is seen at its own time and angle, what the format rounds (0.25 mm,
// 1/64 degree), too near and too far, noise, faults. Not modelled: DTR, which is no byte (the motor of an A1
// rotates while it has power); the speed of the line; mirrors, glass and sun; express scans, whose requests
// get no answer, as from old firmware.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "components/model/random.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/time.hpp"

namespace bw::emulators {

/// What stands around it at an instant, counter-clockwise; the device looks along x at its 0 degrees.
struct LaserView {
  double angle_min = 0.0;         ///< [rad]
  double angle_increment = 0.0;   ///< [rad]
  std::span<const float> ranges;  ///< [m]; what is not finite is out of reach

  /// Of the nearest beam; +inf outside of the view.
  float range_at(double angle) const;
};

struct RplidarDeviceOptions {
  /// as it names itself: 24 an A1, 40 an A2, 97 an S1 (set by code alone)
  std::int64_t model = 0x18;
  double rate = 7.0;
  double sample_time = 500e-6;
  double spin_up = 0.6;
  /// [m] nearer things give no measurement (set by code alone)
  double range_min = 0.15;
  /// [m] farther things give no measurement (set by code alone)
  double range_max = 12.0;
  /// [m] standard deviation, beside that of what it is shown (set by code alone)
  double range_noise = 0.0;
  /// 0 good, 1 warning, 2 error: refuses to scan (set by code alone)
  std::int64_t health = 0;
  /// told with it (set by code alone)
  std::int64_t health_code = 0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 0.5, .max = 20, .doc = "revolutions per second at full speed"});
    v("sample_time", sample_time,
      {.unit = "s",
       .min = 50e-6,
       .max = 5e-3,
       .doc = "from one measurement to the next: 500 us an A1, 250 us an A2"});
    v("spin_up", spin_up,
      {.unit = "s", .min = 0, .max = 10, .doc = "until the head turns steadily; no measurements before"});
    v.retired({"model", "range_noise", "range_min", "range_max", "health", "health_code"},
              "a constant of rplidar_device.hpp");
  }
};

struct RplidarFaults {
  bool silent = false;
  /// what it sends is noise, as with a wrong baud (set by code alone)
  bool garbage = false;
  /// share of bytes with a flipped bit (set by code alone)
  double corrupt = 0.0;
  /// share of bytes that are lost (set by code alone)
  double lost = 0.0;
  /// answers as a model that nobody knows (set by code alone)
  bool other_model = false;
  double slow = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("silent", silent, {.doc = "neither answers nor measures"});
    v("slow", slow, {.min = 0, .max = 2, .doc = "factor of the speed of the head; 0: it stands"});
    v.retired({"garbage", "corrupt", "lost", "other_model"}, "set by code alone, in rplidar_device.hpp");
  }
};

class RplidarDevice {
 public:
  RplidarDevice(const RplidarDeviceOptions& options, std::uint64_t seed) : options_(options), random_(seed) {}

  void set_faults(const RplidarFaults& faults) { faults_ = faults; }
  /// Bytes off the cable.
  void receive(Time now, std::span<const std::uint8_t> bytes);
  /// Up to `now`: what it sends; valid until the next call. Also when no cable is plugged in: it goes on.
  std::span<const std::uint8_t> step(Time now, const LaserView& view);

  bool is_scanning() const { return is_scanning_; }
  double revolution_rate() const { return revolution_rate_; }  ///< [Hz]
  std::uint64_t refused_requests() const { return refused_requests_; }

 private:
  bool take_request(Time now);
  void obey(Time now, std::uint8_t command, std::span<const std::uint8_t> payload);
  void answer(std::uint8_t type, bool is_stream, std::span<const std::uint8_t> data, std::uint32_t length);
  double wanted_rate() const;
  void measure(const LaserView& view);
  void spoil();

  RplidarDeviceOptions options_;
  Random random_;
  RplidarFaults faults_;
  std::vector<std::uint8_t> in_;
  std::vector<std::uint8_t> out_;
  std::vector<std::uint8_t> sent_;
  std::optional<Time> next_sample_;
  std::optional<Time> boots_until_;
  bool is_scanning_ = false;
  std::optional<double> motor_speed_;  ///< share of full speed as it was told
  double revolution_rate_ = 0.0;
  double revolved_ = 0.0;  ///< clockwise from its 0 degrees, in revolutions, below 1
  bool begins_revolution_ = false;
  std::uint64_t refused_requests_ = 0;
};

}  // namespace bw::emulators
