// The collision index along a drive, for the source's Figures 3.9 and 3.12.
#pragma once

#include <vector>

#include "components/evaluation/run_recorder.hpp"

namespace bw {

/// (time [s], collision index) by rising time, at most 200: of each stretch of the drive the highest, so that no peak
/// is lost.
std::vector<Vector2> index_course(const RunRecording& recording);

}  // namespace bw
