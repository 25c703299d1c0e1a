// What a controller commanded, and what a new path did to it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>


#include "tests/interop/nav2_tree/journal.hpp"
#include "tests/interop/nav2_tree/messages.hpp"
#include "tests/interop/plain/node.hpp"

namespace nav2 {

struct Command {
  double at = 0.0;     ///< [s]
  double speed = 0.0;  ///< [m/s] forward
  double angular = 0.0;
};

inline constexpr double kDipWindow = 0.3;  ///< [s] in which a new path would show

/// By how much the speed falls below the straight line between the last command before `at` and the first one
/// a window later [m/s]; at least 0. Whoever brakes or speeds up evenly has no dip.
inline double dip(const std::vector<Command>& commands, double at) {
  const auto later = [](double time, const Command& command) { return time < command.at; };
  const auto first = std::upper_bound(commands.begin(), commands.end(), at, later);
  const auto last = std::upper_bound(first, commands.end(), at + kDipWindow, later);
  if (first == commands.begin() || last == commands.end()) return 0.0;
  const Command& from = *(first - 1);
  double deepest = 0.0;
  for (auto command = first; command != last; ++command) {
    const double share = (command->at - from.at) / (last->at - from.at);
    deepest = std::max(deepest, from.speed + share * (last->speed - from.speed) - command->speed);
  }
  return deepest;
}

/// Hears geometry_msgs/Twist.
class CommandLog {
 public:
  CommandLog(plain::Node& node, const std::string& topic)
      : reader_(node.create_reader({.topic = "rt/" + topic,
                                    .type = "geometry_msgs::msg::dds_::Twist_",
                                    .type_hash = {},
                                    .depth = 100})) {
    node.announce();
  }
  void poll(const Journal& journal) {
    Bytes bytes;
    plain::dds::SampleInfo info;
    while (bw::fast_dds::is_ok(reader_->take_next_sample(&bytes, &info))) {
      if (!info.valid_data) continue;
      CdrIn in(bytes);
      Command command{.at = journal.now(), .speed = in.number<double>()};
      for (int i = 0; i < 5; ++i) command.angular = in.number<double>();
      commands.push_back(command);
    }
  }
  std::vector<Command> commands;

 private:
  plain::dds::DataReader* reader_;
};

}  // namespace nav2
