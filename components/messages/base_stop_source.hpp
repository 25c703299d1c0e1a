// Whether the base obeys, as `base_state` tells it. For adaptors only.
#pragma once

#include <optional>

#include <bandwagon_msgs/msg/base_state.hpp>

#include "components/model/base_stop.hpp"
#include "runtime/component.hpp"

namespace bw {

class BaseStopSource {
 public:
  void listen(Setup& setup) {
    state_ = setup.latest<bandwagon_msgs::msg::BaseState>("base_state", Qos::standard(), Need::optional);
  }

  /// Of a base that tells nothing, or fell silent, nothing is known.
  std::optional<BaseStop> at(Time now) const {
    namespace states = bandwagon_msgs::msg::BaseState_Constants;
    constexpr Duration kHeard = Duration::milliseconds(1000);  // it tells ten times a second
    if (!state_ || now - state_.received() > kHeard) return std::nullopt;
    const bool obeys = state_->state() < states::BACKING_OFF && !state_->is_latched();
    if (obeys) return std::nullopt;
    return BaseStop{state_->reason().empty() ? "it does not say why" : state_->reason(),
                    state_->is_latched()};
  }

 private:
  Latest<bandwagon_msgs::msg::BaseState> state_;
};

}  // namespace bw
