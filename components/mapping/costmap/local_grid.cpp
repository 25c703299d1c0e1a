#include "components/mapping/costmap/local_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/mapping/costmap/cell_walk.hpp"
#include "components/model/footprint_distance.hpp"

namespace bw::costmap {
namespace {

constexpr std::uint8_t kFull = 4;      // evidence a cell can have
constexpr std::uint8_t kOccupied = 3;  // at which it becomes occupied
constexpr std::uint8_t kMaxWeight = 4;

// Moves the window's content so that what was at (column + columns, row + rows) is at (column, row).
template <class Value>
void shift(std::vector<Value>& values, int width, int height, int columns, int rows, const Value& fresh) {
  const auto row_start = [&](int row) { return values.begin() + static_cast<std::ptrdiff_t>(row) * width; };
  const auto shift_row = [&](int row) {
    const auto to = row_start(row);
    const int from = row + rows;
    if (from < 0 || from >= height || std::abs(columns) >= width) {
      std::fill(to, to + width, fresh);
    } else if (columns >= 0) {
      std::fill(std::copy(row_start(from) + columns, row_start(from) + width, to), to + width, fresh);
    } else {
      std::copy_backward(row_start(from), row_start(from) + width + columns, to + width);
      std::fill(to, to - columns, fresh);
    }
  };
  if (rows >= 0) {
    for (int row = 0; row < height; ++row) shift_row(row);
  } else {
    for (int row = height; row-- > 0;) shift_row(row);
  }
}

}  // namespace

LocalGrid::LocalGrid(const GridOptions& options) : options_(options) {
  grid_.resolution = options.resolution;
  grid_.width = std::max(1, static_cast<int>(std::lround(options.width / options.resolution)));
  grid_.height = std::max(1, static_cast<int>(std::lround(options.height / options.resolution)));
  const std::size_t count = static_cast<std::size_t>(grid_.width) * static_cast<std::size_t>(grid_.height);
  grid_.cells.resize(count);
  cells_.resize(count);
  marks_.resize(count);
  sum_of_.resize(count);
  surface_.resize(count);
  clear();
}

void LocalGrid::clear() {
  std::fill(grid_.cells.begin(), grid_.cells.end(), OccupancyGrid::kUnknown);
  std::fill(cells_.begin(), cells_.end(), Cell{});
  std::fill(surface_.begin(), surface_.end(), Eigen::Vector2f::Zero());
  empty_ = true;
}

void LocalGrid::clear_square(const Vector2& center, double edge, bool inside) {
  for (int row = 0; row < grid_.height; ++row) {
    for (int column = 0; column < grid_.width; ++column) {
      const Vector2 offset = grid_.center(column, row) - center;
      if ((offset.cwiseAbs().maxCoeff() <= edge / 2.0) != inside) continue;
      const std::size_t i = grid_.index(column, row);
      grid_.cells[i] = OccupancyGrid::kUnknown;
      cells_[i] = {};
      surface_[i].setZero();
    }
  }
}

SweepFault LocalGrid::add(const LaserSweep& sweep, const Pose2& X_OB, const Footprint& footprint,
                          const std::vector<Disc>& people) {
  if (const SweepFault fault = fault_of(sweep); fault != SweepFault::none) return fault;
  if (!is_finite(X_OB) || (X_OB.position() - sweep.X_FL.position()).norm() > 100.0)
    return SweepFault::bad_pose;
  if (!empty_ && sweep.time <= time_) {
    if (time_ - sweep.time < Duration::milliseconds(1000)) return SweepFault::not_later;
    clear();  // the clock was set back
  }
  const double dt = empty_ ? 0.0 : (sweep.time - time_).to_seconds();
  time_ = sweep.time;
  roll_to(X_OB.position());
  empty_ = false;

  std::fill(marks_.begin(), marks_.end(), kNothing);
  for (const Disc& person : people) mark_disc(person.center, person.radius + options_.kPeopleMargin, kPerson);
  mark_under(footprint, X_OB);
  draw(sweep);
  judge(dt);
  find_surface();
  return SweepFault::none;
}

void LocalGrid::roll_to(const Vector2& center) {
  const auto column0 = static_cast<std::int64_t>(std::floor(center.x() / grid_.resolution)) - grid_.width / 2;
  const auto row0 = static_cast<std::int64_t>(std::floor(center.y() / grid_.resolution)) - grid_.height / 2;
  const auto by = [](std::int64_t to, std::int64_t from, int size) {
    return static_cast<int>(std::clamp<std::int64_t>(to - from, -size, size));
  };
  const int columns = by(column0, column0_, grid_.width);
  const int rows = by(row0, row0_, grid_.height);
  if (!empty_ && (columns != 0 || rows != 0)) {
    shift(grid_.cells, grid_.width, grid_.height, columns, rows, OccupancyGrid::kUnknown);
    shift(cells_, grid_.width, grid_.height, columns, rows, Cell{});
  }
  column0_ = column0;
  row0_ = row0;
  grid_.origin = Vector2(static_cast<double>(column0), static_cast<double>(row0)) * grid_.resolution;
}

/// A cell less than the outline: the robot may stand close to a wall.
void LocalGrid::mark_under(const Footprint& footprint, const Pose2& X_OB) {
  if (!footprint.is_polygon())
    return mark_disc(X_OB.position(), footprint.radius - grid_.resolution, kUnderRobot);
  const Vector2 reach = Vector2::Constant(footprint.radius);
  const Vector2 low = (to_cells(X_OB.position() - reach)).array().floor().max(0.0);
  const Vector2 high = to_cells(X_OB.position() + reach);
  const int columns = std::min(grid_.width, static_cast<int>(std::max(0.0, high.x() + 1.0)));
  const int rows = std::min(grid_.height, static_cast<int>(std::max(0.0, high.y() + 1.0)));
  for (int row = static_cast<int>(low.y()); row < rows; ++row) {
    for (int column = static_cast<int>(low.x()); column < columns; ++column) {
      const Vector2 center = grid_.center(column, row);
      if (gap_to(footprint, X_OB, {center, center, 0.0}, 0.0) <= -grid_.resolution)
        raise(grid_.index(column, row), kUnderRobot);
    }
  }
}

void LocalGrid::mark_disc(const Vector2& center, double radius, Mark mark) {
  if (!center.allFinite() || !(radius > 0.0)) return;
  const auto clamped = [](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell), 0.0, static_cast<double>(count)));
  };
  const Vector2 c = to_cells(center);
  const double r = radius / grid_.resolution;
  for (int row = clamped(c.y() - r, grid_.height); row < clamped(c.y() + r + 1.0, grid_.height); ++row) {
    for (int column = clamped(c.x() - r, grid_.width); column < clamped(c.x() + r + 1.0, grid_.width);
         ++column) {
      const double dx = column + 0.5 - c.x();
      const double dy = row + 0.5 - c.y();
      if (dx * dx + dy * dy <= r * r) raise(grid_.index(column, row), mark);
    }
  }
}

