#include "components/evaluation/possible/optimistic_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "components/evaluation/possible/bit_field.hpp"
#include "components/evaluation/possible/motion_envelope.hpp"

namespace bw::possible {
namespace {

/// Cells by which a cell may be moved in one step: a run of columns for each of some rows.
struct MoveRow {
  int rows = 0;
  Run columns;
};

/// The part of a convex polygon between two heights, as a range of x; low > high: none.
Range between(const std::vector<Vector2>& polygon, double y_low, double y_high) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto take = [&](double x) {
    range.low = std::min(range.low, x);
    range.high = std::max(range.high, x);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    // All chords, not only the edges: the points need not be in order, and the hull is the same.
    for (std::size_t k = i; k < polygon.size(); ++k) {
      const Vector2& a = polygon[i];
      const Vector2& b = polygon[k];
      if (a.y() >= y_low && a.y() <= y_high) take(a.x());
      if (a.y() == b.y()) continue;
      for (const double y : {y_low, y_high}) {
        const double s = (y - a.y()) / (b.y() - a.y());
        if (s >= 0.0 && s <= 1.0) take(a.x() + s * (b.x() - a.x()));
      }
    }
  }
  return range;
}

/// The cells that overlap a cell of edge `cell` moved by any vector of the hull of `vectors` [m].
std::vector<MoveRow> moves_of(const std::vector<Vector2>& vectors, double cell) {
  constexpr double kRounding = 1e-9;  // [cells]
  double y_low = vectors.front().y();
  double y_high = y_low;
  for (const Vector2& vector : vectors) {
    y_low = std::min(y_low, vector.y());
    y_high = std::max(y_high, vector.y());
  }
  std::vector<MoveRow> moves;
  const int first = static_cast<int>(std::floor(y_low / cell + kRounding));
  const int last = static_cast<int>(std::ceil(y_high / cell - kRounding));
  for (int rows = first; rows <= last; ++rows) {
    const Range x = between(vectors, (rows - 1) * cell, (rows + 1) * cell);
    if (x.low > x.high) continue;
    moves.push_back({rows,
                     {static_cast<int>(std::floor(x.low / cell + kRounding)),
                      static_cast<int>(std::ceil(x.high / cell - kRounding))}});
  }
  return moves;
}

class OptimisticSearch {
 public:
  OptimisticSearch(const SearchScene& scene, const MotionState& start, const MotionBounds& bounds,
                   double until, const OptimisticSearchOptions& options)
      : scene_(scene),
        start_(start),
        bounds_(bounds),
        options_(options),
        until_(until),
        envelope_(start, bounds) {
    const double farthest = (std::max({bounds.v_max, bounds.v_back_max, std::abs(start.twist.v)}) + 0.1) *
                            std::max(0.0, until - start.time);
    const double half = std::min(options.half_width, farthest + 0.2);
    frame_ = {start.pose.position(), options.cell, 2 * static_cast<int>(half / options.cell) + 1};
    // As many bins as there are, so that the fastest rotation of a step is a whole number of them.
    const double rotation = std::max(bounds.omega_max, std::abs(start.twist.omega)) * options.step;
    const double bins_of_rotation = std::max(1.0, std::ceil(rotation / 0.05 - 1e-9));
    bins_ = std::max(8, static_cast<int>(std::floor(2.0 * std::numbers::pi * bins_of_rotation / rotation)));
    width_ = 2.0 * std::numbers::pi / bins_;
    for (std::vector<BitField>* fields : {&now_, &next_})
      fields->assign(static_cast<std::size_t>(bins_), BitField(frame_.side));
    allowed_ = BitField(frame_.side);
    blocked_ = BitField(frame_.side);
    standing_ = BitField(frame_.side);
    paint_standing();
  }

  SearchOutcome run() {
    block_at(start_.time);
    if (blocked_.at(frame_.side / 2, frame_.side / 2)) return SearchOutcome::none;
    now_[0].set(frame_.side / 2, {frame_.side / 2, frame_.side / 2});
    const int steps = static_cast<int>(std::floor((until_ - start_.time) / options_.step + 1e-9));
    for (int step = 1; step <= steps; ++step) {
      if (!move(step)) return SearchOutcome::some;
      const std::int64_t cells = cut(step);
      if (cells == 0) return SearchOutcome::none;
      if (static_cast<double>(cells) * options_.cell * options_.cell > options_.escape_area)
        return SearchOutcome::some;
      std::swap(now_, next_);
    }
    return SearchOutcome::some;
  }

 private:
  double less() const { return options_.cell / std::numbers::sqrt2; }

