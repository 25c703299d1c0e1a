// The figure of one integrated drive.
#pragma once

#include <string>

#include "components/evaluation/run_recorder.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// Map with the robot's path and the people near it, speed, and distance to the nearest person over time.
/// `name`: "Eddie, EDWA, seed 1".
report::Figure drive_figure(const RunRecording& course, const std::string& name, const std::string& caption);

/// (time [s], collision index) by rising time, at most 200: of each stretch of the drive the highest, so that
/// no peak is lost (the source's Figures 3.9 and 3.12).
std::vector<Vector2> index_course(const RunRecording& recording);

}  // namespace bw