void LocalGrid::draw(const LaserSweep& sweep) {
  const std::size_t count = sweep.ranges.size();
  struct Hit {
    Vector2 point{0.0, 0.0};
    Mark mark = kNothing;  // of its cell, or nothing where the beam hit nothing
  };
  Hit first;
  Hit previous;
  for (std::size_t i = 0; i < count; ++i) {
    const double range = static_cast<double>(sweep.ranges[i]);
    const Pose2& X_OL = scanner_at(sweep, i);
    const Vector2 from = X_OL.position();
    const Vector2 unit =
        direction(X_OL.theta + sweep.angle_min + static_cast<double>(i) * sweep.angle_increment);
    const BeamKind kind = kind_of(sweep.ranges[i], sweep);
    Hit now;
    if (kind == BeamKind::free) {
      cross(from, unit, std::min(options_.raytrace_max_range, sweep.range_max), false);
    } else if (kind == BeamKind::hit && range >= options_.obstacle_min_range) {
      const bool within = range <= options_.raytrace_max_range;
      cross(from, unit, within ? range : options_.raytrace_max_range, within);
      if (within) {
        now = {from + range * unit, range <= options_.obstacle_max_range ? kHit : kKept};
        hit(now.point, now.mark);
      }
    }
    link(previous.point, now.point, std::min(previous.mark, now.mark));
    if (i == 0) first = now;
    previous = now;
  }
  const double angle = (static_cast<double>(count) + 0.5) * std::abs(sweep.angle_increment);
  if (angle >= 2.0 * std::numbers::pi) link(previous.point, first.point, std::min(previous.mark, first.mark));
}

void LocalGrid::cross(const Vector2& from, const Vector2& unit, double range, bool hit) {
  const double sure = hit ? 1.0 - options_.hit_margin / range : 1.0;
  const auto visit = [&](int column, int row, double leave) {
    // The last cell is not crossed: it holds the hit, or the beam's end.
    if (leave >= 1.0 || !grid_.contains(column, row)) return false;
    raise(grid_.index(column, row), leave <= sure ? kCrossed : kSeen);
    return true;
  };
  walk_cells(to_cells(from), to_cells(from + range * unit), visit);
}

void LocalGrid::hit(const Vector2& point, Mark mark) {
  const Vector2 p = to_cells(point);
  add_point(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())), p, mark);
}

