#include "components/people/prediction/learned_prediction.hpp"

#include <cmath>
#include <numeric>

#include <Eigen/LU>

namespace bw::people {
namespace {

constexpr double kSeen = 0.15;  // [s] since a sweep showed the person: guesses of who is hidden are no walk
constexpr double kUnseenGap = 0.6;     // [s] between two sights: the past begins anew
constexpr std::size_t kJudged = 1;     // step ahead that is judged, of 0.5 s each: 1 s
constexpr std::size_t kResiduals = 4;  // last ones that are judged together
constexpr double kBound = 26.1245;     // chi-square of 0.999, 2 kResiduals degrees of freedom

double seconds(Time later, Time earlier) { return (later - earlier).to_seconds(); }

}  // namespace

std::optional<std::vector<PredictedPosition>> LearnedPrediction::predict(const TrackedPerson& tracked,
                                                                         Time now) {
  if (tracked.last_seen != Time{} && seconds(now, tracked.last_seen) > kSeen) return std::nullopt;
  Person& person = people_[tracked.id];
  see(person, tracked, now);
  const std::vector<Vector2> past = past_of(person, now);
  if (past.size() < kLeastPast) return std::nullopt;
  std::optional<std::vector<PredictedPosition>> predictions = predict_by_head(weights_, past);
  if (!predictions) {
    ++refused_;
    return std::nullopt;
  }
  const PredictedPosition& judged = (*predictions)[kJudged];
  const Time due = now + Duration::seconds(judged.time);
  if (person.expected.empty() || seconds(due, person.expected.back().due) >= kAheadStep - 1e-6)
    person.expected.push_back({due, judged});
  if (!proves_right(person)) return std::nullopt;
  return predictions;
}

void LearnedPrediction::see(Person& person, const TrackedPerson& tracked, Time now) {
  std::deque<Sight>& sights = person.sights;
  if (!sights.empty() && (seconds(now, sights.back().time) > kUnseenGap || now <= sights.back().time))
    person = {};
  while (!person.expected.empty() && now >= person.expected.front().due) {
    // Where the person was at that instant, between two sights.
    const Expected& expected = person.expected.front();
    const Sight last = sights.back();
    const double share = seconds(expected.due, last.time) / seconds(now, last.time);
    const Vector2 truth = last.position + share * (tracked.position - last.position);
    const Vector2 error = truth - expected.prediction.position;
    const Eigen::Matrix2d C = expected.prediction.covariance + tracked.covariance.topLeftCorner<2, 2>();
    person.residuals.push_back(error.dot(C.inverse() * error));
    if (person.residuals.size() > kResiduals) person.residuals.pop_front();
    person.expected.pop_front();
  }
  sights.push_back({now, tracked.position});
  while (seconds(now, sights.front().time) > kMostPast * kPastStep + kUnseenGap) sights.pop_front();
}

std::vector<Vector2> LearnedPrediction::past_of(const Person& person, Time now) {
  std::vector<Vector2> past{person.sights.back().position};
  auto later = person.sights.rbegin();
  for (int k = 1; k < kMostPast; ++k) {
    const Time then = now - Duration::seconds(k * kPastStep);
    while (std::next(later) != person.sights.rend() && std::next(later)->time > then) ++later;
    const auto earlier = std::next(later);
    if (earlier == person.sights.rend()) break;
    const double share = seconds(then, earlier->time) / seconds(later->time, earlier->time);
    past.push_back(earlier->position + share * (later->position - earlier->position));
  }
  return past;
}

bool LearnedPrediction::proves_right(const Person& person) {
  const double sum = std::accumulate(person.residuals.begin(), person.residuals.end(), 0.0);
  return std::isfinite(sum) && sum <= kBound;
}

void LearnedPrediction::forget(Time before) {
  std::erase_if(people_, [&](const auto& entry) { return entry.second.sights.back().time < before; });
}

}  // namespace bw::people
