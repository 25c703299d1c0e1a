// A picture of the run as one self-contained SVG: the map, the robot's path coloured by speed, the people's
// paths, where everybody was every two seconds, and the closest encounter.
#pragma once

#include <string>

#include "components/evaluation/run_recorder.hpp"
#include "components/evaluation/score_keeper.hpp"

namespace bw {

struct PictureOptions {
  std::string title = "Bandwagon";
  double width = 1280.0;                     ///< of the page [px]
  double footprint_period = 2.0;             ///< [s]
  std::string unfinished = "still driving";  ///< title of a drive that was not decided
  double near = 3.0;  ///< people closer to the robot than this are shown with their bodies [m]
};

std::string svg_picture(const RunRecording& recording, const ScoreCard& card,
                        const PictureOptions& options = {});

}  // namespace bw
