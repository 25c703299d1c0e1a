#include "components/evaluation/run_recorder.hpp"

#include <cmath>
#include <utility>

namespace bw {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(100);
constexpr std::size_t kMaxMoments = 6000;  // ten minutes at full detail; then every second moment is dropped

}  // namespace

RunRecorder::RunRecorder(const Footprint& robot, double top_speed) : period_(kPeriod) {
  recording_.robot = robot;
  recording_.top_speed = top_speed;
}

void RunRecorder::start(Time now) {
  recording_.moments.clear();
  recording_.goals.clear();
  recording_.contacts.clear();
  diary_ = {};
  started_ = now;
  period_ = kPeriod;
  last_.reset();
}

double RunRecorder::speed_to(const RecordedMoment& moment) const {
  if (recording_.moments.empty()) return 0.0;
  const RecordedMoment& before = recording_.moments.back();
  return (moment.X_MB.position() - before.X_MB.position()).norm() / (moment.time - before.time);
}

void RunRecorder::add(const TruthSample& sample) {
  diary_.add((sample.time - started_).to_seconds(), sample, recording_.robot);
  recording_.contacts = diary_.contacts();
  if (!sample.X_MB.position().allFinite() || (last_ && sample.time - *last_ < period_)) return;
  last_ = sample.time;
  RecordedMoment moment{(sample.time - started_).to_seconds(), sample.X_MB, std::abs(sample.twist.v),
                        sample.people};
  if (!std::isfinite(moment.speed)) moment.speed = speed_to(moment);
  moment.twist = {std::isfinite(sample.twist.v) ? sample.twist.v : moment.speed,
                  std::isfinite(sample.twist.omega) ? sample.twist.omega : 0.0};
  recording_.moments.push_back(std::move(moment));
  if (recording_.moments.size() < kMaxMoments) return;
  std::vector<RecordedMoment> kept;
  for (std::size_t i = 0; i < recording_.moments.size(); i += 2)
    kept.push_back(std::move(recording_.moments[i]));
  recording_.moments = std::move(kept);
  period_ = period_ * 2;
}

}  // namespace bw
