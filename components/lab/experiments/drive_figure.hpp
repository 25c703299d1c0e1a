// The figure of one integrated drive.
#pragma once

#include <string>

#include "components/evaluation/run_recorder.hpp"

namespace bw {

/// Map with the robot's way and the people near it, speed, and distance to the nearest person over time: a whole
/// <figure>. `name`: "Eddie, EDWA, seed 1"; `caption`: HTML.
std::string drive_figure(const RunRecording& course, const std::string& name, const std::string& caption);

}  // namespace bw
