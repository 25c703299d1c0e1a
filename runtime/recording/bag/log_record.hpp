// The metadata record of a bag that was made of tables, by `bag import`.
#pragma once

namespace bw::bag {

/// Its fields: name, source, licence, columns (the columns file), tables, start [s], and what the log
/// declares of the robot.
inline constexpr const char* kLogRecord = "log";

}  // namespace bw::bag