void LocalGrid::link(const Vector2& a, const Vector2& b, Mark mark) {
  if (mark == kNothing || (b - a).squaredNorm() > options_.link_gap * options_.link_gap) return;
  const Vector2 from = to_cells(a);
  const Vector2 across = to_cells(b) - from;
  double enter = 0.0;
  walk_cells(from, from + across, [&](int column, int row, double leave) {
    add_point(column, row, from + (enter + leave) / 2.0 * across, mark);
    enter = leave;
    return true;
  });
}

void LocalGrid::add_point(int column, int row, const Vector2& point, Mark mark) {
  if (!grid_.contains(column, row)) return;
  const std::size_t cell = grid_.index(column, row);
  raise(cell, mark);
  if (mark != kHit || marks_[cell] != kHit) return;
  if (sum_of_[cell] == 0) {
    sums_.push_back({});
    sum_of_[cell] = static_cast<std::int32_t>(sums_.size());
  }
  Sum& sum = sums_[static_cast<std::size_t>(sum_of_[cell] - 1)];
  sum.dx += static_cast<float>(point.x() - column - 0.5);
  sum.dy += static_cast<float>(point.y() - row - 0.5);
  ++sum.points;
}

void LocalGrid::judge(double dt) {
  const auto step = static_cast<float>(dt);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell& cell = cells_[i];
    std::int8_t& value = grid_.cells[i];
    cell.age += step;
    switch (marks_[i]) {
      case kHit:
        win(cell, value, sums_[static_cast<std::size_t>(sum_of_[i] - 1)]);
        sum_of_[i] = 0;
        break;
      case kCrossed:
        if (cell.evidence > 1) {
          --cell.evidence;
        } else {
          cell = {};
          value = OccupancyGrid::kFree;
        }
        break;
      case kSeen:
        if (value < 0 && cell.evidence == 0) value = OccupancyGrid::kFree;
        fade(cell, value);
        break;
      case kKept:
        cell.age = 0.0F;
        break;
      case kUnderRobot:
        cell = {};
        value = OccupancyGrid::kFree;
        break;
      case kPerson:
        cell = {};
        if (value > 0) value = OccupancyGrid::kFree;
        break;
      case kNothing:
        fade(cell, value);
        break;
    }
  }
  sums_.clear();
}

void LocalGrid::win(Cell& cell, std::int8_t& value, const Sum& sum) {
  const int won = sum.points > 1 ? 3 : 2;
  cell.evidence = static_cast<std::uint8_t>(std::min(cell.evidence + won, int{kFull}));
  if (cell.hits < 255) ++cell.hits;
  cell.age = 0.0F;
  cell.weight = std::min<std::uint8_t>(static_cast<std::uint8_t>(cell.weight + 1), kMaxWeight);
  const auto points = static_cast<float>(sum.points);
  cell.dx += (sum.dx / points - cell.dx) / static_cast<float>(cell.weight);
  cell.dy += (sum.dy / points - cell.dy) / static_cast<float>(cell.weight);
  if (cell.evidence >= kOccupied) value = OccupancyGrid::kOccupied;
}

void LocalGrid::fade(Cell& cell, std::int8_t& value) const {
  if (cell.evidence == 0) return;
  const double keep = cell.hits >= options_.settled_hits ? options_.decay_time : options_.young_time;
  if (static_cast<double>(cell.age) <= keep) return;
  cell = {};
  if (value > 0) value = OccupancyGrid::kUnknown;
}

// Of the mean of a cell: odometry may have moved since it was last hit.
float LocalGrid::trust(const Cell& cell) {
  constexpr float kFresh = 0.2F;  // [s]
  const float stale = cell.age / kFresh;
  return static_cast<float>(cell.weight) / (1.0F + stale * stale);
}

void LocalGrid::find_surface() {
  constexpr int kSides[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  const auto value_at = [&](int column, int row) {
    return grid_.contains(column, row) ? grid_.at(column, row) : OccupancyGrid::kUnknown;
  };
  for (int row = 0; row < grid_.height; ++row) {
    for (int column = 0; column < grid_.width; ++column) {
      const std::size_t i = grid_.index(column, row);
      if (grid_.cells[i] <= 0) {
        surface_[i].setZero();
        continue;
      }
      float weight = trust(cells_[i]);
      Eigen::Vector2f sum = weight * Eigen::Vector2f(cells_[i].dx, cells_[i].dy);
      for (const auto& side : kSides) {
        if (value_at(column + side[0], row + side[1]) != OccupancyGrid::kFree) continue;
        if (value_at(column - side[0], row - side[1]) <= 0) continue;
        const Cell& behind = cells_[grid_.index(column - side[0], row - side[1])];
        const float trust_behind = trust(behind);
        sum += trust_behind * Eigen::Vector2f(behind.dx - static_cast<float>(side[0]),
                                              behind.dy - static_cast<float>(side[1]));
        weight += trust_behind;
      }
      surface_[i] = sum / weight;
    }
  }
}

}  // namespace bw::costmap
