#include "components/lab/bench/buildings/route_follower.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bw::buildings {
namespace {

constexpr double kSpacing = 0.02;    // [m]
constexpr std::size_t kWindow = 15;  // points of the path ahead that may be the nearest
constexpr double kLookAhead = 0.25;  // [m]
constexpr double kTurnBack = 1.75;   // corners sharper than 100 degrees are not rounded [rad]
constexpr double kBraking = 0.5;     // [m/s^2]

double heading_between(const Vector2& from, const Vector2& to) {
  const Vector2 way = to - from;
  return std::atan2(way.y(), way.x());
}

}  // namespace

RouteFollower::RouteFollower(const std::vector<Vector2>& route, const FollowerOptions& options)
    : options_(options) {
  if (route.size() < 2) throw std::invalid_argument("a route of fewer than two corners");
  path_.push_back(route.front());
  for (std::size_t i = 1; i + 1 < route.size(); ++i) round_corner(route[i - 1], route[i], route[i + 1]);
  add_line(route.back());
  turnbacks_.push_back(path_.size() - 1);
}

void RouteFollower::add_line(const Vector2& to) {
  const Vector2 from = path_.back();
  const int parts = static_cast<int>(std::ceil((to - from).norm() / kSpacing));
  for (int k = 1; k <= parts; ++k) path_.push_back(from + (to - from) * (static_cast<double>(k) / parts));
}

/// By an arc that the robot can drive at full speed, or a narrower one where the route's parts are short.
void RouteFollower::round_corner(const Vector2& before, const Vector2& corner, const Vector2& after) {
  const double in = heading_between(before, corner);
  const double turn = wrap_angle(heading_between(corner, after) - in);
  if (std::abs(turn) > kTurnBack) {
    add_line(corner);
    turnbacks_.push_back(path_.size() - 1);
    return;
  }
  const double tangent = std::tan(std::abs(turn) / 2.0);
  const double room = 0.5 * std::min((corner - before).norm(), (after - corner).norm());
  const double cut = std::min(options_.speed / options_.turn_rate * tangent, room);
  const Vector2 start = corner - cut * direction(in);
  add_line(start);
  if (cut < kSpacing) return add_line(corner);
  const double side = turn > 0.0 ? 1.0 : -1.0;
  const double radius = cut / tangent;
  const Vector2 center = start + side * radius * Vector2(-std::sin(in), std::cos(in));
  const int parts = static_cast<int>(std::ceil(std::abs(turn) * radius / kSpacing));
  for (int k = 1; k <= parts; ++k) {
    const double angle = in + turn * k / parts;
    path_.push_back(center - side * radius * Vector2(-std::sin(angle), std::cos(angle)));
  }
}

double RouteFollower::heading_of_piece() const {
  const std::size_t ahead = std::min(nearest_ + 1, path_.size() - 1);
  return heading_between(path_[ahead - 1], path_[ahead]);
}

Pose2 RouteFollower::start() const { return {path_[0].x(), path_[0].y(), heading_of_piece()}; }

/// Beyond the end of a piece it goes straight on.
Vector2 RouteFollower::target() const {
  const std::size_t end = turnbacks_[piece_];
  std::size_t i = nearest_;
  double ahead = 0.0;
  for (; i < end && ahead < kLookAhead; ++i) ahead += (path_[i + 1] - path_[i]).norm();
  if (ahead >= kLookAhead) return path_[i];
  return path_[end] + (kLookAhead - ahead) * (path_[end] - path_[end - 1]).normalized();
}

std::optional<Twist2> RouteFollower::next(const Pose2& X_map_base) {
  if (turns_in_place_) {
    const double error = wrap_angle(heading_of_piece() - X_map_base.theta);
    if (std::abs(error) > 0.01)
      return Twist2{0.0, std::clamp(3.0 * error, -options_.turn_rate, options_.turn_rate)};
    turns_in_place_ = false;
  }
  const std::size_t end = turnbacks_[piece_];
  const auto distance = [&](std::size_t i) { return (path_[i] - X_map_base.position()).norm(); };
  // Across a corner, too, which is cut a little: from point to point the distance may grow there.
  for (std::size_t i = nearest_ + 1; i <= std::min(end, nearest_ + kWindow); ++i) {
    if (distance(i) <= distance(nearest_)) nearest_ = i;
  }
  if (nearest_ == end) {
    if (++piece_ == turnbacks_.size()) return std::nullopt;
    turns_in_place_ = true;
    return Twist2{};
  }
  const Vector2 ahead = inverse(X_map_base) * target();
  const double curvature = 2.0 * ahead.y() / ahead.squaredNorm();
  const double remaining = static_cast<double>(end - nearest_) * kSpacing;
  const double speed = std::min({options_.speed, options_.turn_rate / std::max(std::abs(curvature), 1e-9),
                                 std::sqrt(2.0 * kBraking * remaining)});
  return Twist2{speed, curvature * speed};
}

}  // namespace bw::buildings
