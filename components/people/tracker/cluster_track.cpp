#include "components/people/tracker/cluster_track.hpp"

#include <cmath>

namespace bw::people {
namespace {

constexpr double kAcceleration = 2.0;  // [m/s^2/sqrt(Hz)], legs that swing
constexpr double kSlotRounding = 1e-6;

}  // namespace

ClusterTrack::ClusterTrack(const Sighting& first)
    : position_(first.position), p_(first.variance), source_(first.source), born_(first.time) {
  remember(first);
}

void ClusterTrack::remember(const Sighting& seen) {
  const auto slot = [](double time) { return std::floor(time / kSpacing + kSlotRounding); };
  const std::int64_t nth = count_ == 0 ? 1 : last().nth + 1;
  existence.appearance.add(seen.likeness(), seen.bearing,
                           count_ == 0 ? Appearance::kEach : seen.time - last().time);
  if (count_ == 0 || slot(seen.time) != slot(last().time)) ++count_;
  Sighting& kept = ring_[(count_ - 1) % kRemembered];
  kept = seen;
  kept.nth = nth;
}

void ClusterTrack::predict(double dt) {
  constexpr double q = kAcceleration * kAcceleration;
  position_ += dt * velocity_;
  p_ += dt * (2.0 * pv_ + dt * vv_) + q * dt * dt * dt / 3.0;
  pv_ += dt * vv_ + q * dt * dt / 2.0;
  vv_ += q * dt;
}

void ClusterTrack::correct(const Sighting& seen) {
  const double s = p_ + seen.variance;
  const Vector2 innovation = seen.position - position_;
  position_ += p_ / s * innovation;
  velocity_ += pv_ / s * innovation;
  vv_ -= pv_ * pv_ / s;
  pv_ *= 1.0 - p_ / s;
  p_ *= 1.0 - p_ / s;
  remember(seen);
}

}  // namespace bw::people
