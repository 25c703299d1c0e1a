// A value of a status in a diagnostic array.
#pragma once

#include <string>
#include <utility>

#include <diagnostic_msgs/msg/diagnostic_status.hpp>

namespace bw {

inline void add_value(diagnostic_msgs::msg::DiagnosticStatus& status, std::string key, std::string value) {
  diagnostic_msgs::msg::KeyValue pair;
  pair.key(std::move(key));
  pair.value(std::move(value));
  status.values().push_back(std::move(pair));
}

}  // namespace bw
