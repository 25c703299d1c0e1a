// Commands to a Kobuki, as packets.
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/differential_drive.hpp"

namespace bw::kobuki {

using Bytes = std::vector<std::uint8_t>;

/// The firmware's own way to say how wheels rotate: speed of the outer wheel [mm/s], radius of the middle's
/// circle [mm]; radius 0 is straight on, 1 is in place.
struct SpeedAndRadius {
  std::int16_t speed = 0, radius = 0;
  bool operator==(const SpeedAndRadius&) const = default;
};

/// `separation` b [m] is the one that the firmware turns speed and radius back into wheels by, whatever the
/// robot's true one is. With v, w from the wheels by b: |w| < 1e-4: (1000 v, 0); |v| < 1e-4 or |1000 v / w|
/// <= 1: (1000 b w / 2, 1); else r = 1000 v / w, speed = (r +- 1000 b / 2) w, + for r > 0. Fractions are cut
/// off, too large numbers limited to 16 bits. What is not finite is a stop.
SpeedAndRadius speed_and_radius(const WheelSpeeds& wheels, double separation);

Bytes base_control(const SpeedAndRadius& motion);

/// Hardware and firmware version, unique id.
Bytes request_versions();

struct Gains {
  double p = 100.0, i = 0.1, d = 2.0;  ///< of the wheels' speed controllers; those of the factory
};
Bytes set_user_gains(const Gains& gains);
Bytes request_gains();

}  // namespace bw::kobuki
