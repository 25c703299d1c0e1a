#include <string>

#include "components/recordings/files/log_files.hpp"
#include "components/recordings/files/log_table.hpp"

namespace bw {
namespace {

constexpr std::string_view kOdometry = "t_s,x_m,y_m,yaw_rad,v_mps,omega_radps";
constexpr std::string_view kImu =
    "t_s,qx,qy,qz,qw,yaw_rad,wx_radps,wy_radps,wz_radps,ax_mps2,ay_mps2,az_mps2,base_yaw_rad,base_wz_radps";
constexpr std::string_view kFixes = "t_s,status,lat_deg,lon_deg,alt_m,var_e_m2,var_n_m2,var_u_m2";
constexpr double kSeparation = 0.5708;  // between the wheels of the two sides, maker's robot description

std::vector<OdometrySample> read_odometry(const std::string& file) {
  std::vector<OdometrySample> samples;
  RisingStamps stamps(file);
  for (const CsvRow& row : read_csv(file, kOdometry)) {
    const auto& v = row.values;
    require_within(v[4], -20.0, 20.0, "v_mps must lie within 20 m/s of 0", file, row.line);
    require_within(v[5], -20.0, 20.0, "omega_radps must lie within 20 rad/s of 0", file, row.line);
    samples.push_back({stamps.next(v[0], row.line), {v[1], v[2], wrap_angle(v[3])}, {v[4], v[5]}});
  }
  return samples;
}

std::vector<ImuSample> read_imu(const std::string& file) {
  std::vector<ImuSample> samples;
  RisingStamps stamps(file);
  for (const CsvRow& row : read_csv(file, kImu)) {
    const auto& v = row.values;
    require_within(v[13], -20.0, 20.0, "base_wz_radps must lie within 20 rad/s of 0", file, row.line);
    samples.push_back({stamps.next(v[0], row.line), wrap_angle(v[12]), v[13], 0.0});
  }
  return samples;
}

std::vector<FixSample> read_fixes(const std::string& file) {
  std::vector<FixSample> samples;
  RisingStamps stamps(file);
  for (const CsvRow& row : read_csv(file, kFixes)) {
    const auto& v = row.values;
    const Time time = stamps.next(v[0], row.line);
    if (v[1] < 0.0) continue;  // no fix
    const FixSample sample{time, {v[2], v[3], v[4]}, {v[5], v[6], v[7]}};
    if (!localization::is_plausible(sample.place)) fail_at(file, row.line, "this is no place on earth");
    for (const double variance : {v[5], v[6], v[7]})
      require_within(variance, 1e-6, 1e6, "variances must lie in 0.000001 ... 1000000 m^2", file, row.line);
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace

RecordedDrive read_husky_log(const std::filesystem::path& folder) {
  RecordedDrive drive;
  drive.odometry = read_odometry((folder / "wheel_odom.csv").string());
  drive.imu = read_imu((folder / "imu.csv").string());
  drive.fixes = read_fixes((folder / "gps.csv").string());
  drive.wheel_separation = kSeparation;
  if (!drive.fixes.empty()) drive.datum = drive.fixes.front().place;
  return drive;
}

}  // namespace bw
