#include "components/lab/people_training/prediction_judge.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/LU>

#include "components/model/random.hpp"
#include "components/model/tracked_person.hpp"

namespace bw::people {
namespace {

constexpr double kFollowed = 3.2;        // [s]
constexpr double kInside = 5.991464547;  // chi-square, 2 dof, 95 %
constexpr double kAnnotated = 0.9;       // [s] between two annotations at most
constexpr double kRounding = 1e-6;       // [s]

class WalkerFilter {
 public:
  explicit WalkerFilter(const Vector2& position) {
    x_ << position.x(), position.y(), 0.0, 0.0;
    P_.diagonal() << kNoise * kNoise, kNoise * kNoise, 2.0, 2.0;
  }

  void update(const Vector2& position, double dt) {
    Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
    F(0, 2) = F(1, 3) = dt;
    Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
    for (int i = 0; i < 2; ++i) {
      Q(i, i) = kAcceleration * dt * dt * dt / 3.0;
      Q(i, i + 2) = Q(i + 2, i) = kAcceleration * dt * dt / 2.0;
      Q(i + 2, i + 2) = kAcceleration * dt;
    }
    x_ = F * x_;
    P_ = F * P_ * F.transpose() + Q;
    const Eigen::Matrix2d S = P_.topLeftCorner<2, 2>() + kNoise * kNoise * Eigen::Matrix2d::Identity();
    const Eigen::Matrix<double, 4, 2> K = P_.leftCols<2>() * S.inverse();
    x_ += K * (position - x_.head<2>());
    P_ = (P_ - K * P_.topRows<2>()).eval();
    P_ = 0.5 * (P_ + P_.transpose()).eval();
  }

  TrackedPerson state(std::uint32_t id) const {
    return {{.id = id, .position = x_.head<2>(), .velocity = x_.tail<2>()}, P_};
  }

 private:
  static constexpr double kNoise = 0.05;        // [m]
  static constexpr double kAcceleration = 0.3;  // [m^2/s^3]
  Eigen::Vector4d x_;
  Eigen::Matrix4d P_ = Eigen::Matrix4d::Zero();
};

std::optional<Vector2> truth_at(const Track& track, double time) {
  for (std::size_t k = 0; k + 1 < track.samples.size(); ++k) {
    const TrackSample& a = track.samples[k];
    const TrackSample& b = track.samples[k + 1];
    if (time < a.time - kRounding || time > b.time + kRounding || b.time - a.time > kAnnotated) continue;
    return a.position + (time - a.time) / (b.time - a.time) * (b.position - a.position);
  }
  return std::nullopt;
}

}  // namespace

std::vector<PredictionVerdict> judge_prediction(const std::vector<Track>& tracks, Predictor predictor,
                                                const Judging& how) {
  std::map<double, std::vector<std::pair<std::size_t, std::size_t>>> moments;  // time to (track, sample)
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    for (std::size_t k = 0; k < tracks[i].samples.size(); ++k)
      moments[tracks[i].samples[k].time].push_back({i, k});
  }
  Random random(5);
  std::map<std::size_t, WalkerFilter> filters;
  std::vector<PredictionVerdict> verdicts(how.times.size());
  for (const auto& [time, seen] : moments) {
    const Time now = Time::seconds(time);
    std::vector<TrackedPerson> people;
    for (const auto& [i, k] : seen) {
      const auto& samples = tracks[i].samples;
      const double x = random.normal();
      const double y = random.normal();
      const Vector2 position = samples[k].position + how.noise * Vector2(x, y);
      const auto [filter, is_new] = filters.try_emplace(i, position);
      if (!is_new) filter->second.update(position, time - samples[k - 1].time);
      people.push_back(filter->second.state(tracks[i].id));
      people.back().last_seen = now;
    }
    predictor.predict(people, how.walls, now);
    for (std::size_t n = 0; n < seen.size(); ++n) {
      const Track& track = tracks[seen[n].first];
      if (time - track.samples.front().time < kFollowed - kRounding) continue;
      const std::vector<PredictedPosition>& predictions = people[n].predictions;
      for (std::size_t h = 0; h < how.times.size(); ++h) {
        const auto truth = truth_at(track, time + how.times[h]);
        if (!truth) continue;
        const auto step = std::lround(how.times[h] / predictions.front().time);
        const PredictedPosition& predicted = predictions.at(static_cast<std::size_t>(step - 1));
        const Vector2 error = *truth - predicted.position;
        const double distance = error.dot(predicted.covariance.inverse() * error);
        PredictionVerdict& verdict = verdicts[h];
        verdict.loss += std::log(2.0 * std::numbers::pi) +
                        0.5 * std::log(predicted.covariance.determinant()) + 0.5 * distance;
        verdict.error += error.norm();
        verdict.inside += distance < kInside ? 1.0 : 0.0;
        ++verdict.count;
      }
    }
  }
  for (PredictionVerdict& verdict : verdicts) {
    verdict.loss /= verdict.count;
    verdict.error /= verdict.count;
    verdict.inside /= verdict.count;
  }
  return verdicts;
}

}  // namespace bw::people
