#include "components/people/sweep_timing.hpp"

namespace bw::people {
namespace {

constexpr double kReach = 0.5;  // [m] from the middle of somebody to their legs, and what they err

const TrackedPerson* nearest(std::span<const TrackedPerson> people, const Vector2& position, double seconds) {
  const TrackedPerson* best = nullptr;
  double least = kReach;
  for (const TrackedPerson& person : people) {
    const double distance = (person.position + seconds * person.velocity - position).norm();
    if (distance >= least) continue;
    least = distance;
    best = &person;
  }
  return best;
}

}  // namespace

void move_to_one_time(DetectionSet& detections, std::span<const TrackedPerson> people, Time people_time) {
  const double since = (detections.time - people_time).to_seconds();
  for (Detection& detection : detections.detections) {
    if (detection.after == 0.0 || detection.on_static) continue;
    const TrackedPerson* person = nearest(people, detection.position, since + detection.after);
    if (person == nullptr) continue;
    detection.position -= detection.after * person->velocity;
    detection.covariance += detection.after * detection.after * person->covariance.bottomRightCorner<2, 2>();
    detection.after = 0.0;
  }
}

}  // namespace bw::people
