// A bag as a drive: whatever robot recorded it, and whatever tables it was made of.
#pragma once

#include <string>
#include <vector>

#include "components/recordings/drive_topics.hpp"
#include "components/recordings/files/log_record.hpp"
#include "components/recordings/recorded_drive.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw {

struct BagDrive {
  RecordedDrive drive;
  LogRecord log;
  Time start;                         ///< stamp that those of the drive count from
  std::vector<std::string> left_out;  ///< sentences: what of the bag is not in the drive, and how much
};

/// Of a base, for a bag that declares none. 0: not known.
struct WheelSizes {
  double separation = 0.0;  ///< [m]
  double radius = 0.0;      ///< [m]
};

/// Stamps are those of the messages (of the recorder where a message has none), counted from the log's start
/// that the bag tells, else from the first one. Without odometry it is the sum of the commands, in steps of
/// 0.1 s, or of the wheels' speeds. Wheel separation, radius and variance are those that the bag declares,
/// else those of `wheels`. `path` is for messages.
///
/// Throws std::runtime_error: a topic of another type than it must have, a topic that was named and is not
/// there, no topic of a drive at all, wheels of unknown size, a command other than zero that holds for more
/// than a minute.
BagDrive drive_of_bag(const bag::Bag& bag, const DriveTopics& topics, const std::string& path,
                      const WheelSizes& wheels = {});

}  // namespace bw
