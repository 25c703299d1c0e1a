#include "components/model/local_plane.hpp"

#include <cmath>
#include <numbers>

namespace bw::localization {
namespace {

// WGS 84 defining constants.
constexpr double kSemiMajorAxis = 6378137.0;  // [m]
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kEccentricitySquared = kFlattening * (2.0 - kFlattening);
constexpr double kDegree = std::numbers::pi / 180.0;

double prime_vertical_radius(double sine) {
  return kSemiMajorAxis / std::sqrt(1.0 - kEccentricitySquared * sine * sine);
}

}  // namespace

bool is_plausible(const Geodetic& geodetic) {
  return std::abs(geodetic.latitude) <= 90.0 && std::abs(geodetic.longitude) <= 360.0 &&
         geodetic.altitude >= -20e3 && geodetic.altitude <= 100e3;  // false for NaN
}

Eigen::Vector3d to_earth_centred(const Geodetic& geodetic) {
  const double sine = std::sin(geodetic.latitude * kDegree);
  const double cosine = std::cos(geodetic.latitude * kDegree);
  const double N = prime_vertical_radius(sine);
  const double axis_distance = (N + geodetic.altitude) * cosine;
  return {axis_distance * std::cos(geodetic.longitude * kDegree),
          axis_distance * std::sin(geodetic.longitude * kDegree),
          (N * (1.0 - kEccentricitySquared) + geodetic.altitude) * sine};
}

std::optional<LocalPlane> LocalPlane::around(const Geodetic& datum) {
  if (!is_plausible(datum)) return std::nullopt;
  return LocalPlane(datum);
}

LocalPlane::LocalPlane(const Geodetic& datum) : datum_(datum), origin_(to_earth_centred(datum)) {
  const double sin_lat = std::sin(datum.latitude * kDegree);
  const double cos_lat = std::cos(datum.latitude * kDegree);
  const double sin_lon = std::sin(datum.longitude * kDegree);
  const double cos_lon = std::cos(datum.longitude * kDegree);
  R_plane_earth_ << -sin_lon, cos_lon, 0.0,             // east
      -sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat,  // north
      cos_lat * cos_lon, cos_lat * sin_lon, sin_lat;    // up
}

Eigen::Vector3d LocalPlane::to_plane(const Geodetic& geodetic) const {
  return R_plane_earth_ * (to_earth_centred(geodetic) - origin_);
}

Geodetic LocalPlane::to_geodetic(const Eigen::Vector3d& east_north_up) const {
  const Eigen::Vector3d p = origin_ + R_plane_earth_.transpose() * east_north_up;
  const double axis_distance = std::hypot(p.x(), p.y());
  // Fixed point on the latitude: the error shrinks by e^2 = 0.0067 a turn, so that six reach double
  // precision.
  double latitude = std::atan2(p.z(), axis_distance * (1.0 - kEccentricitySquared));
  for (int i = 0; i < 8; ++i) {
    const double sine = std::sin(latitude);
    latitude = std::atan2(p.z() + kEccentricitySquared * prime_vertical_radius(sine) * sine, axis_distance);
  }
  const double sine = std::sin(latitude);
  const double cosine = std::cos(latitude);
  const double N = prime_vertical_radius(sine);
  // This form of the altitude has no division that fails at poles or equator.
  const double altitude =
      axis_distance * cosine + p.z() * sine - N * (1.0 - kEccentricitySquared * sine * sine);
  return {latitude / kDegree, std::atan2(p.y(), p.x()) / kDegree, altitude};
}

}  // namespace bw::localization
