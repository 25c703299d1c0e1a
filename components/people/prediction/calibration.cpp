#include "components/people/prediction/calibration.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace bw::people {
namespace {

constexpr double kShare = 0.95;            // of truths that an ellipse should hold
constexpr double kInside = 5.991464547;    // chi-square of that, 2 degrees of freedom
constexpr double kMaxLogSize = 2.7725887;  // log 16
constexpr double kGap = 0.6;               // [s] without a sight of the person: nothing is compared

}  // namespace

double Calibration::size(std::size_t k) const { return k < log_size_.size() ? std::exp(log_size_[k]) : 1.0; }

void Calibration::expect(std::uint32_t id, Time now, const std::vector<PredictedPosition>& predictions) {
  if (rate_ <= 0.0 || predictions.empty()) return;
  if (log_size_.size() < predictions.size()) log_size_.resize(predictions.size(), 0.0);
  std::vector<Expected>& expected = people_[id].expected;
  const bool is_due =
      expected.empty() || (now - expected.back().made).to_seconds() >= predictions.front().time - 1e-6;
  if (is_due) expected.push_back({now, predictions});
}

void Calibration::observe(std::uint32_t id, Time now, const Vector2& position,
                          const Eigen::Matrix2d& covariance) {
  if (rate_ <= 0.0) return;
  Person& person = people_[id];
  const double since = person.seen == Time{} ? 0.0 : (now - person.seen).to_seconds();
  for (Expected& expected : person.expected) {
    while (expected.next < expected.predictions.size()) {
      const PredictedPosition& predicted = expected.predictions[expected.next];
      const double late = (now - expected.made).to_seconds() - predicted.time;
      if (late < -1e-6) break;
      // Between two sights: where the person was at that instant.
      const double share = since > 0.0 ? std::clamp(late / since, 0.0, 1.0) : 0.0;
      if (since <= kGap)
        compare(expected.next, predicted, position + share * (person.position - position), covariance);
      ++expected.next;
    }
  }
  std::erase_if(person.expected, [](const Expected& e) { return e.next >= e.predictions.size(); });
  person.seen = now;
  person.position = position;
}

void Calibration::compare(std::size_t k, const PredictedPosition& predicted, const Vector2& truth,
                          const Eigen::Matrix2d& covariance) {
  const Vector2 error = truth - predicted.position;
  const Eigen::Matrix2d C = size(k) * predicted.covariance + covariance;
  const double distance = error.dot(C.inverse() * error);
  if (!std::isfinite(distance)) return;
  const double change = distance > kInside ? rate_ * kShare : -rate_ * (1.0 - kShare);
  log_size_[k] = std::clamp(log_size_[k] + change, -kMaxLogSize, kMaxLogSize);
}

void Calibration::forget(Time before) {
  std::erase_if(people_, [&](const auto& person) { return person.second.seen < before; });
}

}  // namespace bw::people
