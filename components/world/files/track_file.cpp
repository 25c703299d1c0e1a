#include "components/world/files/track_file.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "components/files/csv_file.hpp"

namespace bw {
namespace {

constexpr std::string_view kHeader = "t_s,frame,ped_id,x_m,y_m,vx_mps,vy_mps";
constexpr double kLargestId = 1e6;
constexpr double kFarthest = 1e5;  // [m]

std::vector<Track> to_tracks(const std::vector<CsvRow>& rows, const std::string& file) {
  std::map<std::uint32_t, Track> by_id;
  for (const CsvRow& row : rows) {
    const double id = row.values[2];
    if (id < 0.0 || id > kLargestId || id != std::floor(id)) {
      fail_at(file, row.line, "ped_id must be a whole number from 0 to 1000000");
    }
    const TrackSample sample{row.values[0], {row.values[3], row.values[4]}};
    if (sample.position.cwiseAbs().maxCoeff() > kFarthest) {
      fail_at(file, row.line, "x_m and y_m must lie within 100000 m of the origin");
    }
    Track& track = by_id[static_cast<std::uint32_t>(id)];
    track.id = static_cast<std::uint32_t>(id);
    if (!track.samples.empty() && sample.time <= track.samples.back().time) {
      fail_at(file, row.line, "t_s must rise from line to line of person " + std::to_string(track.id));
    }
    track.samples.push_back(sample);
  }
  std::vector<Track> tracks;
  tracks.reserve(by_id.size());
  for (auto& [id, track] : by_id) tracks.push_back(std::move(track));
  return tracks;
}

}  // namespace

std::vector<Track> read_tracks(std::istream& input, const std::string& file) {
  return to_tracks(read_csv(input, file, kHeader), file);
}

std::vector<Track> read_tracks(const std::string& file) { return to_tracks(read_csv(file, kHeader), file); }

}  // namespace bw