  void paint_standing() {
    const double robot = scene_.inner_radius - less();
    for (const Disc& disc : scene_.shapes.discs)
      paint(standing_, frame_, disc.center, disc.center, robot + disc.radius);
    for (const Vector2& point : scene_.shapes.points) paint(standing_, frame_, point, point, robot);
    for (const Segment& segment : scene_.shapes.segments)
      paint(standing_, frame_, segment.a, segment.b, robot);
    for (const Vector2& square : scene_.squares)  // the disc in it
      paint(standing_, frame_, square, square, robot + scene_.square_edge / 2.0);
  }

  void block_at(double time) {
    blocked_.clear();
    blocked_.add(standing_);
    for (const Walk& walk : scene_.walks) {
      if (const std::optional<Vector2> p = walk.at(time))
        paint(blocked_, frame_, *p, *p, scene_.inner_radius + walk.radius - less());
    }
  }

  /// False when something left the area looked at.
  bool move(int step) {
    const double h = options_.step;
    for (BitField& field : next_) field.clear();
    const Range v = envelope_.speeds(step * h);
    const Range omega = envelope_.turn_rates(step * h);
    const Range heading_change = envelope_.heading_change(step * h);
    const bool is_all_round =
        heading_change.high - heading_change.low > 2.0 * std::numbers::pi - 2.0 * width_ ||
        heading_change.high > std::numbers::pi || heading_change.low < -std::numbers::pi;
    const int least = static_cast<int>(std::floor(omega.low * h / width_ + 1e-9));
    const int most = static_cast<int>(std::ceil(omega.high * h / width_ - 1e-9));
    const double swing = std::max(std::abs(omega.low), std::abs(omega.high)) * h;
    for (int from = 0; from < bins_; ++from) {
      const BitField& source = now_[static_cast<std::size_t>(from)];
      if (source.empty()) continue;
      const int i = from <= bins_ / 2 ? from : from - bins_;
      for (int j = i + least; j <= i + most; ++j) {
        const double end_low = (j - 0.5) * width_;
        const double end_high = (j + 0.5) * width_;
        if (!is_all_round && (end_low > heading_change.high || end_high < heading_change.low)) continue;
        const double low = ((i + j - 1) * width_ - swing) / 2.0;
        const double high = ((i + j + 1) * width_ + swing) / 2.0;
        const std::vector<MoveRow> moves = moves_of(velocities(v, low, high), options_.cell);
        BitField& target = next_[static_cast<std::size_t>((j % bins_ + bins_) % bins_)];
        for (const MoveRow& row : moves)
          if (!target.add_moved(source, row.rows, row.columns)) return false;
      }
    }
    return true;
  }

  /// Points whose hull holds h times every mean of v dir(theta).
  std::vector<Vector2> velocities(const Range& v, double low, double high) const {
    const double half = (high - low) / 2.0;
    if (half > 1.2) {  // no longer an arc: every direction
      const double s = std::max(std::abs(v.low), std::abs(v.high)) * options_.step;
      return {{s, s}, {s, -s}, {-s, s}, {-s, -s}};
    }
    const double middle = start_.pose.theta + (low + high) / 2.0;
    std::vector<Vector2> points;
    for (const double speed : {v.low, v.high}) {
      const double s = speed * options_.step;
      points.emplace_back(s * direction(middle - half));
      points.emplace_back(s * direction(middle + half));
      points.emplace_back(s / std::cos(half) * direction(middle));  // where the tangents at both ends meet
    }
    return points;
  }

  /// Takes away what is in contact and what no motion can come to; cells (x, y) left.
  std::int64_t cut(int step) {
    const double elapsed = step * options_.step;
    block_at(start_.time + elapsed);
    envelope_.advance_to(elapsed);
    allowed_.clear();
    const double c = options_.cell;
    for (int row = 0; row < frame_.side; ++row) {
      const Range x = envelope_.across((row - frame_.side / 2) * c, c / 2.0);
      if (x.low > x.high) continue;
      allowed_.set(row, {static_cast<int>(std::ceil(x.low / c)) + frame_.side / 2,
                         static_cast<int>(std::floor(x.high / c)) + frame_.side / 2});
    }
    allowed_.remove(blocked_);
    all_.clear();
    if (all_.side() == 0) all_ = BitField(frame_.side);
    for (BitField& field : next_) {
      field.keep(allowed_);
      all_.add(field);
    }
    return all_.count();
  }

  const SearchScene& scene_;
  const MotionState start_;
  const MotionBounds bounds_;
  const OptimisticSearchOptions options_;
  double until_;
  MotionEnvelope envelope_;
  BitFrame frame_;
  int bins_ = 8;
  double width_ = 0.0;  ///< of a bin [rad]
  std::vector<BitField> now_, next_;
  BitField allowed_, blocked_, standing_, all_;
};

}  // namespace

SearchOutcome search_optimistically(const SearchScene& scene, const MotionState& start,
                                    const MotionBounds& bounds, double until,
                                    const OptimisticSearchOptions& options) {
  return OptimisticSearch(scene, start, bounds, until, options).run();
}

}  // namespace bw::possible
