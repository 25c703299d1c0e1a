// Where sensors sit on the robot, by /tf_static.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>

#include "runtime/base/pose2.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

class SensorMounts {
 public:
  SensorMounts() = default;
  SensorMounts(Setup& setup, std::shared_ptr<const TransformTree> transforms)
      : base_frame_(setup.frame("base_link")), transforms_(std::move(transforms)), log_(setup.log()) {}

  /// X_BS, the sensor in base_link; base_link itself for a frame that nobody placed, said once.
  Pose2 of(const std::string& frame);

 private:
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Logger log_;
  std::set<std::string> unplaced_;
};

}  // namespace bw
