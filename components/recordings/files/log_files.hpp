// Logs of real robots on disk, as values. Every reader takes the folder of the log and throws
// std::runtime_error ("file:line: what is wrong") for a file that cannot be read, a missing column, what is
// not a number, stamps that do not rise, and values that no sensor of that kind gives.
#pragma once

#include <filesystem>

#include "components/recordings/recorded_drive.hpp"

namespace bw {

/// Clearpath Husky outdoors: wheel_odom.csv (vendor's odometry, 10 Hz), imu.csv (heading and turn rate in
/// robot axes, 30 Hz), gps.csv (WGS 84 with variances, 2.5 Hz). The datum is the first fix.
RecordedDrive read_husky_log(const std::filesystem::path& folder);

/// iRobot Create of the UTIAS MRCLAM collection (Leung et al., IJRR 2011): odometry.csv (velocity commands,
/// each held until the next; samples at least every 0.1 s), groundtruth_10hz.csv (motion capture).
RecordedDrive read_mrclam_log(const std::filesystem::path& folder);

/// Small robot among four radio anchors (Labyrinth dataset, TU Chemnitz): Indoor_UWB_Input.txt (wheel speeds
/// and ranges, declared variances), Indoor_UWB_GT.txt (positions).
RecordedDrive read_labyrinth_log(const std::filesystem::path& folder);

/// Laser scanner of a standing robot: scans.csv, 512 beams, 10 Hz. The odometry says that it stands.
RecordedDrive read_laser_log(const std::filesystem::path& folder);

}  // namespace bw
