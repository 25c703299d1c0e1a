// A predicted position of a track as a message. For adaptors only.
#pragma once

#include <bandwagon_msgs/msg/predicted_position.hpp>

#include "components/model/obstacles.hpp"
#include "runtime/stamps.hpp"

namespace bw {

inline bandwagon_msgs::msg::PredictedPosition to_message(const PredictedPosition& prediction) {
  bandwagon_msgs::msg::PredictedPosition message;
  message.time_from_start(to_message(Duration::seconds(prediction.time)));
  message.x(prediction.position.x());
  message.y(prediction.position.y());
  message.cov_xx(prediction.covariance(0, 0));
  message.cov_xy(prediction.covariance(0, 1));
  message.cov_yy(prediction.covariance(1, 1));
  return message;
}

}  // namespace bw
