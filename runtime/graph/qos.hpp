// Quality of service of a topic end, as ROS 2's rmw profiles give it. What we publish is reliable, so that
// rviz2's default displays match; what we read from sensors is best effort.
#pragma once

#include <optional>

#include "runtime/base/time.hpp"

namespace bw {

enum class Reliability { best_effort, reliable };
enum class Durability { volatile_, transient_local };

struct Qos {
  Reliability reliability = Reliability::reliable;
  Durability durability = Durability::volatile_;
  int depth = 10;  ///< KEEP_LAST depth
  std::optional<Duration> lifespan = std::nullopt;

  static Qos standard(int depth = 10) { return {.depth = depth}; }
  static Qos sensor() { return {.reliability = Reliability::best_effort, .depth = 5}; }
  static Qos latched() { return {.durability = Durability::transient_local, .depth = 1}; }
  static Qos command() { return {.depth = 1}; }
  static Qos tf() { return {.depth = 100}; }
  static Qos tf_static() { return {.durability = Durability::transient_local, .depth = 100}; }
  static Qos clock() { return {.reliability = Reliability::best_effort, .depth = 1}; }
  static Qos rosout() {
    return {
        .durability = Durability::transient_local, .depth = 1000, .lifespan = Duration::milliseconds(10'000)};
  }
  bool operator==(const Qos&) const = default;
};

/// A writer's offer satisfies a reader's request when it is at least as strong in both.
inline bool is_compatible(const Qos& offered, const Qos& requested) {
  return offered.reliability >= requested.reliability && offered.durability >= requested.durability;
}

}  // namespace bw
