#include "components/local_planner/teb/clearance_cost.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

#include "components/model/mover_weight.hpp"
#include "components/model/nearest_point.hpp"

namespace bw::teb {
namespace {

constexpr double kAssociationMargin =
    0.4;  // [m] that a pose may move in one solve and still know its obstacles
constexpr int kMostSamplesPerSegment = 4;
constexpr double kSameSpot = 0.05;   // [m]
constexpr std::size_t kStretch = 8;  // poses that share one selection of static obstacles

struct Near {
  double distance;
  Vector2 spot;  // the point of the obstacle's axis that is nearest
  ClearanceTerm term;
};

// The nearest terms; equal distances keep their order, so that equal input gives equal output. Static ones
// that touch the same spot of a surface (the corner of two walls, neighbouring points) count once: together
// they would outweigh what stands on the other side of a gap.
void keep_nearest(const std::vector<Near>& near, std::size_t count, std::vector<const Near*>& order,
                  std::vector<ClearanceTerm>& terms) {
  order.clear();
  for (const Near& n : near) order.push_back(&n);
  std::sort(order.begin(), order.end(), [](const Near* l, const Near* r) {
    return l->distance < r->distance || (l->distance == r->distance && l < r);
  });
  std::size_t statics = 0;   // of `order`, moved to its front: those kept
  std::size_t possible = 0;  // people, in places of their own
  std::size_t others = 0;
  for (const Near* n : order) {
    std::size_t& kept_of_kind = n->term.presence < 1.0 ? possible : others;
    if (kept_of_kind == count) continue;
    if (!n->term.moving) {
      const auto kept = order.begin() + static_cast<std::ptrdiff_t>(statics);
      const bool known = std::any_of(order.begin(), kept, [&](const Near* other) {
        return other->term.fraction == n->term.fraction &&
               (other->spot - n->spot).squaredNorm() < kSameSpot * kSameSpot;
      });
      if (known) continue;
      order[statics++] = n;
    }
    terms.push_back(n->term);
    ++kept_of_kind;
  }
}

Capsule mover_at(const Mover& mover, double time) {
  const Vector2 p = mover.position_at(time);
  return {p, p, mover.radius};
}

// As time_indexed sees them, if they stood at their present and, if asked, at one future place.
void add_standing(const Mover& mover, const PredictionOptions& prediction, std::vector<Mover>& movers) {
  const auto add = [&](const Vector2& position) {
    movers.push_back(mover);
    movers.back().position = position;
    movers.back().velocity = {0.0, 0.0};
    movers.back().predictions.clear();
  };
  add(mover.position);
  if (prediction.prediction == Prediction::doubled) add(mover.position_at(prediction.prediction_time));
}

Vector2 nearest_spot(const Capsule& capsule, const Vector2& point) {
  return nearest_point(Segment{capsule.a, capsule.b}, point);
}

double squared_distance(const Capsule& capsule, const Vector2& point) {
  return (point - nearest_spot(capsule, point)).squaredNorm();
}

bool in_reach(const Capsule& capsule, const Vector2& point, double reach, double& distance) {
  const double squared = squared_distance(capsule, point);
  const double limit = reach + capsule.radius;
  if (squared > limit * limit) return false;
  distance = std::sqrt(squared) - capsule.radius;
  return true;
}

// Those statics that any pose of [first, first + kStretch] or the way between can be in reach of.
void select_around(const Band& band, std::size_t first, double reach, const std::vector<Capsule>& statics,
                   std::vector<const Capsule*>& selected) {
  const std::size_t last = std::min(first + kStretch, band.size() - 1);
  const Vector2 centre = band.poses[(first + last) / 2].position();
  double extent = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    extent = std::max(extent, (band.poses[k].position() - centre).squaredNorm());
  }
  extent = std::sqrt(extent) + reach;
  selected.clear();
  for (const Capsule& c : statics) {
    const double limit = extent + c.radius;
    if (squared_distance(c, centre) <= limit * limit) selected.push_back(&c);
  }
}

// The first `count` by `key`, which tells apart all that differ: sums over them do not hang on the order
// given.
template <class T, class Key>
std::vector<T> nearest_first(const std::vector<T>& list, std::size_t count, Key&& key) {
  std::vector<std::pair<std::invoke_result_t<Key, const T&>, std::size_t>> order;
  order.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) order.emplace_back(key(list[i]), i);
  std::sort(order.begin(), order.end());
  if (order.size() > count) order.resize(count);
  std::vector<T> nearest;
  nearest.reserve(order.size());
  for (const auto& [unused, i] : order) nearest.push_back(list[i]);
  return nearest;
}

}  // namespace

