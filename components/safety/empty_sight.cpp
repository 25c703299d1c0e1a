#include "components/safety/empty_sight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Dense>

#include "components/model/transform2.hpp"

namespace bw::safety {
namespace {

// From one sweep to the next (0.1 s, of slow lasers 0.2 s) a thing that is met at 3 m/s gets no farther away
// than this,
constexpr double kFarther = 1.0;  // [m]
// and at half a metre, walking aside past a robot that rotates, no farther round.
constexpr double kRound = 0.3;  // [rad]
// So many points are a wall, a pillar, or a person nearer than 4 m (two legs of 0.14 m, beams 0.4 degrees
// apart). Who is farther away may be hidden by a leg, or missed.
constexpr std::size_t kCannotVanish = 10;
// What stands is so many already: a leg at 2 m, beams 1 degree apart,
constexpr std::size_t kSeenStanding = 5;
constexpr Duration kStands = Duration::milliseconds(500);
// where hits lie no farther apart than noise and the odometry of that time bring them.
constexpr double kSame = 0.1;          // [m]
constexpr std::ptrdiff_t kBeside = 2;  // beams
// How odometry errs is read off surfaces so long that noise turns them little,
constexpr std::ptrdiff_t kSurface = 5;  // beams to either side
// against odometry, which counts as so many hits: theirs is 0.02 m of noise, its 2 mm and 2 mrad from one
// sweep to the next.
constexpr double kOdometry = 100.0;
// Fewer that are lost may be of a thing that is hit now and then.
constexpr Duration kForgets = Duration::milliseconds(5'000);
constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// The beams of one sweep by their directions in the laser's frame.
class Field {
 public:
  Field(const LaserSweep& sweep, const Pose2& X_OB)
      : range_max_(sweep.range_max),
        first_(sweep.angle_min),
        step_(sweep.angle_increment),
        size_(static_cast<std::ptrdiff_t>(sweep.ranges.size())),
        X_LO_(inverse(X_OB * sweep.X_FL)),
        has_edges_(std::abs(width()) < kTwoPi - kRound) {}

  /// The beam that looks at a position of odom which a sound laser sees in its next sweep too, wherever it
  /// moves; none where it may not.
  std::optional<std::size_t> lasting(const Vector2& position) const {
    const Vector2 p_L = X_LO_ * position;
    const double off = wrap_angle(std::atan2(p_L.y(), p_L.x()) - first_ - 0.5 * width());
    const bool is_within = !has_edges_ || std::abs(off) < 0.5 * std::abs(width()) - kRound;
    if (p_L.norm() >= range_max_ - kFarther || !is_within) return std::nullopt;
    const auto beam = std::lround(0.5 * static_cast<double>(size_ - 1) + off / step_);
    return static_cast<std::size_t>(wrapped(beam));
  }
  double distance(const Vector2& position) const { return (X_LO_ * position).norm(); }
  /// The beam `offset` beams beside one; none beyond the edges.
  std::optional<std::size_t> beside(std::size_t beam, std::ptrdiff_t offset) const {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(beam) + offset;
    if (has_edges_ && (at < 0 || at >= size_)) return std::nullopt;
    return static_cast<std::size_t>(wrapped(at));
  }
  /// Adds up, for each beam, `of` over all beams up to `angle` to either side.
  std::vector<std::size_t> around(const std::vector<std::size_t>& of, double angle = kRound) const {
    const auto reach = std::min<std::ptrdiff_t>(std::lround(angle / std::abs(step_)), (size_ - 1) / 2);
    std::vector<std::size_t> sums(of.size(), 0);
    if (std::ranges::count(of, 0U) == size_) return sums;
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
  std::ptrdiff_t wrapped(std::ptrdiff_t beam) const {
    return beam >= 0 && beam < size_ ? beam : ((beam % size_) + size_) % size_;  // nearly always: no division
  }

  double range_max_;
  double first_;
  double step_;
  std::ptrdiff_t size_;
  Transform2 X_LO_;
  bool has_edges_;
};

}  // namespace

/// What one sweep says of the positions that were seen before.
class EmptySight::Memory {
 public:
  Memory(const LaserSweep& sweep, const Pose2& X_OB, const CheckedSweep& checked)
      : sweep_(sweep), X_OB_(X_OB), checked_(checked), field_(sweep, X_OB), hits_(beams()) {
    const Transform2 to_odom(X_OB);
    for (std::size_t i = 0; i < beams(); ++i) {
      if (!is_hit(i)) continue;
      const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
      hits_[i] = to_odom * (scanner_at(sweep, i) * (static_cast<double>(sweep.ranges[i]) * direction(angle)));
    }
  }

  /// Keeps of `points` what is seen again, and what is lost; adds what is seen anew.
  void follow(std::vector<TrackedPoint>& points) const {
    const std::vector<std::size_t> hits_around = count([&](std::size_t i) { return is_hit(i); });
    std::erase_if(points, [&](TrackedPoint& point) { return !keeps(point, hits_around); });
    align(points);
    const std::vector<TrackedPoint> seen = anew(points);
    points.insert(points.end(), seen.begin(), seen.end());
    const auto moved = around(points, [&](const TrackedPoint& point) {
      return !point.lost_at && sweep_.time - point.since < kStands;
    });
    const auto is_new = [&](const TrackedPoint& point) { return point.lost_at == sweep_.time; };
    const auto vanished = around(points, is_new, 0.5 * kRound);  // what was there went up to kRound aside
    const auto has_moved = [&](const TrackedPoint& point) {
      return is_new(point) && moved[point.beam] >= vanished[point.beam];
    };
    std::erase_if(points, has_moved);
    const std::vector<bool> gone = is_gone(points);
    for (TrackedPoint& point : points)
      if (point.lost_at && gone[point.beam]) point.is_missed = true;
    std::erase_if(points, [&](const TrackedPoint& point) {
      return point.lost_at && !gone[point.beam] && sweep_.time - *point.lost_at > kForgets;
    });
  }
  /// Which free beams look at what is lost.
  std::vector<bool> dark(const std::vector<TrackedPoint>& points) const {
    std::vector<bool> dark = is_gone(points);
    for (std::size_t i = 0; i < beams(); ++i) dark[i] = dark[i] && checked_.beams[i] == BeamKind::free;
    return dark;
  }

 private:
  std::size_t beams() const { return checked_.beams.size(); }
  bool is_hit(std::size_t beam) const { return checked_.beams[beam] == BeamKind::hit; }
  template <class Counts>
  std::vector<std::size_t> count(Counts counts) const {
    std::vector<std::size_t> of(beams(), 0);
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = counts(i) ? 1 : 0;
    return field_.around(of);
  }
  /// Beams that look at a point that counts; several points may be of one place.
  template <class Counts>
  std::vector<std::size_t> around(const std::vector<TrackedPoint>& points, Counts counts,
                                  double angle = kRound) const {
    std::vector<std::size_t> of(beams(), 0);
    for (const TrackedPoint& point : points)
      if (counts(point)) of[point.beam] = 1;
    return field_.around(of, angle);
  }

  /// By beams, whether so much is lost around that something was there.
  std::vector<bool> is_gone(const std::vector<TrackedPoint>& points) const {
    const auto lost = around(points, [](const TrackedPoint& point) { return point.lost_at.has_value(); });
    const auto stood = around(points, [](const TrackedPoint& point) {
      return point.lost_at && *point.lost_at - point.since >= kStands;
    });
    // What is missed lies farther apart the nearer it is.
    const auto missed = around(points, [](const TrackedPoint& point) { return point.is_missed; });
    std::vector<bool> gone(beams(), false);
    for (std::size_t i = 0; i < beams(); ++i)
      gone[i] = missed[i] > 0 || lost[i] >= kCannotVanish || stood[i] >= kSeenStanding;
    return gone;
  }

  bool keeps(TrackedPoint& point, const std::vector<std::size_t>& hits_around) const {
    const auto beam = field_.lasting(point.position);
    if (!beam) return false;
    point.beam = *beam;
    bool is_another = false;
    for (std::ptrdiff_t offset = -kBeside; offset <= kBeside; ++offset) {
      const auto near = field_.beside(*beam, offset);
      if (!near || !is_hit(*near)) continue;
      is_another = true;
      if (std::abs(sweep_.ranges[*near] - field_.distance(point.position)) > kSame) continue;
      if (point.lost_at)
        point = {point.position, *beam, sweep_.time, point.is_narrow};  // of another thing, maybe
      return true;
    }
    if (is_another) return false;
    if (checked_.beams[*beam] != BeamKind::free) return true;
    const bool stands = sweep_.time - point.since >= kStands;
    if (!point.lost_at && !stands && hits_around[*beam] > 0) return false;
    if (!point.lost_at) point.lost_at = sweep_.time;
    return true;
  }

  /// Across the surface that a beam hits in the midst of others, in odom; none at an edge.
  std::optional<Vector2> normal(std::size_t beam) const {
    const auto before = field_.beside(beam, -kSurface);
    const auto after = field_.beside(beam, kSurface);
    if (!before || !after || !is_hit(beam) || !is_hit(*before) || !is_hit(*after)) return std::nullopt;
    const Vector2& a = hits_[*before];
    const Vector2& b = hits_[*after];
    if ((hits_[beam] - 0.5 * (a + b)).norm() > kSame) return std::nullopt;
    return Vector2(a.y() - b.y(), b.x() - a.x()).normalized();
  }

  /// Moves all points, lost ones too, by as much as odometry erred: so that those which are seen again lie on
  /// the surfaces that the sweep hits (one step of point to line; Censi, ICRA 2008). A cover moves no hit.
  void align(std::vector<TrackedPoint>& points) const {
    const Vector2 laser = (X_OB_ * sweep_.X_FL).position();
    Eigen::Matrix3d information = kOdometry * Eigen::Matrix3d::Identity();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();  // x, y, rotation about the laser
    for (const TrackedPoint& point : points) {
      const auto across = point.is_narrow ? std::nullopt : normal(point.beam);
      if (!across) continue;
      const double miss = across->dot(hits_[point.beam] - point.position);
      if (std::abs(miss) > kSame) continue;
      const Eigen::Vector3d row(across->x(), across->y(), cross(point.position - laser, *across));
      information += row * row.transpose();
      pull += miss * row;
    }
    const Eigen::Vector3d error = information.ldlt().solve(pull);
    const Transform2 moved({laser.x() + error.x(), laser.y() + error.y(), error.z()});
    for (TrackedPoint& point : points) point.position = moved * (point.position - laser);
  }

  /// Of beams that no point tells of; one right beside a point is of the same thing.
  std::vector<TrackedPoint> anew(const std::vector<TrackedPoint>& points) const {
    std::vector<std::optional<Time>> since(beams());
    for (const TrackedPoint& point : points) {
      if (point.lost_at) continue;
      std::optional<Time>& oldest = since[point.beam];
      oldest = std::min(oldest.value_or(point.since), point.since);
    }
    std::vector<TrackedPoint> seen;
    for (const SeenPoint& point : checked_.points) {
      const Vector2 position = X_OB_ * point.position;
      const auto beam = field_.lasting(position);
      if (!beam || since[*beam]) continue;
      TrackedPoint fresh{position, *beam, sweep_.time, point.is_narrow};
      for (const std::ptrdiff_t offset : {-1, 1})
        if (const auto near = field_.beside(*beam, offset); near && since[*near])
          fresh.since = std::min(fresh.since, *since[*near]);
      seen.push_back(fresh);
    }
    return seen;
  }

  const LaserSweep& sweep_;
  const Pose2& X_OB_;
  const CheckedSweep& checked_;
  Field field_;
  std::vector<Vector2> hits_;  ///< of beams that hit, in odom
};

bool EmptySight::believes(const LaserSweep& sweep, const Pose2& X_OB, CheckedSweep& checked) {
  const auto hits = std::ranges::count(checked.beams, BeamKind::hit);
  if (hits < min_returns_ && points_.size() >= kCannotVanish) return false;
  has_seen_ = has_seen_ || !checked.points.empty();
  if (min_returns_ == 0) return true;
  const Memory memory(sweep, X_OB, checked);
  memory.follow(points_);
  checked.dark = memory.dark(points_);
  return true;
}

}  // namespace bw::safety
