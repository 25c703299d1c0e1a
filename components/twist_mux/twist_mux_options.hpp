// Who may drive, and who goes first.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/field.hpp"

namespace bw {

struct TwistSourceOptions {
  std::string topic = "cmd_vel";
  std::int64_t priority = 0;
  double timeout = 0.2;
  double max_age = 0.5;
  bool hand = false;
  bool stamped = false;
  bool optional = false;

  template <class Visitor>
  void fields(Visitor& v) {
    v("topic", topic, {.doc = "where its commands come from; remap and inputs of the graph use this name"});
    v("priority", priority, {.min = 0, .max = 255, .doc = "the highest one that speaks drives"});
    v("timeout", timeout,
      {.unit = "s",
       .min = 0.02,
       .max = 1,
       .doc = "the robot stops when it has been silent for so long; at least two periods of its commands"});
    v("max_age", max_age,
      {.unit = "s",
       .min = 0.05,
       .max = 5,
       .doc = "stamped commands that are older when they come are refused"});
    v("hand", hand, {.doc = "a person drives: whom it takes over from waits for a release"});
    v("stamped", stamped, {.doc = "geometry_msgs/TwistStamped instead of geometry_msgs/Twist"});
    v("optional", optional, {.doc = "a graph in which nobody publishes it is none the worse"});
  }
};

struct TwistMuxOptions {
  std::vector<TwistSourceOptions> sources = {
      {.topic = "cmd_vel_teleop", .priority = 100, .timeout = 0.2, .hand = true},
      {.topic = "cmd_vel_teleop_stamped", .priority = 90, .timeout = 0.2, .hand = true, .stamped = true},
      {.topic = "cmd_vel_behavior", .priority = 50, .timeout = 0.25, .optional = true},
      {.topic = "cmd_vel_nav", .priority = 10, .timeout = 0.5},
  };

  template <class Visitor>
  void fields(Visitor& v) {
    v("sources", sources, {.doc = "who may drive"});
  }
  std::optional<std::string> violated_rule() const {
    if (sources.empty()) return "sources must hold at least one";
    for (auto a = sources.begin(); a != sources.end(); ++a) {
      for (auto b = sources.begin(); b != a; ++b) {
        if (a->topic == b->topic)
          return "sources must have topics of their own: " + a->topic + " is there twice";
        if (a->priority == b->priority)
          return "sources must have priorities of their own: " + b->topic + " and " + a->topic +
                 " have the same";
      }
    }
    return std::nullopt;
  }
};

}  // namespace bw
