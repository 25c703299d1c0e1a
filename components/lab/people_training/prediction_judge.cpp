#include "components/lab/people_training/prediction_judge.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/LU>

#include "components/lab/people_training/walker_filter.hpp"
#include "components/model/random.hpp"

namespace bw::people {
namespace {

constexpr double kFollowed = 3.2;        // [s]
constexpr double kInside = 5.991464547;  // chi-square, 2 dof, 95 %
constexpr double kAnnotated = 0.9;       // [s] between two annotations at most
constexpr double kRounding = 1e-6;       // [s]

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

PredictionVerdict judge_prediction(const std::vector<Track>& tracks, double noise, PredictionOptions options,
                                   const std::optional<HeadWeights>& head) {
  options.step = kAheadStep;
  std::map<double, std::vector<std::pair<std::size_t, std::size_t>>> moments;  // time to (track, sample)
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    for (std::size_t k = 0; k < tracks[i].samples.size(); ++k)
      moments[tracks[i].samples[k].time].push_back({i, k});
  }
  Random random(5);
  std::map<std::size_t, WalkerFilter> filters;
  Predictor predictor(options, head);
  PredictionVerdict verdict;
  for (const auto& [time, seen] : moments) {
    const Time now = Time::seconds(time);
    std::vector<TrackedPerson> people;
    for (const auto& [i, k] : seen) {
      const auto& samples = tracks[i].samples;
      const double x = random.normal();
      const double y = random.normal();
      const Vector2 position = samples[k].position + noise * Vector2(x, y);
      const auto [filter, is_new] = filters.try_emplace(i, position);
      if (!is_new) filter->second.update(position, time - samples[k - 1].time);
      people.push_back(filter->second.state(tracks[i].id));
      people.back().last_seen = now;
    }
    predictor.predict(people, {}, now);
    for (std::size_t n = 0; n < seen.size(); ++n) {
      const Track& track = tracks[seen[n].first];
      if (time - track.samples.front().time < kFollowed - kRounding) continue;
      for (std::size_t h = 0; h < verdict.loss.size(); ++h) {
        const auto truth = truth_at(track, time + static_cast<double>(h + 1));
        if (!truth) continue;
        const PredictedPosition& predicted = people[n].predictions[2 * h + 1];
        const Vector2 error = *truth - predicted.position;
        const double distance = error.dot(predicted.covariance.inverse() * error);
        verdict.loss[h] += std::log(2.0 * std::numbers::pi) +
                           0.5 * std::log(predicted.covariance.determinant()) + 0.5 * distance;
        verdict.error[h] += error.norm();
        verdict.inside[h] += distance < kInside ? 1.0 : 0.0;
        ++verdict.count[h];
      }
    }
  }
  for (std::size_t h = 0; h < verdict.loss.size(); ++h) {
    verdict.loss[h] /= verdict.count[h];
    verdict.error[h] /= verdict.count[h];
    verdict.inside[h] /= verdict.count[h];
  }
  return verdict;
}

}  // namespace bw::people
