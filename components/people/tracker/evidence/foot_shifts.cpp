#include "components/people/tracker/evidence/foot_shifts.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

constexpr double kShortest = 0.04;       // [m] of a shift: four times what the mean of a standing disc errs
constexpr double kLongest = 0.25;        // [m]: farther is another thing, or a step
constexpr double kStood = 1.0 - 1e-9;    // [s] in view before a shift
constexpr double kSettled = 0.4 - 1e-9;  // [s] after it
constexpr double kGap = 0.5;             // [s] between sightings that is not time in view
constexpr int kMean = 20;                // sightings in the mean

}  // namespace

void FootShifts::stand_anew(const Vector2& position, double bearing, double stood_for) {
  stood_ = position;
  stood_for_ = stood_for;
  bearing_ = bearing;
  count_ = 1;
  aside_ = false;
}

void FootShifts::add(double time, const Vector2& position, bool whole, double bearing, const Memory& memory) {
  if (!whole) return;
  const double since = time - last_;
  const bool lost =
      count_ == 0 || since > memory.gap || std::abs(wrap_angle(bearing - bearing_)) > memory.bearing_change;
  last_ = time;
  if (lost || (position - stood_).norm() > kLongest) return stand_anew(position, bearing, 0.0);
  const double in_view = since > kGap ? 0.0 : since;
  if (!aside_) stood_for_ += in_view;
  if ((position - stood_).norm() < kShortest) {
    count_ = std::min(count_ + 1, kMean);
    stood_ += (position - stood_) / count_;
    aside_ = false;
    return;
  }
  if (!aside_) {
    aside_ = true;
    moved_ = position;
    moved_for_ = 0.0;
    moved_count_ = 1;
    return;
  }
  moved_for_ += in_view;
  moved_ += (position - moved_) / ++moved_count_;
  if (moved_for_ < kSettled) return;
  const bool stands = (position - moved_).norm() < kShortest && (moved_ - stood_).norm() >= kShortest;
  if (stands && stood_for_ >= kStood) ++shifts_;
  stand_anew(moved_, bearing, moved_for_);
}

double FootShifts::log_odds() const { return std::min(kMax, kEach * shifts_); }

}  // namespace bw::people
