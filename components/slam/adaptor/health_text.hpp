// Health in words: "OK: mapping", as the localization's messages begin.
#pragma once

#include <string>

#include "components/slam/slam_health.hpp"

namespace bw::slam {

/// Of the cause, without the state.
std::string to_text(const SlamHealth& health);

}  // namespace bw::slam
