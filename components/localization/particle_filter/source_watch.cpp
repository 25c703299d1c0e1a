#include "components/localization/particle_filter/source_watch.hpp"

#include <algorithm>
#include <cmath>

namespace bw::localization {
namespace {

constexpr double kMemory = 50.0;  // measurements that the smoothed figures look back on
constexpr double kMaxNis = 100.0;
constexpr int kMisfits = 3;             // in a row begin a new run
constexpr double kDistanceSlack = 0.1;  // wheels may measure a distance this much short
constexpr double kRotationSlack = 0.1;  // [rad] and a rotation

}  // namespace

bool SourceWatch::is_kind(std::size_t kind) {
  if (!kind_) kind_ = kind;
  return *kind_ == kind;
}

bool SourceWatch::is_duplicate(Time time) const {
  if (seen_count_ == 0 || time > newest_) return false;
  const std::size_t known = std::min(seen_count_, stamps_.size());
  return std::find(stamps_.begin(), stamps_.begin() + static_cast<long>(known), time) !=
         stamps_.begin() + static_cast<long>(known);
}

void SourceWatch::note_seen(Time time) {
  if (seen_count_ > 0 && time > last_seen_) {
    const double dt = (time - last_seen_).to_seconds();
    double& period = health_.period;
    period = period == 0.0 ? dt : period + 0.1 * (dt - period);
  }
  if (seen_count_ == 0) last_used_ = time;  // rejections are counted from here
  newest_ = seen_count_ == 0 ? time : std::max(newest_, time);
  last_seen_ = newest_;
  stamps_[seen_count_ % stamps_.size()] = time;
  ++seen_count_;
}

void SourceWatch::note_compared(Time time, bool used, double nis, int dof) {
  const double seen = 1.0 + health_.used + health_.rejected;
  health_.acceptance += ((used ? 1.0 : 0.0) - health_.acceptance) / std::min(seen, kMemory);
  health_.nis_all += (std::min(nis, kMaxNis) - health_.nis_all) / std::min(seen, kMemory);
  health_.dof = dof;
  if (!used) {
    ++health_.rejected;
    return;
  }
  ++health_.used;
  health_.nis += (nis - health_.nis) / std::min(static_cast<double>(health_.used), kMemory);
  last_used_ = std::max(last_used_, time);
  end_run();
}

const RejectionRun& SourceWatch::note_rejection(const Comparison& c, const Pose2& X_OB, double odometer,
                                                Time time, double gate) {
  const Vector2 point = X_OB * c.point;
  bool fits = run_.count > 0;
  if (fits && c.position) {
    const double noise = std::sqrt(2.0 * gate * std::max(c.R(0, 0), c.R(1, 1)));
    const double distance = (point - run_.point).norm();
    const double said = (*c.position - run_.position).norm();
    fits = std::abs(said - distance) <= kDistanceSlack * distance + noise;
  }
  if (fits && c.heading) {
    const double noise = std::sqrt(2.0 * gate * c.R(c.size - 1, c.size - 1));
    const double rotation = wrap_angle(X_OB.theta - run_.heading_O);
    fits = std::abs(wrap_angle(*c.heading - run_.heading - rotation)) <= noise + kRotationSlack;
  }
  if (!fits && run_.count > 0 && ++run_.misfits < kMisfits) return run_;
  if (!fits) {
    run_ = {};
    run_.since = time;
    run_.odometer = odometer;
  }
  ++run_.count;
  run_.misfits = 0;
  run_.point = point;
  run_.heading_O = X_OB.theta;
  if (c.heading) run_.heading = *c.heading;
  if (c.position) {
    run_.position = *c.position;
    run_.fit.add(*c.position, point);
  }
  return run_;
}

void SourceWatch::move_stamps(Time time) {
  last_seen_ = last_used_ = time;
  newest_ = time;
  seen_count_ = std::min<std::size_t>(seen_count_, 1);
  stamps_[0] = Time{};
  end_run();
}

void SourceWatch::gives(bool position, bool heading) {
  gives_position_ = position;
  gives_heading_ = heading;
}

}  // namespace bw::localization
