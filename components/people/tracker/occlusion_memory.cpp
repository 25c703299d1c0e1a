#include "components/people/tracker/occlusion_memory.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/people/tracker/visibility.hpp"

namespace bw::people {
namespace {

constexpr double kPosition = 0.08;  // [m] error of where they were, per axis
constexpr double kPace = 0.07;      // [m] less than a wall is thick
constexpr double kNear = 0.75;      // [m]
constexpr double kBody = 0.2;       // [m] the middle of somebody comes no nearer to a wall

Vector2 rotated(const Vector2& v, double angle) {
  const Vector2 a = direction(angle);
  return {a.x() * v.x() - a.y() * v.y(), a.y() * v.x() + a.x() * v.y()};
}

/// Whether a wall stands on the way, or so near beyond it that nobody gets there.
bool is_barred(const Vector2& from, const Vector2& step, const DetectionSet& sweep, const SeenWalls& walls,
               double margin) {
  const double distance = step.norm();
  if (!(distance > 0.0)) return false;
  for (double s = kPace; s < distance + kBody + kPace; s += kPace) {
    const Vector2 ahead = from + s / distance * step;
    if (walls.contains(ahead) && !seen_empty(sweep, ahead, margin)) return true;
  }
  return false;
}

}  // namespace

OcclusionMemory::OcclusionMemory(const Vector2& position, const Vector2& velocity, Random& random,
                                 const HiddenOptions& options)
    : guesses_(static_cast<std::size_t>(options.kGuesses)) {
  for (Guess& guess : guesses_) {
    guess.position = position + kPosition * Vector2(random.normal(), random.normal());
    guess.velocity = velocity + options.kSpeedError * Vector2(random.normal(), random.normal());
    guess.weight = 1.0 / static_cast<double>(guesses_.size());
  }
}

bool OcclusionMemory::pass(double dt, double looked, const DetectionSet& sweep, const SeenWalls& walls,
                           Random& random, const HiddenOptions& options) {
  waited_ += dt;
  looked_ += looked;
  if (waited_ < kEvery) return false;
  walk(sweep, walls, random, options);
  waited_ = looked_ = 0.0;
  return true;
}

void OcclusionMemory::walk(const DetectionSet& sweep, const SeenWalls& walls, Random& random,
                           const HiddenOptions& options) {
  const double dt = waited_;
  const double wander = options.kWander * std::sqrt(dt);
  const double anew = 1.0 - std::exp(-dt / options.kKeepsCourse);
  const double missed = std::exp(-looked_ / options.kOverlooked);
  double sum = 0.0;
  for (Guess& guess : guesses_) {
    const bool elsewhere = random.uniform() < anew;
    guess.velocity = rotated(guess.velocity, elsewhere ? random.uniform(-std::numbers::pi, std::numbers::pi)
                                                       : wander * random.normal());
    const Vector2 step = dt * guess.velocity;
    if (is_barred(guess.position, step, sweep, walls, options.kMargin)) {
      const double side = random.uniform() < 0.5 ? 1.0 : -1.0;
      guess.velocity = rotated(guess.velocity, side * random.uniform(0.3, 1.0) * std::numbers::pi);
    } else {
      guess.position += step;
    }
    if (seen_empty(sweep, guess.position, options.kMargin)) guess.weight *= missed;
    sum += guess.weight;
  }
  existence_ *= sum;
  double squares = 0.0;
  for (Guess& guess : guesses_) {
    guess.weight /= sum;
    squares += guess.weight * guess.weight;
  }
  if (squares * static_cast<double>(guesses_.size()) > 2.0) draw_anew(random);
}

/// Systematic resampling: as many guesses, all of the same weight.
void OcclusionMemory::draw_anew(Random& random) {
  const std::vector<Guess> old = guesses_;
  const double share = 1.0 / static_cast<double>(old.size());
  double pointer = random.uniform() * share;
  double passed = 0.0;
  std::size_t next = 0;
  for (const Guess& guess : old) {
    passed += guess.weight;
    for (; pointer < passed && next < guesses_.size(); pointer += share)
      guesses_[next++] = {guess.position, guess.velocity, share};
  }
  while (next < guesses_.size()) guesses_[next++] = {old.back().position, old.back().velocity, share};
}

OcclusionMemory::Moments OcclusionMemory::moments() const {
  Moments m{Eigen::Vector4d::Zero(), Eigen::Matrix4d::Zero()};
  Eigen::Vector4d x;
  for (const Guess& guess : guesses_) {
    x << guess.position, guess.velocity;
    m.mean += guess.weight * x;
    m.covariance += guess.weight * x * x.transpose();
  }
  m.covariance -= m.mean * m.mean.transpose();
  m.covariance.diagonal().array() += 1e-4;  // guesses that are all the same know no better than this
  return m;
}

double OcclusionMemory::chance_near(const Vector2& position) const {
  double sum = 0.0;
  for (const Guess& guess : guesses_)
    if ((guess.position - position).squaredNorm() < kNear * kNear) sum += guess.weight;
  return existence_ * sum;
}

double OcclusionMemory::density(const Vector2& position, std::optional<Vector2> velocity, double ago,
                                const HiddenOptions& options) const {
  const double p = options.position_kernel * options.position_kernel;
  const double v = options.kVelocityKernel * options.kVelocityKernel;
  double sum = 0.0;
  for (const Guess& guess : guesses_) {
    const double square = (position - guess.position + (ago - waited_) * guess.velocity).squaredNorm() / p +
                          (velocity.value_or(guess.velocity) - guess.velocity).squaredNorm() / v;
    sum += guess.weight * std::exp(-square / 2.0);
  }
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  return sum / (kTwoPi * kTwoPi * p * v);
}

}  // namespace bw::people
