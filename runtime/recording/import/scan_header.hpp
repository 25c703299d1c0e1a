// What the header of a scan says follows from the rest of it: its beams are those of the row.
#pragma once

#include <vector>

#include "runtime/recording/import/columns_file.hpp"
#include "runtime/recording/import/message_draft.hpp"

namespace bw::imports {

/// Of a sensor_msgs/LaserScan: angle_max from angle_min, angle_increment and the number of ranges, or
/// angle_increment from the two angles, whichever no rule gives.
void complete_scan(const std::vector<ValueRule>& rules, MessageDraft& scan);

}  // namespace bw::imports
