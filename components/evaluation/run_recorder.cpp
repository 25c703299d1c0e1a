#include "components/evaluation/run_recorder.hpp"

#include <cmath>
#include <utility>

namespace bw {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(100);

}  // namespace

RunRecorder::RunRecorder(const Footprint& robot, double top_speed) : thinning_(kPeriod) {
  recording_.robot = robot;
  recording_.top_speed = top_speed;
}

void RunRecorder::start(Time now) {
  recording_.moments.clear();
  recording_.goals.clear();
  diary_ = {};
  started_ = now;
  thinning_ = Thinning(kPeriod);
}

double RunRecorder::speed_to(const RecordedMoment& moment) const {
  if (recording_.moments.empty()) return 0.0;
  const RecordedMoment& before = recording_.moments.back();
  return (moment.X_MB.position() - before.X_MB.position()).norm() / (moment.time - before.time);
}

void RunRecorder::add(const TruthSample& sample) {
  diary_.add((sample.time - started_).to_seconds(), sample, recording_.robot);
  if (!sample.X_MB.position().allFinite() || !thinning_.is_due(sample.time)) return;
  RecordedMoment moment{(sample.time - started_).to_seconds(), sample.X_MB, std::abs(sample.twist.v),
                        sample.people};
  if (!std::isfinite(moment.speed)) moment.speed = speed_to(moment);
  moment.twist = {std::isfinite(sample.twist.v) ? sample.twist.v : moment.speed,
                  std::isfinite(sample.twist.omega) ? sample.twist.omega : 0.0};
  thinning_.add(sample.time, std::move(moment), recording_.moments);
}

RunRecording RunRecorder::recording() const {
  RunRecording whole = recording_;
  whole.contacts = diary_.contacts();
  return whole;
}

}  // namespace bw
