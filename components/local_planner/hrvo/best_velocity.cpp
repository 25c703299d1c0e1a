#include "components/local_planner/hrvo/best_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/hrvo/cones.hpp"

namespace bw::hrvo {
namespace {

constexpr double kInside = 1e-7;     // [m/s] from the legs: so near is outside
constexpr double kTie = 1e-9;        // [m/s] distances to the wish that are one
constexpr double kParallel = 1e-12;  // sine below which two legs do not meet
constexpr double kTooFast = 1e-9;    // [m/s] above v_max that is rounding
constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

struct Leg {
  Vector2 from;
  Vector2 along;
  std::size_t cone;
};

// A velocity on the border of the cones that made it: these are not asked again, rounding would answer.
struct Choice {
  Vector2 velocity;
  std::size_t made_by = kNobody;
  std::size_t and_by = kNobody;
  double distance = 0.0;  // to the wish
};

class Search {
 public:
  Search(const std::vector<VelocityCone>& cones, const Vector2& preferred, double v_max,
         const std::optional<PreviousVelocity>& favour)
      : cones_(cones), preferred_(preferred), v_max_(v_max), previous_(favour) {
    for (std::size_t i = 0; i < cones.size(); ++i) {
      legs_.push_back({cones[i].apex, cones[i].right, i});
      legs_.push_back({cones[i].apex, cones[i].left, i});
    }
  }

  BestVelocity run() {
    add({preferred_});
    for (const Leg& leg : legs_) add_points_of(leg);
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      for (std::size_t j = i + 1; j < legs_.size(); ++j) add_crossing(legs_[i], legs_[j]);
    }
    std::stable_sort(choices_.begin(), choices_.end(),
                     [](const Choice& a, const Choice& b) { return a.distance < b.distance; });
    const Choice* best = nearest_free();
    return best ? BestVelocity{best->velocity, true} : BestVelocity{last_violated().velocity, false};
  }

 private:
  void add(Choice choice) {
    const double speed = choice.velocity.norm();
    if (!(speed <= v_max_ + kTooFast)) return;
    if (speed > v_max_) choice.velocity *= v_max_ / speed;
    choice.distance = (choice.velocity - preferred_).norm();
    choices_.push_back(choice);
  }

  void add_points_of(const Leg& leg) {
    const double to_foot = (preferred_ - leg.from).dot(leg.along);
    add({to_foot > 0.0 ? Vector2(leg.from + to_foot * leg.along) : leg.from, leg.cone});
    // Where it leaves and enters the circle of v_max.
    const Vector2 normal(-leg.along.y(), leg.along.x());
    const double offset = leg.from.dot(normal);
    const double half_chord2 = v_max_ * v_max_ - offset * offset;
    if (half_chord2 < 0.0) return;
    const double start = leg.from.dot(leg.along);
    for (const double end : {-std::sqrt(half_chord2), std::sqrt(half_chord2)}) {
      if (end >= start) add({offset * normal + end * leg.along, leg.cone});
    }
  }

  void add_crossing(const Leg& a, const Leg& b) {
    const double sine = cross(a.along, b.along);
    if (a.cone == b.cone || std::abs(sine) < kParallel) return;
    const Vector2 apart = b.from - a.from;
    const double on_a = cross(apart, b.along) / sine;
    const double on_b = cross(apart, a.along) / sine;
    if (on_a >= 0.0 && on_b >= 0.0) add({a.from + on_a * a.along, a.cone, b.cone});
  }

  std::size_t first_violated(const Choice& choice) const {
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      if (i == choice.made_by || i == choice.and_by) continue;
      if (is_inside(cones_[i], choice.velocity, kInside)) return i;
    }
    return kNobody;
  }

  // Nearest to the favoured velocity, then further right.
  bool preferable(const Choice& a, const Choice& b) const {
    const double nearer =
        previous_ ? (b.velocity - previous_->velocity).norm() - (a.velocity - previous_->velocity).norm()
                  : 0.0;
    if (std::abs(nearer) > kTie) return nearer > 0.0;
    return cross(preferred_, a.velocity) < cross(preferred_, b.velocity) - kTie;
  }

  const Choice* nearest_free() const {
    const double allowance = kTie + (previous_ ? previous_->allowance : 0.0);
    const Choice* best = nullptr;
    double nearest = 0.0;
    for (const Choice& choice : choices_) {
      if (best && choice.distance > nearest + allowance) break;
      if (best && !preferable(choice, *best)) continue;
      if (first_violated(choice) != kNobody) continue;
      if (!best) nearest = choice.distance;
      best = &choice;
    }
    return best;
  }

  const Choice& last_violated() const {
    const auto sooner = [&](const Choice& a, const Choice& b) {
      return first_violated(a) < first_violated(b);
    };
    return *std::max_element(choices_.begin(), choices_.end(), sooner);
  }

  const std::vector<VelocityCone>& cones_;
  Vector2 preferred_;
  double v_max_;
  const std::optional<PreviousVelocity>& previous_;
  std::vector<Leg> legs_;
  std::vector<Choice> choices_;
};

}  // namespace

BestVelocity best_velocity(const std::vector<VelocityCone>& cones, const Vector2& preferred, double v_max,
                           const std::optional<PreviousVelocity>& favour) {
  const double speed = preferred.norm();
  const Vector2 wish = speed > v_max ? Vector2(preferred * (v_max / speed)) : preferred;
  return Search(cones, wish, v_max, favour).run();
}

}  // namespace bw::hrvo
