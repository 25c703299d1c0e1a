// The drawings of the theory pages: one for each algorithm, made by that algorithm itself at a moment of a
// drive. They are drawn anew by `bandwagon-lab figures` and compared by a test with those that the pages show
// (docs/figures).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bw::figures {

struct Figure {
  std::string_view name;   ///< of its file, without ".svg"
  std::string_view about;  ///< one line
  std::string (*draw)();   ///< SVG; the same bytes each time
};

std::span<const Figure> all();

// From a drive in which two people cross the robot's path (components/lab/experiments/crossing_scene.hpp,
// seed 1).
std::string elastic_band();
std::string homotopy_classes();
std::string velocity_obstacle();
std::string dynamic_window();

// From a drive of a simulated robot through a room with walls.
std::string late_measurement();
std::string particle_cloud();
std::string leg_evidence();
std::string stopping_distance();

}  // namespace bw::figures
