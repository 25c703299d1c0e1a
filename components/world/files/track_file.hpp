// Recorded people: one line per person and annotation, `t_s,frame,ped_id,x_m,y_m,vx_mps,vy_mps`.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "components/world/replayed_people.hpp"

namespace bw {

/// Tracks by rising id. Positions only: the velocity used is the one that joins them. Throws
/// std::runtime_error
/// ("file:line: ...") for anything but finite numbers, whole ids in 0 ... 10^6, positions within 10^5 m, and
/// times that rise for each person.
std::vector<Track> read_tracks(std::istream& input, const std::string& file);
std::vector<Track> read_tracks(const std::string& file);

}  // namespace bw