double Uncertainty::at(const Mover& mover, double time) const {
  if (factor <= 0.0) return 0.0;
  const double sigma = mover.predictions.empty() ? growth * time : mover.sigma_at(time);
  return std::min(most, factor * sigma);
}

ObstacleField nearby_obstacles(const StaticObstacles& statics, const std::vector<Mover>& movers,
                               const Vector2& position, double robot_radius, std::size_t max_count,
                               const PredictionOptions& prediction) {
  const Uncertainty uncertainty{prediction.uncertainty_factor, prediction.uncertainty_growth,
                                prediction.max_uncertainty};
  const bool time_indexed = prediction.prediction == Prediction::time_indexed;
  std::vector<Mover> moving;
  std::vector<Capsule> capsules;
  capsules.reserve(statics.size() + (time_indexed ? 0 : 2 * movers.size()));
  for (const Mover& m : movers) {
    if (presence(m) == 0.0) continue;
    if (time_indexed) {
      moving.push_back(m);
    } else if (!is_confirmed(m)) {
      add_standing(m, prediction, moving);
    } else {
      capsules.push_back({m.position, m.position, m.radius + robot_radius});
      if (prediction.prediction != Prediction::doubled) continue;
      capsules.push_back(mover_at(m, prediction.prediction_time));
      capsules.back().radius += robot_radius + uncertainty.at(m, prediction.prediction_time);
    }
  }
  for (const Vector2& p : statics.points) capsules.push_back({p, p, robot_radius});
  for (const Disc& d : statics.discs) capsules.push_back({d.center, d.center, d.radius + robot_radius});
  for (const Segment& s : statics.segments) capsules.push_back({s.a, s.b, robot_radius});

  ObstacleField field;
  field.uncertainty = uncertainty;
  if (!moving.empty()) {
    field.movers = nearest_first(moving, max_count, [&](const Mover& m) {
      return std::tuple((m.position - position).norm() - m.radius, m.position.x(), m.position.y(),
                        m.velocity.x(), m.velocity.y(), m.radius, m.confidence, m.id);
    });
    for (Mover& m : field.movers) m.radius = present_radius(m) + robot_radius;
  }
  const auto confirmed = static_cast<std::size_t>(std::count_if(
      field.movers.begin(), field.movers.end(), [](const Mover& m) { return is_confirmed(m); }));
  field.statics = nearest_first(capsules, max_count - confirmed, [&](const Capsule& c) {
    return std::tuple(std::sqrt(squared_distance(c, position)) - c.radius, c.a.x(), c.a.y(), c.b.x(), c.b.y(),
                      c.radius);
  });
  return field;
}

Clearance clearance_to(const Capsule& capsule, const Vector2& point) {
  const Vector2 d = capsule.b - capsule.a;
  const double length = d.squaredNorm();
  const double s = length == 0.0 ? 0.0 : std::clamp((point - capsule.a).dot(d) / length, 0.0, 1.0);
  const Vector2 away = point - capsule.a - s * d;
  const double distance = away.norm();
  return {distance - capsule.radius, distance > 1e-9 ? Vector2(away / distance) : Vector2(0.0, 0.0)};
}

ClearanceModel::ClearanceModel(const BandOptions& options, double growth)
    : fixed{options.weights.obstacle * growth, options.weights.inflation, options.inflation_dist},
      moving{options.weights.dynamic_obstacle * growth, options.weights.dynamic_inflation,
             options.dynamic_obstacle_inflation_dist},
      possible_inflation(std::min(options.weights.possible_inflation, options.weights.dynamic_inflation)),
      min_dist(options.min_obstacle_dist + options.penalty_epsilon) {}

