#include "tests/components/safety/monitor_laser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw::safety::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBlind = 0.12;  // [rad] to either side: more than half of what SightOptions::kMaxGap lets pass
constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Along unit vector `u` from `from` to the rim of a disc.
double to_disc(const Vector2& from, const Vector2& u, const Vector2& center, double radius) {
  const Vector2 offset = center - from;
  const double along = offset.dot(u);
  const double off = cross(u, offset);
  const double under_root = radius * radius - off * off;
  if (under_root <= 0.0 || along <= 0.0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, along - std::sqrt(under_root));
}

double to_thing(const Vector2& from, const Vector2& u, const Capsule& thing) {
  double range = std::min(to_disc(from, u, thing.a, thing.radius), to_disc(from, u, thing.b, thing.radius));
  const Vector2 side = thing.b - thing.a;
  const double length = side.norm();
  if (length == 0.0) return range;
  for (const double sign : {-1.0, 1.0}) {
    const Vector2 a = thing.a + Vector2(-side.y(), side.x()) / length * (sign * thing.radius);
    const double slant = cross(u, side);
    if (slant == 0.0) continue;
    const double along = cross(a - from, side) / slant;
    const double share = cross(a - from, u) / slant;
    if (along > 0.0 && share >= 0.0 && share <= 1.0) range = std::min(range, along);
  }
  return range;
}

}  // namespace

Laser::Laser(const Scene& scene)
    : numbers_(scene.numbers),
      random_(static_cast<std::uint64_t>(numbers_[kSeed])),
      X_BL_{numbers_[kLaserX], 0.0, numbers_[kLaserHeading]} {}

Laser::Sweep Laser::begin(double t) const {
  return {t, t + numbers_[kSweepShare] * numbers_[kPeriod], {}, {}};
}

bool Laser::go_on(Sweep& sweep, double t, const Pose2& X_WB, const std::vector<Capsule>& things) {
  const double taken = sweep.ended - sweep.begun;
  const double share = taken > 0.0 ? std::min(1.0, (t - sweep.begun) / taken) : 1.0;
  const auto due = static_cast<std::size_t>(std::floor(share * numbers_[kBeams]));
  const Pose2 X_WL = X_WB * X_BL_;
  const std::size_t first = sweep.ranges.size();
  std::vector<double> nearest(due - first, std::numeric_limits<double>::infinity());
  for (const Capsule& thing : things) meet(thing, X_WL, first, nearest);
  sweep.X_WL.resize(due, X_WL);
  sweep.ranges.reserve(due);
  for (const double distance : nearest)
    sweep.ranges.push_back(reading(angle_of(static_cast<double>(sweep.ranges.size())), t, distance));
  return share == 1.0;
}

void Laser::meet(const Capsule& thing, const Pose2& X_WL, std::size_t first,
                 std::vector<double>& nearest) const {
  // Seen from outside, a capsule is between the directions of its two discs.
  const Vector2 to_a = thing.a - X_WL.position(), to_b = thing.b - X_WL.position();
  const double least = std::min(to_a.norm(), to_b.norm());
  const double between = std::atan2(cross(to_a, to_b), to_a.dot(to_b));
  const double middle = wrap_angle(std::atan2(to_a.y(), to_a.x()) + 0.5 * between - X_WL.theta);
  const double half = 0.5 * std::abs(between) + std::asin(std::min(1.0, thing.radius / least)) + 1e-6;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const double angle = angle_of(static_cast<double>(first + i));
    const double off = std::abs(angle - middle);
    if (std::min(off, 2.0 * kPi - off) > half) continue;
    nearest[i] = std::min(nearest[i], to_thing(X_WL.position(), direction(X_WL.theta + angle), thing));
  }
}

LaserSweep Laser::view(const Sweep& sweep) const {
  const double t = sweep.middle();
  return {.time = Time::seconds(100.0 + t + numbers_[kClock] + numbers_[kDrift] * t),
          .X_FL = X_BL_,
          .angle_min = angle_of(0),
          .angle_increment = increment(),
          .range_min = 0.02,
          .range_max = numbers_[kRange],
          .ranges = sweep.ranges,
          .time_increment = (sweep.ended - sweep.begun) / numbers_[kBeams]};
}

double Laser::beam_to(const Sweep& sweep, const Vector2& position) const {
  const auto beam_at = [&](std::size_t from) {
    const Vector2 p_L = inverse(sweep.X_WL[from]) * position;
    const double off = wrap_angle(std::atan2(p_L.y(), p_L.x()) - angle_of(0));
    return (off < 0.0 ? off + 2.0 * kPi : off) / increment();
  };
  // Twice: where the scanner was is known when the beam is.
  const std::size_t last = sweep.X_WL.size() - 1;
  return beam_at(std::min(last, static_cast<std::size_t>(beam_at(last / 2))));
}

bool Laser::shows(const Sweep& sweep, const Vector2& position) const {
  const auto beam = static_cast<std::ptrdiff_t>(std::lround(beam_to(sweep, position)));
  int shown = 0;
  for (std::ptrdiff_t at = beam - 2; at <= beam + 2; ++at) {
    const std::ptrdiff_t i = is_round() ? (at + std::ssize(sweep.ranges)) % std::ssize(sweep.ranges) : at;
    if (i < 0 || i >= std::ssize(sweep.ranges)) return false;
    const auto index = static_cast<std::size_t>(i);
    const double range = (position - sweep.X_WL[index].position()).norm();
    if (std::abs(sweep.ranges[index] - range) < 0.05 + 5.0 * numbers_[kNoise]) ++shown;
  }
  return shown >= 4;
}

bool Laser::is_blind_to(const Sweep& sweep, const Vector2& position) const {
  const double beam = beam_to(sweep, position);
  const double revolution = 2.0 * kPi / increment();
  for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
    const double off = std::abs(static_cast<double>(i) - beam);
    if (std::min(off, revolution - off) * increment() < kBlind && !std::isnan(sweep.ranges[i])) return false;
  }
  return true;
}

float Laser::reading(double angle, double t, double distance) {
  const bool is_lost = numbers_[kDropout] > 0.0 && random_.uniform() < numbers_[kDropout];
  if (is_lost || std::abs(wrap_angle(angle - numbers_[kBlindAt])) < 0.5 * numbers_[kBlindWidth])
    return kUnknown;
  if (t > numbers_[kDarkFrom] && std::abs(wrap_angle(angle - numbers_[kDarkAt])) < 0.5 * numbers_[kDarkWidth])
    return kNothing;
  if (distance >= numbers_[kRange]) return kNothing;
  const double noise =
      numbers_[kNoise] > 0.0 ? numbers_[kNoise] * std::clamp(random_.normal(), -3.0, 3.0) : 0.0;
  return static_cast<float>(std::clamp(distance + noise, 0.021, numbers_[kRange]));
}

}  // namespace bw::safety::test
