#include "components/local_planner/teb/nearest_statics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "components/model/nearest_point.hpp"

namespace bw::teb {
namespace {

constexpr double kSameSpot = 0.05;   // [m]
constexpr double kSamePoint = 1e-9;  // [m]
// How wide a spot is where there are many, by how much nearer it must come to cost something: from there on
// what lies beside it is reached on nearly the same path.
constexpr double kSpotWidening = 1.5;

// Tells apart all that differ, by the distance from the robot first: that is the same in every frame.
auto order_of(const Capsule& c, const Vector2& robot) {
  return std::tuple(distance_to(robot, c).distance, c.a.x(), c.a.y(), c.b.x(), c.b.y(), c.radius);
}

}  // namespace

NearestStatics::NearestStatics(const ObstacleField& field, double reach, double costly)
    : field_(field), reach_(reach), costly_(costly) {}

void NearestStatics::look_along(const Segment& path, double aside) {
  around_.clear();
  const double limit = aside + reach_ + field_.footprint.radius;
  const double half = 0.5 * (path.b - path.a).norm();
  field_.statics.visit_near(0.5 * (path.a + path.b), half + limit, [&](const CapsuleIndex::Group& group) {
    const Vector2 middle = 0.5 * (group.low + group.high);
    const double extent = 0.5 * (group.high - group.low).norm() + group.radius;
    const double squared = (middle - nearest_point(path, middle)).squaredNorm();
    if (squared <= (limit + extent) * (limit + extent)) around_.push_back(group);
  });
}

std::size_t NearestStatics::find(const Pose2& pose, std::size_t most, std::vector<NearStatic>& found) {
  const auto is_later = [this](const Candidate& l, const Candidate& r) { return is_before(r, l); };
  found.clear();
  spare_.clear();
  spots_.clear();
  collect(pose);
  const bool many = candidates_.size() > most;
  std::array<std::size_t, 3> slots{most, (most + 1) / 2, (most + 1) / 2};  // ahead or behind, left, right
  std::size_t left_out = 0;
  std::make_heap(candidates_.begin(), candidates_.end(), is_later);
  while (!candidates_.empty() && found.size() < most) {
    std::pop_heap(candidates_.begin(), candidates_.end(), is_later);
    Candidate& next = candidates_.back();
    if (next.distance >= costly_ && found.size() + spare_.size() >= most) break;
    std::size_t& slots_left = slots[side_of(pose, next)];
    if (slots_left == 0 && spare_.size() == most) {
      left_out += next.distance < costly_;
      if (next.index == kGroup) {
        candidates_.pop_back();
        continue;
      }
      spots_.push_back({next.spot, kSamePoint * kSamePoint});  // others of its group may be on the other side
    } else if (next.index != kGroup && !is_known(next.spot)) {
      (slots_left > 0 ? found : spare_).push_back({next.distance, next.spot, next.index});
      if (slots_left > 0) --slots_left;
      const double radius = many ? std::max(kSameSpot, kSpotWidening * (next.distance - costly_)) : kSameSpot;
      spots_.push_back({next.spot, radius * radius});
    }
    if (is_used_up(next) || !resolve(pose, next)) {
      candidates_.pop_back();
    } else {
      std::push_heap(candidates_.begin(), candidates_.end(), is_later);
    }
  }
  const auto is_costly = [this](const auto& n) { return n.distance < costly_; };
  const auto taken =
      spare_.begin() + static_cast<std::ptrdiff_t>(std::min(most - found.size(), spare_.size()));
  found.insert(found.end(), spare_.begin(), taken);
  std::stable_sort(found.begin(), found.end(),
                   [](const NearStatic& l, const NearStatic& r) { return l.distance < r.distance; });
  left_out += static_cast<std::size_t>(std::count_if(taken, spare_.end(), is_costly));
  for (const Candidate& c : candidates_) left_out += is_costly(c) && !is_used_up(c);
  return left_out;
}

// Groups come before obstacles as near as they are: one of theirs may have to come first.
bool NearestStatics::is_before(const Candidate& l, const Candidate& r) const {
  if (l.distance != r.distance) return l.distance < r.distance;
  if (l.index == kGroup || r.index == kGroup) return l.index == kGroup && r.index != kGroup;
  const std::vector<Capsule>& capsules = field_.statics.capsules();
  return order_of(capsules[l.index], field_.position) < order_of(capsules[r.index], field_.position);
}

bool NearestStatics::is_known(const Vector2& position) const {
  return std::any_of(spots_.begin(), spots_.end(), [&](const Spot& spot) {
    return (spot.position - position).squaredNorm() < spot.squared_radius;
  });
}

std::size_t NearestStatics::side_of(const Pose2& pose, const Candidate& candidate) const {
  const Vector2 ahead = direction(pose.theta);
  const CapsuleIndex::Group& group = around_[candidate.group];
  const bool is_group = candidate.index == kGroup;
  const Vector2 position = is_group ? Vector2(0.5 * (group.low + group.high)) : candidate.spot;
  const Vector2 half = is_group ? Vector2(0.5 * (group.high - group.low)) : Vector2(0.0, 0.0);
  const double aside = cross(ahead, position - pose.position());
  const double extent = std::abs(ahead.x()) * half.y() + std::abs(ahead.y()) * half.x();
  return aside > extent ? 1 : aside < -extent ? 2 : 0;
}

void NearestStatics::collect(const Pose2& pose) {
  candidates_.clear();
  for (std::uint32_t g = 0; g < around_.size(); ++g) {
    const CapsuleIndex::Group& group = around_[g];
    const double squared = group.squared_distance(pose.position());
    const double radius = group.radius + field_.footprint.radius;
    if (squared > (reach_ + radius) * (reach_ + radius)) continue;
    Candidate candidate{std::sqrt(squared) - radius, g, kGroup, {0.0, 0.0}};
    if (group.last - group.first > 1 || resolve(pose, candidate)) candidates_.push_back(candidate);
  }
}

bool NearestStatics::resolve(const Pose2& pose, Candidate& candidate) const {
  const Vector2 position = pose.position();
  const Footprint& footprint = field_.footprint;
  Candidate best{std::numeric_limits<double>::infinity(), candidate.group, kGroup, {0.0, 0.0}};
  for (const std::uint32_t i : field_.statics.members(around_[candidate.group])) {
    const Capsule& capsule = field_.statics.capsules()[i];
    const Vector2 spot = nearest_point(Segment{capsule.a, capsule.b}, position);
    const double squared = (position - spot).squaredNorm();
    const double radius = capsule.radius + footprint.radius;
    if (squared > (reach_ + radius) * (reach_ + radius)) continue;
    Candidate one{std::sqrt(squared) - radius, candidate.group, i, spot};
    if (one.distance > best.distance) continue;
    if (footprint.is_polygon()) one.distance = gap_to(footprint, pose, capsule);
    if ((best.index == kGroup || is_before(one, best)) && !is_known(spot)) best = one;
  }
  candidate = best;
  return best.index != kGroup;
}

bool NearestStatics::is_used_up(const Candidate& candidate) const {
  const CapsuleIndex::Group& group = around_[candidate.group];
  if (group.last - group.first == 1) return candidate.index == kGroup || is_known(candidate.spot);
  return std::any_of(spots_.begin(), spots_.end(), [&](const Spot& spot) {
    const Vector2 farthest =
        (spot.position - group.low).cwiseAbs().cwiseMax((spot.position - group.high).cwiseAbs());
    return farthest.squaredNorm() < spot.squared_radius;
  });
}

}  // namespace bw::teb
