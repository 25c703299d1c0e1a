// Ranging sensors and supply of an Eddie as its converters tell them: two sonars and two infrared rangers
// that look ahead.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "components/emulators/emulated_base.hpp"

namespace bw::emulators {

/// Sonars on pins 0 and 1, infrared rangers on channels 1 and 2 of the converter; in this order.
std::vector<Beam> eddie_beams();

/// Of PING [units]; 0: nothing in reach, or nearer than it can tell.
std::uint32_t ping_value(double range, double units_per_mm);
/// Of a channel, 000 to FFF for 0 to 5 V; ten bits are real.
std::uint32_t adc_value(double volts);
/// Of an infrared ranger like Sharp's GP2Y0A02 [V].
double infrared_voltage(double range);
/// Of the supply behind its divider, as the channel tells it: 819 units a volt, 3.21 V at the supply a volt.
std::uint32_t supply_value(double volts);

}  // namespace bw::emulators
