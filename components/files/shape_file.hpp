// Walls and pillars as tables: `x1_m,y1_m,x2_m,y2_m` and `x_m,y_m,r_m`.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "components/model/obstacles.hpp"

namespace bw {

/// Throw std::runtime_error ("file:line: ...") for anything but finite numbers within 10^5 m and radii >= 0.
std::vector<Segment> read_walls(std::istream& input, const std::string& file);
std::vector<Segment> read_walls(const std::string& file);
std::vector<Disc> read_circles(std::istream& input, const std::string& file);
std::vector<Disc> read_circles(const std::string& file);

}  // namespace bw