double evaluate_clearance(const ClearanceModel& model, const ClearanceTerm& term, const Vector2& point,
                          Vector2* gradient) {
  const ClearanceModel::Kind& kind = term.moving ? model.moving : model.fixed;
  const Clearance clearance = clearance_to(term.capsule, point);
  const double close = std::max(0.0, model.min_dist - clearance.distance);
  // Of possible people only the inflation counts: what is to be kept from is among the static obstacles.
  const double s = term.presence;
  const double obstacle = s < 1.0 ? 0.0 : kind.obstacle;
  const double inflation = s < 1.0 ? s * model.possible_inflation : kind.inflation;
  const double inflated = std::max(0.0, s * (kind.inflation_dist + term.unsure) - clearance.distance);
  const double cost = obstacle * close * close + inflation * inflated * inflated;
  if (cost <= 0.0) {
    if (gradient != nullptr) gradient->setZero();
    return 0.0;
  }
  const double residual = std::sqrt(cost);
  if (gradient != nullptr) {
    *gradient = clearance.gradient * (-(obstacle * close + inflation * inflated) / residual);
  }
  return residual;
}

std::vector<PoseTerms> associate(const Band& band, const ObstacleField& field, const BandOptions& options) {
  const auto count = static_cast<std::size_t>(options.max_obstacles_per_pose);
  const double near = options.min_obstacle_dist + options.penalty_epsilon;
  const double static_reach = std::max(near, options.inflation_dist) + kAssociationMargin;
  const double moving_reach = std::max(near, options.dynamic_obstacle_inflation_dist) + kAssociationMargin;

  std::vector<PoseTerms> result(band.size());
  std::vector<Near> at_pose;
  std::vector<Near> along;
  std::vector<const Near*> order;
  std::vector<const Capsule*> statics;
  double time = 0.0;
  for (std::size_t k = 0; k + 1 < band.size(); time += band.poses[k++].dt) {
    if (k % kStretch == 0) select_around(band, k, static_reach, field.statics, statics);
    const Vector2 p = band.poses[k].position();
    const Vector2 step = band.poses[k + 1].position() - p;
    const double dt = band.poses[k].dt;
    at_pose.clear();
    along.clear();
    const auto add = [&](const Capsule& now, bool moving, double share, double reach, auto&& capsule_at,
                         auto&& unsure, double relative_motion) {
      double distance = 0.0;
      if (k > 0 && in_reach(now, p, reach, distance))
        at_pose.push_back({distance, nearest_spot(now, p), {now, 0.0, moving, unsure(time), share}});
      const int samples =
          std::min(static_cast<int>(relative_motion / options.clearance_step), kMostSamplesPerSegment);
      for (int i = 1; i <= samples; ++i) {
        const double s = static_cast<double>(i) / (samples + 1);
        const Capsule then = capsule_at(s);
        const Vector2 point = p + s * step;
        if (in_reach(then, point, reach, distance))
          along.push_back(
              {distance, nearest_spot(then, point), {then, s, moving, unsure(time + s * dt), share}});
      }
    };
    for (const Mover& m : field.movers) {
      const auto unsure = [&](double then) { return field.uncertainty.at(m, then); };
      const double reach = moving_reach + unsure(time + dt);
      const Capsule now = mover_at(m, time);
      const Vector2 drift = m.position_at(time + dt) - now.a;
      const double motion = (step - drift).norm();
      if ((p - now.a).norm() - now.radius > reach + motion) continue;
      add(
          now, true, presence(m), reach, [&](double s) { return mover_at(m, time + s * dt); }, unsure,
          motion);
    }
    for (const Capsule* c : statics) {
      add(
          *c, false, 1.0, static_reach, [&](double) { return *c; }, [](double) { return 0.0; }, step.norm());
    }
    keep_nearest(at_pose, count, order, result[k].at_pose);
    keep_nearest(along, count, order, result[k].along_segment);
  }
  return result;
}

}  // namespace bw::teb
