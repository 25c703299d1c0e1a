#include "components/emulators/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "components/world/ray.hpp"

namespace bw::emulators {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kCentre = 35.0 * kDegree, kSideFrom = 20.0 * kDegree, kSideTo = 100.0 * kDegree;
constexpr int kRays = 9;  // across a beam

void press(ContactReading& pressed, double bearing) {
  pressed.bumper_centre |= std::abs(bearing) <= kCentre;
  pressed.bumper_left |= bearing >= kSideFrom && bearing <= kSideTo;
  pressed.bumper_right |= -bearing >= kSideFrom && -bearing <= kSideTo;
}

double nearest_hit(const Vector2& from, const Vector2& along, double reach, const StaticScene& scene,
                   const std::vector<Disc>& people) {
  double nearest = scene.grid() ? scene.grid()->ray_hit(from, along, reach) : kNoHit;
  const auto meet = [&](const auto& shapes) {
    for (const auto& shape : shapes) nearest = std::min(nearest, ray_hit(from, along, shape));
  };
  meet(scene.segments());
  meet(scene.discs());
  meet(people);
  return nearest;
}

}  // namespace

ContactReading touched(const Pose2& X_map_base, double radius, double gap, const StaticScene& scene,
                       const std::vector<Disc>& people) {
  ContactReading pressed;
  const Pose2 X_base_map = inverse(X_map_base);
  const auto bearing_of = [&](const Vector2& point) {
    const Vector2 seen = X_base_map * point;
    return std::atan2(seen.y(), seen.x());
  };
  if (const auto point = scene.nearest_point(X_map_base.position(), radius + gap))
    press(pressed, bearing_of(*point));
  for (const Disc& person : people) {
    if ((person.center - X_map_base.position()).norm() <= radius + person.radius + gap)
      press(pressed, bearing_of(person.center));
  }
  return pressed;
}

double range_of(const Beam& beam, const Pose2& X_map_base, const StaticScene& scene,
                const std::vector<Disc>& people) {
  const Pose2 X_map_sensor = X_map_base * beam.X_base_sensor;
  double nearest = kNoHit;
  for (int i = 0; i < kRays; ++i) {
    const double aside = beam.half_angle * (2.0 * i / (kRays - 1) - 1.0);
    const Vector2 along = direction(X_map_sensor.theta + aside);
    nearest = std::min(nearest, nearest_hit(X_map_sensor.position(), along, beam.reach, scene, people));
  }
  return nearest <= beam.reach ? nearest : std::numeric_limits<double>::infinity();
}

}  // namespace bw::emulators
