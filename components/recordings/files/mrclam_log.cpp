#include <algorithm>
#include <string>

#include "components/recordings/files/log_files.hpp"
#include "components/recordings/files/log_table.hpp"

namespace bw {
namespace {

constexpr std::string_view kOdometry = "t_s,v_mps,omega_radps";
constexpr std::string_view kTruth = "t_s,x_m,y_m,yaw_rad";
constexpr double kSeparation = 0.258;                           // iRobot Create, maker's data sheet [m]
constexpr Duration kLongestStep = Duration::milliseconds(100);  // a command may be held for a second

std::vector<OdometrySample> read_odometry(const std::string& file) {
  std::vector<OdometrySample> samples;
  RisingStamps stamps(file);
  Twist2 held;
  for (const CsvRow& row : read_csv(file, kOdometry)) {
    const auto& v = row.values;
    const Time time = stamps.next(v[0], row.line);
    require_within(v[1], -20.0, 20.0, "v_mps must lie within 20 m/s of 0", file, row.line);
    require_within(v[2], -20.0, 20.0, "omega_radps must lie within 20 rad/s of 0", file, row.line);
    if (samples.empty()) {
      samples.push_back({time, {}, {}});
    } else {
      require_within((time - samples.back().time).to_seconds(), 0.0, 60.0,
                     "a command cannot hold for more than 60 s", file, row.line);
    }
    while (samples.back().time < time)
      samples.push_back(advance(samples.back(), held, std::min(time, samples.back().time + kLongestStep)));
    held = {v[1], v[2]};
  }
  return samples;
}

std::vector<ReferencePose> read_truth(const std::string& file) {
  std::vector<ReferencePose> truth;
  RisingStamps stamps(file);
  for (const CsvRow& row : read_csv(file, kTruth)) {
    const auto& v = row.values;
    for (const double position : {v[1], v[2]})
      require_within(position, -1e5, 1e5, "positions must lie within 100000 m of the origin", file, row.line);
    truth.push_back({stamps.next(v[0], row.line), {v[1], v[2]}, wrap_angle(v[3])});
  }
  return truth;
}

}  // namespace

RecordedDrive read_mrclam_log(const std::filesystem::path& folder) {
  RecordedDrive drive;
  drive.odometry = read_odometry((folder / "odometry.csv").string());
  drive.truth = read_truth((folder / "groundtruth_10hz.csv").string());
  drive.wheel_separation = kSeparation;
  return drive;
}

}  // namespace bw
