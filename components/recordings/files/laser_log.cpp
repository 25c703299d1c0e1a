#include <string>

#include "components/recordings/files/log_files.hpp"
#include "components/recordings/files/log_table.hpp"

namespace bw {
namespace {

constexpr int kBeams = 512;
// Of the scanner, as the log's description gives them.
constexpr ScanGeometry kGeometry{.angle_min = -1.570796,
                                 .angle_increment = 0.006135923,
                                 .range_min = 0.02,
                                 .range_max = 5.6,
                                 .period = 0.1};

}  // namespace

RecordedDrive read_laser_log(const std::filesystem::path& folder) {
  const std::string file = (folder / "scans.csv").string();
  std::string header = "t_s";
  for (int beam = 0; beam < kBeams; ++beam) header += ",r" + std::to_string(beam);
  RecordedDrive drive;
  drive.scan_geometry = kGeometry;
  RisingStamps stamps(file);
  for (const CsvRow& row : read_csv(file, header, CsvNumbers::or_infinite)) {
    ScanSample scan{stamps.next(row.values[0], row.line), {}};
    scan.ranges.reserve(kBeams);
    for (int beam = 1; beam <= kBeams; ++beam) {
      const double range = row.values[static_cast<std::size_t>(beam)];
      if (range < 0.0) fail_at(file, row.line, "a range cannot be negative");
      scan.ranges.push_back(static_cast<float>(range));
    }
    drive.odometry.push_back({scan.time, {}, {}});  // the robot stands
    drive.scans.push_back(std::move(scan));
  }
  return drive;
}

}  // namespace bw
