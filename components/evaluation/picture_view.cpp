#include "components/evaluation/picture_view.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

constexpr double kRoom = 2.0;          // about the drive [m]
constexpr double kRim = 0.25;          // beyond the border of the map [m]
constexpr double kFlattest = 1 / 3.0;  // height over width
constexpr double kSteepest = 1.0;

void widen(Eigen::AlignedBox2d& box, int axis, double size) {
  const double missing = size - box.sizes()[axis];
  if (missing <= 0.0) return;
  box.min()[axis] -= missing / 2.0;
  box.max()[axis] += missing / 2.0;
}

/// Moves the box along one axis so that it shows nothing beyond the border that it could show within; what is
/// larger than the border has it in its middle.
void shift_inside(Eigen::AlignedBox2d& box, int axis, const Eigen::AlignedBox2d& border) {
  const double size = box.sizes()[axis];
  double low = std::clamp(box.min()[axis], border.min()[axis],
                          std::max(border.min()[axis], border.max()[axis] - size));
  if (size > border.sizes()[axis]) low = border.center()[axis] - size / 2.0;
  box.min()[axis] = low;
  box.max()[axis] = low + size;
}

/// Where the map ends, as far as it is known; empty: nothing is.
Eigen::AlignedBox2d border_of(const RunRecording& recording) {
  Eigen::AlignedBox2d border;
  if (recording.map) {
    const OccupancyGrid& map = *recording.map;
    border.extend(map.origin);
    border.extend(map.origin + Vector2(map.width * map.resolution, map.height * map.resolution));
  } else {
    for (const Segment& wall : recording.shapes.segments) border.extend(wall.a).extend(wall.b);
    for (const Disc& disc : recording.shapes.discs) {
      border.extend(disc.center - Vector2::Constant(disc.radius));
      border.extend(disc.center + Vector2::Constant(disc.radius));
    }
  }
  return border;
}

}  // namespace

PictureView view_of(const RunRecording& recording, double width, const Vector2& corner) {
  Eigen::AlignedBox2d drive;
  for (const Vector2& goal : recording.goals) drive.extend(goal);
  for (const RecordedMoment& moment : recording.moments) drive.extend(moment.X_MB.position());
  Eigen::AlignedBox2d box = drive;
  box.min().array() -= kRoom;
  box.max().array() += kRoom;
  Eigen::AlignedBox2d border = border_of(recording);
  const bool is_bordered = !border.isEmpty() && border.intersects(box);
  if (is_bordered) {
    border.extend(drive);
    border.min().array() -= kRim;
    border.max().array() += kRim;
    box = box.intersection(border);
  }
  widen(box, 1, box.sizes().x() * kFlattest);
  widen(box, 0, box.sizes().y() / kSteepest);
  if (is_bordered) {
    shift_inside(box, 0, border);
    shift_inside(box, 1, border);
  }
  return {box, width / box.sizes().x(), corner};
}

std::vector<Eigen::AlignedBox2d> cell_blocks(const OccupancyGrid& grid, const Eigen::AlignedBox2d& window,
                                             int lowest, int highest) {
  using Run = std::pair<int, int>;  // first column, one past the last
  std::map<Run, int> open;          // run -> first row in which it began
  std::vector<Eigen::AlignedBox2d> blocks;
  const auto close = [&](const Run& run, int first_row, int end_row) {
    blocks.emplace_back(Vector2(grid.origin + grid.resolution * Vector2(run.first, first_row)),
                        Vector2(grid.origin + grid.resolution * Vector2(run.second, end_row)));
  };

  const int first_column = std::max(0, grid.column_of(window.min().x()));
  const int end_column = std::min(grid.width, grid.column_of(window.max().x()) + 1);
  const int first_row = std::max(0, grid.row_of(window.min().y()));
  const int end_row = std::min(grid.height, grid.row_of(window.max().y()) + 1);
  for (int row = first_row; row < end_row; ++row) {
    std::map<Run, int> now;
    for (int column = first_column; column < end_column; ++column) {
      const auto inside = [&](int c) {
        return c < end_column && grid.at(c, row) >= lowest && grid.at(c, row) <= highest;
      };
      if (!inside(column)) continue;
      const int begin = column;
      while (inside(column)) ++column;
      const Run run{begin, column};
      const auto above = open.find(run);
      now[run] = above == open.end() ? row : above->second;
      if (above != open.end()) open.erase(above);
    }
    for (const auto& [run, since] : open) close(run, since, row);
    open = std::move(now);
  }
  for (const auto& [run, since] : open) close(run, since, end_row);
  return blocks;
}

std::string cells_path(const OccupancyGrid& grid, const PictureView& view, int lowest, int highest) {
  std::string data;
  for (const Eigen::AlignedBox2d& block : cell_blocks(grid, view.window_in_map, lowest, highest)) {
    const Vector2 upper_left = view({block.min().x(), block.max().y()});
    const std::string w = fixed(block.sizes().x() * view.scale, 1);
    data += 'M' + fixed(upper_left.x(), 1) + ' ' + fixed(upper_left.y(), 1) + 'h' + w + 'v' +
            fixed(block.sizes().y() * view.scale, 1) + "h-" + w + 'z';
  }
  return data;
}

}  // namespace bw
