#include "components/safety/empty_sight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace bw::safety {
namespace {

// From one sweep to the next (0.1 s, of slow lasers 0.2 s) a thing that is met at 3 m/s gets no farther away than this,
constexpr double kFarther = 1.0;  // [m]
// and at half a metre, walking aside past a robot that turns, no farther round.
constexpr double kRound = 0.3;  // [rad]
// So many points are a wall, a pillar, or a person nearer than 4 m (two legs of 0.14 m, beams 0.4 degrees apart). Who is
// farther away may be hidden by a leg, or missed.
constexpr std::size_t kCannotVanish = 10;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// The beams of one sweep by their directions in the laser's frame.
class Field {
 public:
  Field(const LaserSweep& sweep, const Pose2& X_OB)
      : range_max_(sweep.range_max),
        first_(sweep.angle_min),
        step_(sweep.angle_increment),
        size_(static_cast<std::ptrdiff_t>(sweep.ranges.size())),
        X_LO_(inverse(X_OB * sweep.X_FL)),
        has_edges_(std::abs(width()) < kTurn - kRound) {}

  /// The beam that looks at a place of odom which a sound laser sees in its next sweep too, wherever it moves; none where it may not.
  std::optional<std::size_t> lasting(const Vector2& place) const {
    const Vector2 p_L = X_LO_ * place;
    const double off = wrap_angle(std::atan2(p_L.y(), p_L.x()) - first_ - 0.5 * width());
    const bool is_within = !has_edges_ || std::abs(off) < 0.5 * std::abs(width()) - kRound;
    if (p_L.norm() >= range_max_ - kFarther || !is_within) return std::nullopt;
    const auto beam = std::lround(0.5 * static_cast<double>(size_ - 1) + off / step_);
    return static_cast<std::size_t>(wrapped(beam));
  }
  /// Adds up, for each beam, `of` over all beams up to kRound to either side.
  std::vector<std::size_t> around(const std::vector<std::size_t>& of) const {
    const auto reach = std::min<std::ptrdiff_t>(std::lround(kRound / std::abs(step_)), (size_ - 1) / 2);
    std::vector<std::size_t> sums(of.size(), 0);
    std::size_t sum = 0;
    const auto at = [&](std::ptrdiff_t beam) {
      const bool is_round = !has_edges_ || (beam >= 0 && beam < size_);
      return is_round ? of[static_cast<std::size_t>(wrapped(beam))] : 0;
    };
    for (std::ptrdiff_t beam = -reach; beam < reach; ++beam) sum += at(beam);
    for (std::ptrdiff_t beam = 0; beam < size_; ++beam) {
      sum += at(beam + reach);
      sums[static_cast<std::size_t>(beam)] = sum;
      sum -= at(beam - reach);
    }
    return sums;
  }

 private:
  double width() const { return static_cast<double>(size_ - 1) * step_; }
  std::ptrdiff_t wrapped(std::ptrdiff_t beam) const { return ((beam % size_) + size_) % size_; }

  double range_max_;
  double first_;
  double step_;
  std::ptrdiff_t size_;
  Pose2 X_LO_;
  bool has_edges_;
};

}  // namespace

bool EmptySight::believes(const LaserSweep& sweep, const Pose2& X_OB, CheckedSweep& checked) {
  std::vector<std::size_t> hits(checked.beams.size(), 0);
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = checked.beams[i] == BeamKind::hit ? 1 : 0;
  const bool is_empty = std::count(hits.begin(), hits.end(), 1U) < min_returns_;
  if (is_empty && places_.size() >= kCannotVanish) return false;
  const Field field(sweep, X_OB);
  const std::vector<std::size_t> hits_around = field.around(hits);
  std::vector<std::size_t> lost(hits.size(), 0);
  const auto is_lost = [&](const Vector2& place) {
    const auto beam = field.lasting(place);
    return beam && checked.beams[*beam] == BeamKind::free && hits_around[*beam] == 0;
  };
  std::erase_if(places_, [&](const Vector2& place) { return min_returns_ == 0 || !is_lost(place); });
  for (const Vector2& place : places_) ++lost[*field.lasting(place)];
  const std::vector<std::size_t> lost_around = field.around(lost);
  std::erase_if(places_,
                [&](const Vector2& place) { return lost_around[*field.lasting(place)] < kCannotVanish; });
  checked.dark.assign(hits.size(), false);
  for (std::size_t i = 0; i < hits.size(); ++i)
    checked.dark[i] = checked.beams[i] == BeamKind::free && lost_around[i] >= kCannotVanish;
  for (const SeenPoint& point : checked.points) {
    const Vector2 place = X_OB * point.position;
    if (field.lasting(place)) places_.push_back(place);
  }
  has_seen_ = has_seen_ || !checked.points.empty();
  return true;
}

}  // namespace bw::safety
