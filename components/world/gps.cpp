#include "components/world/gps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw {

Vector2 to_latitude_longitude(const Vector2& east_north, double datum_latitude, double datum_longitude) {
  constexpr double kSemiMajorAxis = 6378137.0;               // WGS 84 [m]
  constexpr double kEccentricitySquared = 6.69437999014e-3;  // WGS 84
  constexpr double kDegree = std::numbers::pi / 180.0;
  const double sine = std::sin(datum_latitude * kDegree);
  const double w = 1.0 - kEccentricitySquared * sine * sine;
  const double prime_vertical = kSemiMajorAxis / std::sqrt(w);
  const double meridional = prime_vertical * (1.0 - kEccentricitySquared) / w;
  return {datum_latitude + east_north.y() / meridional / kDegree,
          datum_longitude + east_north.x() / (prime_vertical * std::cos(datum_latitude * kDegree)) / kDegree};
}

void Gps::measure(Duration now, const Vector2& position_in_map) {
  GpsFix fix;
  fix.measured_at = now;
  const double east_noise =
      options_.noise * random_.normal();  // drawn in outages too: a zone never shifts the stream
  const double north_noise = options_.noise * random_.normal();
  fix.valid =
      std::none_of(options_.outage_zones.begin(), options_.outage_zones.end(), [&](const OutageZone& zone) {
        return position_in_map.x() >= zone.x_min && position_in_map.x() <= zone.x_max &&
               position_in_map.y() >= zone.y_min && position_in_map.y() <= zone.y_max;
      });
  fix.position = position_in_map + Vector2(east_noise, north_noise);
  const Vector2 geodetic =
      to_latitude_longitude(fix.position, options_.datum_latitude, options_.datum_longitude);
  fix.latitude = geodetic.x();
  fix.longitude = geodetic.y();
  in_transit_.push_back(fix);
}

std::vector<GpsFix> Gps::arrived(Duration now) {
  std::vector<GpsFix> fixes;
  const Duration latency = Duration::seconds(options_.latency);
  while (!in_transit_.empty() && in_transit_.front().measured_at + latency <= now) {
    fixes.push_back(in_transit_.front());
    in_transit_.pop_front();
  }
  return fixes;
}

}  // namespace bw
