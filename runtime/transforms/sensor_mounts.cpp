#include "runtime/transforms/sensor_mounts.hpp"

namespace bw {

Pose2 SensorMounts::of(const std::string& frame) {
  if (frame.empty() || frame == base_frame_) return {};
  if (const auto X_BS = transforms_->lookup_planar(base_frame_, frame)) return *X_BS;
  if (unplaced_.insert(frame).second)
    log_.warn("nobody says where '{}' sits on '{}': taken as at it", frame, base_frame_);
  return {};
}

}  // namespace bw
