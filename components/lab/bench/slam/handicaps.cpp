#include "components/lab/bench/slam/handicaps.hpp"

#include <cmath>

#include "components/model/sweep_motion.hpp"

namespace bw::slam {

void scale_odometry(RecordedDrive& drive, double scale) {
  if (drive.odometry.empty()) return;
  Pose2 before = drive.odometry.front().X_OB;
  Pose2 scaled = before;
  for (OdometrySample& sample : drive.odometry) {
    const Pose2 step = inverse(before) * sample.X_OB;
    before = sample.X_OB;
    scaled = scaled * pose_between({}, step, scale);  // beyond the step, on its arc
    sample.X_OB = scaled;
    sample.twist = {scale * sample.twist.v, scale * sample.twist.omega};
  }
}

void thin_out_scans(RecordedDrive& drive, std::size_t every) {
  std::size_t n = 0;
  std::erase_if(drive.scans, [&n, every](const ScanSample&) { return n++ % every != 0; });
}

void narrow_view(RecordedDrive& drive, double view) {
  constexpr double kRounding = 1e-4;  // [rad] angles of a message are floats
  for (ScanSample& scan : drive.scans) {
    ScanGeometry& g = scan.geometry;
    const auto angle = [&g](std::size_t i) {
      return static_cast<double>(g.angle_min) +
             static_cast<double>(g.angle_increment) * static_cast<double>(i);
    };
    std::size_t first = scan.ranges.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      if (std::abs(angle(i)) > 0.5 * view + kRounding) continue;
      if (count++ == 0) first = i;
    }
    const auto begin = scan.ranges.begin() + static_cast<std::ptrdiff_t>(first);
    scan.ranges.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    scan.intensities.clear();
    // Its first beam is taken later.
    scan.time =
        scan.time + Duration::seconds(static_cast<double>(g.time_increment) * static_cast<double>(first));
    g.angle_min = static_cast<float>(angle(first));
    g.angle_max = g.angle_min + g.angle_increment * static_cast<float>(count == 0 ? 0 : count - 1);
  }
  std::erase_if(drive.scans, [](const ScanSample& scan) { return scan.ranges.empty(); });
}

}  // namespace bw::slam
