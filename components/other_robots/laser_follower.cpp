#include "components/other_robots/laser_follower.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace bw {
namespace {

constexpr double kWidestGate =
    0.35;  // [m] from the rim: half a metre a second wrong for two sweeps, and the word's error
constexpr double kNarrowestGate = 0.1;  // [m]
constexpr int kSteps = 8;
constexpr std::size_t kFewestPoints = 4;
constexpr double kRoundness = 0.04;  // [m] rms from the rim
constexpr double kAlpha = 0.6;
constexpr double kBeta = 0.25;
constexpr Duration kPatience = Duration::milliseconds(1'000);  // somebody passes in between
constexpr double kSure = 0.1;                                  // [m]
constexpr double kLessSure = 0.3;                              // [m/s] while unseen
constexpr Duration kLongestStep = Duration::milliseconds(500);

struct Rim {
  std::size_t points = 0;
  double squares = 0.0;  ///< [m^2]
  Vector2 step{0.0, 0.0};
};

/// One step of Gauss-Newton, held to the position by a weak spring: along the rim a short arc says nothing.
Rim look(const Vector2& centre, const std::vector<Vector2>& points, double radius, double gate) {
  constexpr double kSpring = 0.5;
  Eigen::Matrix2d H = kSpring * Eigen::Matrix2d::Identity();
  Vector2 g(0.0, 0.0);
  Rim rim;
  for (const Vector2& point : points) {
    const Vector2 away = point - centre;
    const double distance = away.norm();
    const double error = distance - radius;
    if (!(std::abs(error) <= gate) || distance < 1e-6) continue;
    const Vector2 normal = away / distance;
    H += normal * normal.transpose();
    g += normal * error;
    rim.squares += error * error;
    ++rim.points;
  }
  rim.step = H.ldlt().solve(g);
  return rim;
}

}  // namespace

std::optional<Vector2> disc_near(const Vector2& guess, const std::vector<Vector2>& points, double radius) {
  Vector2 centre = guess;
  for (int i = 0; i < kSteps; ++i) {
    const double share = static_cast<double>(i) / (kSteps - 1);
    centre += look(centre, points, radius, kWidestGate + share * (kNarrowestGate - kWidestGate)).step;
  }
  const Rim rim = look(centre, points, radius, kNarrowestGate);
  if (rim.points < kFewestPoints) return std::nullopt;
  if (std::sqrt(rim.squares / static_cast<double>(rim.points)) > kRoundness) return std::nullopt;
  return centre;
}

std::optional<FollowedDisc> LaserFollower::follow(const std::vector<Vector2>& points, double radius,
                                                  Time time) {
  if (points.empty()) forget();  // the laser tells nothing at all
  if (!disc_) return std::nullopt;
  const Duration step = time - disc_->time;
  if (step < Duration{} || step > kLongestStep) {
    forget();
    return std::nullopt;
  }
  const double dt = step.to_seconds();
  FollowedDisc disc{
      .time = time, .position = disc_->position + disc_->velocity * dt, .velocity = disc_->velocity};
  if (const auto seen = disc_near(disc.position, points, radius)) {
    const Vector2 off = *seen - disc.position;
    disc.position += kAlpha * off;
    if (dt > 0.0) disc.velocity += (kBeta / dt) * off;
    seen_ = time;
  } else if (time - seen_ > kPatience) {
    forget();
    return std::nullopt;
  }
  disc.deviation = kSure + kLessSure * (time - seen_).to_seconds();
  disc_ = disc;
  return disc_;
}

}  // namespace bw
