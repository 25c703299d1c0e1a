// Scores predictions on recorded people (experiments/protocols.md 8.7): each track is followed by the filter of the reference
// figures; after 3.2 s of it every annotation is predicted from.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "components/lab/people_training/walker_filter.hpp"
#include "components/people/prediction/predictor.hpp"
#include "components/world/replayed_people.hpp"

namespace bw::people {

constexpr std::array<double, 3> kScoredHorizons{0.8, 1.6, 4.8};  // [s]

struct PredictionScore {
  std::array<double, 3> mean_error{};  ///< [m]
  std::array<double, 3> inside_95{};   ///< share of truths inside the 95 % ellipse
  std::array<int, 3> count{};
};

inline PredictionScore score_prediction(const std::vector<Track>& tracks, const StaticObstacles& walls,
                                        PredictionOptions options) {
  constexpr double kFollowed = 3.2;        // [s]
  constexpr double kSameMoment = 0.05;     // [s]
  constexpr double kInside = 5.991464547;  // chi-square, 2 dof, 95 %
  options.horizon = 4.8;
  options.step = 0.8;
  std::map<double, std::vector<std::pair<std::size_t, std::size_t>>> moments;  // time to (track, sample)
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    for (std::size_t k = 0; k < tracks[i].samples.size(); ++k)
      moments[tracks[i].samples[k].time].push_back({i, k});
  }
  std::map<std::size_t, WalkerFilter> filters;
  Predictor predictor(options);
  PredictionScore score;
  for (const auto& [time, seen] : moments) {
    std::vector<TrackedPerson> people;
    for (const auto& [i, k] : seen) {
      const auto& samples = tracks[i].samples;
      const auto [filter, is_new] = filters.try_emplace(i, samples[k].position);
      if (!is_new) filter->second.update(samples[k].position, time - samples[k - 1].time);
      people.push_back(filter->second.state(tracks[i].id));
    }
    predictor.predict(people, walls, Time{} + Duration::seconds(time));
    for (std::size_t n = 0; n < seen.size(); ++n) {
      const auto& samples = tracks[seen[n].first].samples;
      if (time - samples.front().time < kFollowed - 1e-6) continue;
      for (std::size_t h = 0; h < kScoredHorizons.size(); ++h) {
        const double then = time + kScoredHorizons[h];
        const auto truth = std::find_if(samples.begin(), samples.end(),
                                        [&](const auto& s) { return std::abs(s.time - then) < kSameMoment; });
        if (truth == samples.end()) continue;
        const auto& predicted =
            people[n].predictions[static_cast<std::size_t>(std::lround(kScoredHorizons[h] / 0.8)) - 1];
        const Vector2 error = truth->position - predicted.position;
        score.mean_error[h] += error.norm();
        score.inside_95[h] += error.dot(predicted.covariance.inverse() * error) < kInside ? 1.0 : 0.0;
        ++score.count[h];
      }
    }
  }
  for (std::size_t h = 0; h < kScoredHorizons.size(); ++h) {
    score.mean_error[h] /= score.count[h];
    score.inside_95[h] /= score.count[h];
  }
  return score;
}

}  // namespace bw::people
