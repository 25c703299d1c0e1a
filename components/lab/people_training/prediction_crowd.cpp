#include "components/lab/people_training/prediction_crowd.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/model/random.hpp"
#include "components/model/social_force.hpp"

namespace bw::people {
namespace {

constexpr double kStep = 0.05;      // [s]
constexpr double kMingle = 5.0;     // [s]
constexpr double kHeadroom = 1.3;   // of the wanted speed
constexpr double kFar = 6.0;        // [m] nobody is pushed from
constexpr double kForgotten = 2.0;  // [s] time constant of the wander
constexpr double kStandingWander = 0.35;
constexpr double kGoesOn = 0.15;  // [1/s]
constexpr double kBeside = 0.75;  // [m] in a group

struct Walker {
  Vector2 position;
  Vector2 velocity{0.0, 0.0};
  Vector2 course;            // unit
  double speed = 0.0;        // wanted
  double restless = 0.0;     // [m/s/sqrt(s)]
  Vector2 wander{0.0, 0.0};  // beside the wanted velocity
  int group = 0;
  bool stands = false;
  SocialForceOptions forces;
};

class Crowd {
 public:
  explicit Crowd(std::uint64_t seed) : random_(seed) {
    side_ = random_.uniform(10.0, 18.0);
    const double density = log_uniform(0.03, 0.35);
    const int count = std::max(2, static_cast<int>(std::lround(density * side_ * side_)));
    is_street_ = random_.uniform() < 0.5;
    stops_ = random_.uniform() < 0.5 ? random_.uniform(0.0, 0.06) : 0.0;
    turns_ = random_.uniform() < 0.5 ? random_.uniform(0.0, 0.1) : 0.0;
    const double standing = random_.uniform() < 0.5 ? random_.uniform(0.0, 0.5) : 0.0;
    const double usual = random_.uniform(0.8, 1.5);
    const double restless = random_.uniform(0.0, 0.6);
    for (int group = 1; static_cast<int>(walkers_.size()) < count; ++group)
      add_group(group, standing, usual, restless);
  }

  void step() {
    std::vector<Vector2> accelerations;
    accelerations.reserve(walkers_.size());
    for (const Walker& walker : walkers_) accelerations.push_back(acceleration(walker));
    for (std::size_t i = 0; i < walkers_.size(); ++i) advance(walkers_[i], accelerations[i]);
  }

  std::vector<Vector2> positions() const {
    std::vector<Vector2> positions;
    for (const Walker& walker : walkers_) positions.push_back(walker.position);
    return positions;
  }

 private:
  double log_uniform(double low, double high) {
    return std::exp(random_.uniform(std::log(low), std::log(high)));
  }

  Vector2 draw_course() {
    if (is_street_) return {random_.uniform() < 0.5 ? 1.0 : -1.0, 0.0};
    const double angle = random_.uniform(-std::numbers::pi, std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }

  void add_group(int group, double standing, double usual, double restless) {
    const int members = random_.uniform() < 0.35 ? 2 + static_cast<int>(random_.bits() % 2) : 1;
    const double x = random_.uniform(0.0, side_);
    const double y = random_.uniform(0.0, side_);
    Walker walker{.position = {x, y}, .course = draw_course()};
    walker.stands = random_.uniform() < standing;
    walker.speed = std::max(0.3, random_.normal(usual, 0.25));
    walker.restless = random_.uniform(0.3, 1.7) * restless;
    walker.group = members > 1 ? group : 0;
    walker.forces.social_factor *= log_uniform(0.05, 1.0);
    if (!walker.stands) walker.velocity = walker.speed * walker.course;
    const Vector2 beside = kBeside * Vector2(-walker.course.y(), walker.course.x());
    for (int k = 0; k < members; ++k, walker.position += beside) walkers_.push_back(walker);
  }

  /// From one to the other, where the square goes on in itself.
  Vector2 between(const Vector2& from, const Vector2& to) const {
    const Vector2 way = to - from;
    return way - side_ * Vector2(std::round(way.x() / side_), std::round(way.y() / side_));
  }

  Vector2 acceleration(const Walker& walker) const {
    Vector2 wanted = walker.wander;
    if (!walker.stands) wanted += walker.speed * walker.course;
    Vector2 sum = desired_force(walker.forces, wanted, walker.velocity);
    Vector2 centre(0.0, 0.0);
    int members = 0;
    for (const Walker& other : walkers_) {
      const Vector2 way = between(walker.position, other.position);
      const bool is_of_mine = walker.group != 0 && other.group == walker.group;
      if (is_of_mine) {
        centre += way;
        ++members;
      }
      if (&other == &walker || is_of_mine || way.squaredNorm() > kFar * kFar) continue;
      sum += social_force(walker.forces, way, walker.velocity - other.velocity);
    }
    if (members > 1) sum += group_force(walker.forces, centre / members, members);
    return sum;
  }

  void advance(Walker& walker, const Vector2& acceleration) {
    const double restless = walker.restless * (walker.stands ? kStandingWander : 1.0);
    const double x = random_.normal();
    const double y = random_.normal();
    walker.wander += restless * std::sqrt(kStep) * Vector2(x, y) - kStep / kForgotten * walker.wander;
    walker.velocity += kStep * acceleration;
    const double speed = walker.velocity.norm();
    if (speed > kHeadroom * walker.speed) walker.velocity *= kHeadroom * walker.speed / speed;
    walker.position += kStep * walker.velocity;
    const double chance = random_.uniform();
    if (walker.stands ? chance < kGoesOn * kStep && stops_ > 0.0 : chance < stops_ * kStep)
      walker.stands = !walker.stands;
    if (random_.uniform() < turns_ * kStep) walker.course = draw_course();
  }

  Random random_;
  double side_ = 0.0;
  bool is_street_ = false;
  double stops_ = 0.0;  // [1/s]
  double turns_ = 0.0;  // [1/s]
  std::vector<Walker> walkers_;
};

}  // namespace

std::vector<std::vector<Vector2>> draw_crowd(std::uint64_t seed, double seconds) {
  Crowd crowd(seed);
  for (double t = 0.0; t < kMingle; t += kStep) crowd.step();
  std::vector<std::vector<Vector2>> positions;
  const auto steps = static_cast<std::size_t>(std::lround(seconds / kCrowdStep));
  while (positions.size() < steps) {
    positions.push_back(crowd.positions());
    crowd.step();
    crowd.step();
  }
  return positions;
}

}  // namespace bw::people
