// How far an estimate can be trusted, and why not further: the same words for every filter.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "components/model/health_state.hpp"

namespace bw::localization {

enum class HealthCause {
  no_position,         ///< INIT: too few fixes that agree
  no_heading,          ///< INIT: no compass, not yet driven far enough
  uncertain_position,  ///< two standard deviations [m] too large
  uncertain_heading,   ///< standard deviation [rad] too large
  contradicted,        ///< positions come, and none passes the gate since [s]: LOST
  wheels_silent,       ///< since [s]
  source_silent,       ///< since [s]
  source_rejected,     ///< nothing of it used since [s]
  slipping,            ///< since [s]
  gyro_in_doubt,       ///< wheels and gyro disagreed for [s] of the last half minute: too long for slip
  estimate_reset,      ///< a source took the estimate over, that long ago [s]
  clock_jump,          ///< that long ago [s]
  no_map,              ///< a laser and no map to compare it with
  scan_mismatch,       ///< the scan does not fit the map since [s]
  searching,           ///< the whole map is searched since [s]
  several_places       ///< the scan fits in several places; weight of the best one
};

std::string_view to_string(HealthCause cause);

struct HealthReason {
  HealthCause cause;
  int source = -1;     ///< -1: none
  double value = 0.0;  ///< in the unit that the cause names
};

/// One source that has been heard.
struct SourceHealth {
  int source = 0;
  double age = 0.0;     ///< since its last stamp [s]
  double period = 0.0;  ///< between stamps [s]
  std::uint32_t used = 0;
  std::uint32_t rejected = 0;
  double acceptance = 1.0;  ///< share of the last 50 or so
  double nis = 0.0;         ///< mean over those used; an honest filter's is a little below dof
  double nis_all = 0.0;     ///< mean over all
  int dof = 0;              ///< 0: motion, which is not compared
};

struct Health {
  HealthState state = HealthState::init;
  std::vector<HealthReason> reasons;
  std::vector<SourceHealth> sources;
  double two_sigma = 0.0;      ///< of the position along the worst axis [m]
  double heading_sigma = 0.0;  ///< [rad]
};

}  // namespace bw::localization
