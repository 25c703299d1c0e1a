#include "components/people/prediction/predictor.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "components/people/prediction/social_prediction.hpp"

namespace bw::people {
namespace {

constexpr Duration kForget = Duration::milliseconds(5000);

bool is_finite_person(const TrackedPerson& p) {
  return p.position.allFinite() && p.velocity.allFinite() && p.covariance.allFinite();
}

/// Displacement after t [s] with a turn rate that dies out. The heading turns by
/// omega tau (1 - exp(-t / tau)); the displacement is summed up in small chords.
Vector2 arc(const Vector2& velocity, double omega, double tau, double t) {
  constexpr double kChord = 0.05;  // [s]
  const double speed = velocity.norm();
  const double heading = std::atan2(velocity.y(), velocity.x());
  const int chords = std::max(1, static_cast<int>(std::ceil(t / kChord)));
  const double dt = t / chords;
  Vector2 displacement(0.0, 0.0);
  for (int i = 0; i < chords; ++i) {
    const double middle = (i + 0.5) * dt;
    const double angle = heading + omega * tau * (1.0 - std::exp(-middle / tau));
    displacement += speed * dt * Vector2(std::cos(angle), std::sin(angle));
  }
  return displacement;
}

}  // namespace

Eigen::Matrix2d predicted_covariance(const TrackedPerson& person, double t,
                                     const PredictionOptions& options) {
  const Eigen::Matrix4d& P = person.covariance;
  const Eigen::Matrix2d cross = P.topRightCorner<2, 2>();
  Eigen::Matrix2d C =
      P.topLeftCorner<2, 2>() + t * (cross + cross.transpose()) + t * t * P.bottomRightCorner<2, 2>();
  const double speed = person.velocity.norm();
  const Vector2 along = speed > options.kWalkingSpeed ? Vector2(person.velocity / speed) : Vector2(1.0, 0.0);
  const Vector2 across(-along.y(), along.x());
  // Without a heading both directions spread alike, by the larger.
  const double most = std::max(options.spread_along, options.spread_across);
  const bool walks = speed > options.kWalkingSpeed;
  const double growth = t * t * t / 3.0;
  C += growth * (walks ? options.spread_along : most) * along * along.transpose();
  C += growth * (walks ? options.spread_across : most) * across * across.transpose();
  return 0.5 * (C + C.transpose());
}

double Predictor::turn_rate(const TrackedPerson& person, Time now) {
  if (person.velocity.norm() < options_.kWalkingSpeed) {
    headings_.erase(person.id);
    return 0.0;
  }
  const double heading = std::atan2(person.velocity.y(), person.velocity.x());
  const auto [found, is_new] = headings_.try_emplace(person.id, HeadingMemory{now, heading, 0.0});
  HeadingMemory& memory = found->second;
  const double dt = (now - memory.time).to_seconds();
  if (is_new || dt <= 0.0) return memory.rate;
  const double share = 1.0 - std::exp(-dt / options_.kTurnRateWindow);
  memory.rate += share * (wrap_angle(heading - memory.heading) / dt - memory.rate);
  memory.heading = heading;
  memory.time = now;
  return memory.rate;
}

void Predictor::predict(std::vector<TrackedPerson>& people, const StaticObstacles& walls, Time now) {
  calibration_.forget(now - kForget);
  if (learned_) learned_->forget(now - kForget);
  std::erase_if(headings_, [&](const auto& memory) { return now - memory.second.time > kForget; });
  std::vector<std::vector<Vector2>> walked;
  if (options_.model == PredictionModel::social_force) {
    std::vector<TrackedPerson> sound;
    std::copy_if(people.begin(), people.end(), std::back_inserter(sound), is_finite_person);
    walked = walk_on(sound, walls, options_);
  }

  const int steps = static_cast<int>(std::floor(options_.horizon / options_.step + 1e-9));
  std::size_t index = 0;
  for (TrackedPerson& person : people) {
    std::vector<PredictedPosition>& predictions = person.predictions;
    predictions.clear();
    if (!is_finite_person(person)) continue;
    const double omega = options_.model == PredictionModel::constant_turn_rate ? turn_rate(person, now) : 0.0;
    for (int k = 1; k <= steps; ++k) {
      const double t = k * options_.step;
      Vector2 position = person.position + t * person.velocity;
      if (!walked.empty()) position = walked[static_cast<std::size_t>(k - 1)][index];
      if (omega != 0.0) position = person.position + arc(person.velocity, omega, options_.kTurnRateMemory, t);
      predictions.push_back({t, position, predicted_covariance(person, t, options_)});
    }
    if (learned_) {
      const auto by_head = learned_->predict(person, now);
      for (std::size_t k = 0; by_head && k < std::min(predictions.size(), by_head->size()); ++k)
        predictions[k] = (*by_head)[k];
    }
    ++index;
    calibration_.observe(person.id, now, person.position, person.covariance.topLeftCorner<2, 2>());
    calibration_.expect(person.id, now, predictions);
    for (std::size_t k = 0; k < predictions.size(); ++k) predictions[k].covariance *= calibration_.size(k);
  }
}

}  // namespace bw::people
