#include "components/evaluation/run_recorder.hpp"

#include <utility>

namespace bw {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(100);
constexpr std::size_t kMostMoments = 6000;  // ten minutes at full detail; then every second moment is dropped

}  // namespace

RunRecorder::RunRecorder(double robot_radius, double top_speed) : period_(kPeriod) {
  recording_.robot_radius = robot_radius;
  recording_.top_speed = top_speed;
}

void RunRecorder::start(Time now, const Vector2& goal) {
  recording_.moments.clear();
  recording_.goals = {goal};
  started_ = now;
  period_ = kPeriod;
  last_.reset();
}

void RunRecorder::add(const TruthSample& sample) {
  if (last_ && sample.time - *last_ < period_) return;
  last_ = sample.time;
  recording_.moments.push_back(
      {(sample.time - started_).to_seconds(), sample.X_MB, std::abs(sample.twist.v), sample.people});
  if (recording_.moments.size() < kMostMoments) return;
  std::vector<RecordedMoment> kept;
  for (std::size_t i = 0; i < recording_.moments.size(); i += 2)
    kept.push_back(std::move(recording_.moments[i]));
  recording_.moments = std::move(kept);
  period_ = period_ * 2;
}

}  // namespace bw
