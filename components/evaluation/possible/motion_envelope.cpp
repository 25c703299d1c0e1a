#include "components/evaluation/possible/motion_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw::possible {
namespace {

constexpr double kSlice = 0.01;  // [s] over which the extremes of its end are taken

/// Integral of min(first + rate t, most) from 0 to `elapsed`, where first <= most.
double integral_up(double first, double rate, double most, double elapsed) {
  const double rising = std::min(elapsed, (most - first) / rate);
  return first * rising + 0.5 * rate * rising * rising + most * (elapsed - rising);
}

/// Least and largest cosine over angles [low, high].
Range cosines(double low, double high) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  const auto holds = [&](double angle) { return angle + kTwoPi * std::ceil((low - angle) / kTwoPi) <= high; };
  const double a = std::cos(low);
  const double b = std::cos(high);
  return {holds(std::numbers::pi) ? -1.0 : std::min(a, b), holds(0.0) ? 1.0 : std::max(a, b)};
}

}  // namespace

MotionEnvelope::MotionEnvelope(const MotionState& start, const MotionBounds& bounds)
    : start_(start), bounds_(bounds) {}

Range MotionEnvelope::speeds(double elapsed) const {
  const double v = start_.twist.v;
  const double change = bounds_.acceleration * elapsed;
  return {std::max(std::min(-bounds_.v_back_max, v), v - change),
          std::min(std::max(bounds_.v_max, v), v + change)};
}

Range MotionEnvelope::turn_rates(double elapsed) const {
  const double omega = start_.twist.omega;
  const double most = std::max(bounds_.omega_max, std::abs(omega));
  const double change = bounds_.alpha * elapsed;
  return {std::max(-most, omega - change), std::min(most, omega + change)};
}

Range MotionEnvelope::heading_change(double elapsed) const {
  const double omega = start_.twist.omega;
  const double most = std::max(bounds_.omega_max, std::abs(omega));
  return {-integral_up(-omega, bounds_.alpha, most, elapsed),
          integral_up(omega, bounds_.alpha, most, elapsed)};
}

void MotionEnvelope::advance_to(double elapsed) {
  while (elapsed_ < elapsed - 1e-9) {
    const double slice = std::min(kSlice, elapsed - elapsed_);
    elapsed_ += slice;
    const Range v = speeds(elapsed_);
    const Range angle = heading_change(elapsed_);
    const Range before = heading_change(elapsed_ - slice);  // a robot that rotates can have been beyond
    for (int k = 0; k < kDirections; ++k) {
      const double direction = 2.0 * std::numbers::pi * k / kDirections - start_.pose.theta;
      const Range c =
          cosines(std::min(angle.low, before.low) - direction, std::max(angle.high, before.high) - direction);
      support_[static_cast<std::size_t>(k)] +=
          slice * std::max({v.low * c.low, v.low * c.high, v.high * c.low, v.high * c.high});
    }
  }
}

Range MotionEnvelope::across(double y, double reach) const {
  Range range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    const double nx = std::cos(angle);
    const double ny = std::sin(angle);
    const double most =
        support_[static_cast<std::size_t>(k)] + reach * (std::abs(nx) + std::abs(ny)) - ny * y;
    if (std::abs(nx) < 1e-9) {
      if (most < 0.0) return {0.0, -1.0};
    } else if (nx > 0.0) {
      range.high = std::min(range.high, most / nx);
    } else {
      range.low = std::max(range.low, most / nx);
    }
  }
  return range;
}

}  // namespace bw::possible
