#include "components/people/tracker/evidence/fidgets.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

constexpr double kShortest = 0.04;  // [m] of a shift: four times what the mean of a standing disc errs
constexpr double kLongest = 0.25;   // [m]: farther is another thing, or a step
constexpr double kStood = 1.0;      // [s] before a shift
constexpr double kSettled = 0.4;    // [s] after it
constexpr double kGap = 0.5;        // [s] unseen, after which it may be another thing
constexpr int kMean = 20;           // sightings in the mean

}  // namespace

void Fidgets::stand_anew(double time, const Vector2& place, double bearing) {
  stood_ = place;
  since_ = time;
  bearing_ = bearing;
  count_ = 1;
  aside_ = -1.0;
}

void Fidgets::add(double time, const Vector2& place, bool whole, double bearing, double turn) {
  if (!whole) return;
  const bool lost = count_ == 0 || time - last_ > kGap || std::abs(wrap_angle(bearing - bearing_)) > turn;
  last_ = time;
  if (lost || (place - stood_).norm() > kLongest) return stand_anew(time, place, bearing);
  if ((place - stood_).norm() < kShortest) {
    count_ = std::min(count_ + 1, kMean);
    stood_ += (place - stood_) / count_;
    aside_ = -1.0;
    return;
  }
  if (aside_ < 0.0) {
    aside_ = time;
    moved_ = place;
    moved_count_ = 1;
    return;
  }
  moved_ += (place - moved_) / ++moved_count_;
  if (time - aside_ < kSettled) return;
  const bool stands = (place - moved_).norm() < kShortest && (moved_ - stood_).norm() >= kShortest;
  if (stands && aside_ - since_ >= kStood) ++shifts_;
  stand_anew(aside_, moved_, bearing);
}

double Fidgets::log_odds() const { return std::min(kMost, kEach * shifts_); }

}  // namespace bw::people
