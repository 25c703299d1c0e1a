// What a walk over all messages of a bag tells of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/recording/bag/bag.hpp"

namespace bw::bag {

struct TopicReport {
  std::string name;
  std::string type;
  std::string writer;      ///< node, where the bag tells
  std::string difference;  ///< why messages of a type that is known here are not decoded; empty: they are
  std::uint64_t count = 0;
  std::uint64_t bytes = 0;
  Time first;  ///< log time
  Time last;
  Duration longest_gap{};       ///< between two messages that follow each other
  Time longest_gap_at;          ///< where it begins
  std::uint64_t falling = 0;    ///< messages whose own stamp is older than the one before
  Time first_falling;           ///< log time of the first of them
  std::uint64_t malformed = 0;  ///< messages that are not of their type, as far as the type is known here
  std::string first_malformed;  ///< what is wrong with the first of them

  /// Messages per second; 0 for fewer than two.
  [[nodiscard]] double rate() const;
};

/// The recorder's clock and the stamps of the messages moved against each other.
struct ClockJump {
  Time at;      ///< log time
  Duration by;  ///< positive: the stamps fell behind
};

struct BagReport {
  std::vector<TopicReport> topics;
  std::vector<BagFault> faults;  ///< of the file, found at opening and while reading
  std::vector<ClockJump> clock_jumps;
  [[nodiscard]] bool is_sound() const;
};

/// Reads every message. Stamps and log times that move apart by more than `jump` from one message of a topic
/// to the next are a jump of a clock.
[[nodiscard]] BagReport examine(const Bag& bag, Duration jump = Duration::milliseconds(1000));

}  // namespace bw::bag
