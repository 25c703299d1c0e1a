// Satellite positions in a plane: WGS 84 latitude, longitude, altitude to east, north, up of a datum, and
// back, through earth-centred coordinates (exact, no approximation by radii).
#pragma once

#include <optional>

#include <Eigen/Core>

namespace bw::localization {

struct Geodetic {
  double latitude = 0.0;   ///< [deg], north positive
  double longitude = 0.0;  ///< [deg], east positive
  double altitude = 0.0;   ///< [m] above the ellipsoid
};

/// Finite, |latitude| <= 90, |longitude| <= 360, altitude in [-20 km, 100 km].
bool is_plausible(const Geodetic& geodetic);

/// Earth-centred, earth-fixed [m].
Eigen::Vector3d to_earth_centred(const Geodetic& geodetic);

class LocalPlane {
 public:
  /// Nothing if the datum is not plausible.
  static std::optional<LocalPlane> around(const Geodetic& datum);

  /// East, north, up [m] of the datum. The plane touches the ellipsoid there: 1 km away a position at equal
  /// altitude lies 8 cm below it, which leaves east and north exact.
  Eigen::Vector3d to_plane(const Geodetic& geodetic) const;
  /// Inverse of to_plane, within 1e-6 m up to 1000 km and 50 km altitude.
  Geodetic to_geodetic(const Eigen::Vector3d& east_north_up) const;

  const Geodetic& datum() const { return datum_; }

 private:
  explicit LocalPlane(const Geodetic& datum);

  Geodetic datum_;
  Eigen::Vector3d origin_;
  Eigen::Matrix3d R_plane_earth_;
};

}  // namespace bw::localization
