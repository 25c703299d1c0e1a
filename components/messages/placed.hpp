// The newest message of a topic, seen from a frame and a moment.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "runtime/component.hpp"
#include "runtime/stamps.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

struct Placed {
  Pose2 X_TF;        ///< the frame of the message in the one asked for
  double age = 0.0;  ///< of its stamp [s]; negative: it is later than the moment
};

/// Nothing without a message, when its frame is not connected to `target`, or when its stamp is more than
/// `timeout` [s] off.
template <class Message>
std::optional<Placed> placed(const Latest<Message>& newest, const TransformTree& transforms,
                             const std::string& target, Time time, double timeout) {
  if (!newest) return std::nullopt;
  const double age = (time - from_stamp(newest->header().stamp())).to_seconds();
  const auto X_TF = transforms.lookup_planar(target, newest->header().frame_id());
  if (!X_TF || std::abs(age) > timeout) return std::nullopt;
  return Placed{*X_TF, age};
}

}  // namespace bw
