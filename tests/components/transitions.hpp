// Asks for transitions of a component at set times, from the script of a rig.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <lifecycle_msgs/srv/change_state.hpp>

#include "tests/components/component_rig.hpp"

namespace bw {

/// {{1.0, "deactivate"}, ...}: seconds after the start, at whole hundredths.
inline void change_states(Setup& setup, const std::string& node,
                          std::vector<std::pair<double, std::string>> transitions) {
  using lifecycle_msgs::srv::ChangeState;
  setup.every(Duration::milliseconds(10), "transitions of " + node,
              [transitions = std::move(transitions),
               client = setup.client<ChangeState>("/" + node + "/change_state", Need::optional)](
                  const Tick& tick) mutable {
                for (const auto& [t, label] : transitions) {
                  if (std::abs(seconds_since_start(tick.now) - t) > 0.001) continue;
                  ChangeState::Request request;
                  request.transition().label(label);
                  client.call(request, Duration::milliseconds(1000),
                              [label](const ChangeState::Response* response, const Tick&) {
                                EXPECT_TRUE(response != nullptr && response->success()) << label;
                              });
                }
              });
}

}  // namespace bw
