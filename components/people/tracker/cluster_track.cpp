#include "components/people/tracker/cluster_track.hpp"

namespace bw::people {
namespace {

constexpr double kAcceleration = 2.0;  // [m/s^2/sqrt(Hz)], legs that swing

}  // namespace

ClusterTrack::ClusterTrack(const Sighting& first) : position_(first.position), p_(first.variance) {
  ring_[0] = first;
  count_ = 1;
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
  ring_[count_ % kRemembered] = seen;
  ++count_;
}

}  // namespace bw::people
