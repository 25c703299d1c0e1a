// Units of measurement as a columns file writes them, and what makes SI of them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace bw::imports {

struct Unit {
  double scale = 1.0;           ///< to SI: metres, radians, seconds
  std::array<int, 3> powers{};  ///< of metre, radian, second
};

/// A name, a power of it, and one such divided by another: `mm`, `mm^2`, `km/h`, `deg/s`, `m/s^2`. Nothing
/// for a text that is none. Names: m, km, cm, mm, um, in, ft; rad, mrad, deg, rev; s, ms, us, ns, min, h; Hz,
/// kn, rpm, g.
std::optional<Unit> unit_of(std::string_view text);

/// The names, for messages.
std::string_view known_units();

inline constexpr std::array<int, 3> kAngle{0, 1, 0};
inline constexpr std::array<int, 3> kTurnRate{0, 1, -1};
inline constexpr std::array<int, 3> kTime{0, 0, 1};

}  // namespace bw::imports
