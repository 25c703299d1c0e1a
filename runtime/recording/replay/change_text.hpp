// The outputs of a replay as text that a person can review and that any CPU type and build gives again:
// numbers to three decimals, long lists by their least, mean and largest value, at most one message of a
// topic in a period.
//
//   /cmd_vel_nav geometry_msgs/msg/Twist
//     1.050 linear.x=0.2 angular.z=-0.013
//
// What is zero, empty or a stamp is left out, and so are pictures (visualization_msgs).
#pragma once

#include <map>
#include <string>

#include "runtime/base/time.hpp"
#include "runtime/recording/bag/bytes.hpp"

namespace bw::replay {

class ChangeText {
 public:
  /// Times are counted from `start`.
  explicit ChangeText(Time start) : start_(start) {}

  void add(const std::string& topic, const std::string& type, Time time, bag::BytesView cdr);
  /// By topic, in the order of names.
  [[nodiscard]] std::string text() const;

 private:
  struct Topic {
    std::string lines;
    std::int64_t last_period = -1;
  };
  Time start_;
  std::map<std::string, Topic> topics_;
};

}  // namespace bw::replay
