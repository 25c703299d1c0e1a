// A recorded drive made harder: what a base or a scanner of less quality would have recorded.
#pragma once

#include <cstddef>

#include "components/recordings/recorded_drive.hpp"

namespace bw::slam {

/// Each step of odometry, travel and turn, times `scale`: as with wheels of which all sizes are taken wrong.
void scale_odometry(RecordedDrive& drive, double scale);

/// Keeps the first of `every` scans, and so on.
void thin_out_scans(RecordedDrive& drive, std::size_t every);

/// Keeps beams no farther from the scanner's axis than half of `view` [rad]; a scan without any is gone.
void narrow_view(RecordedDrive& drive, double view);

}  // namespace bw::slam
