// The keep-out zones that are told on topic `keepout_filter_mask`, as Nav2's map_server serves them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/mapping/keepout_zones.hpp"
#include "components/messages/grid.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

/// Lives in the component whose setup it is given. Without a mask nothing is kept out; one that is of no use
/// changes nothing, and log and diagnostics say why.
class KeepoutMask {
 public:
  /// `on_change` is called with each mask that is used.
  void listen(Setup& setup, std::shared_ptr<const TransformTree> transforms,
              std::function<void(const Tick&)> on_change = {}) {
    transforms_ = std::move(transforms);
    on_change_ = std::move(on_change);
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    zones_ = {};
    frame_.clear();
    setup.input<nav_msgs::msg::OccupancyGrid>(
        kTopic, Qos::latched(), [this](const auto& message, const Tick& tick) { take(message, tick); },
        Need::optional);
  }

  /// Why it is not known where in `frame` the zones are; empty: it is, or there are none. Told in the log
  /// once.
  std::string fault(const std::string& frame) {
    const std::string why =
        zones_.empty() || X_KF(frame)
            ? std::string()
            : "the keep-out zones are in frame '" + frame_ + "', which no transform joins to '" + frame + "'";
    if (unplaced_.is_news(why) && unplaced_) log_.warn("{}", why);
    return why;
  }

  // The rest does nothing while it is not known where the zones are.

  void mark(OccupancyGrid& grid, const std::string& frame) const {
    if (zones_.empty()) return;
    if (const auto X = X_KF(frame)) zones_.mark(grid, *X);
  }
  void add_to(StaticObstacles& obstacles, const Vector2& position, const std::string& frame,
              const ExtractionOptions& options) const {
    if (zones_.empty()) return;
    if (const auto X = X_KF(frame)) zones_.add_to(obstacles, position, *X, options);
  }
  bool hold(const Vector2& point, const std::string& frame) const {
    if (zones_.empty()) return false;
    const auto X = X_KF(frame);
    return X && zones_.hold(*X * point);
  }
  /// The zones are not fixed to `frame`: they may move in it.
  bool is_elsewhere(const std::string& frame) const { return !zones_.empty() && frame_ != frame; }

 private:
  static constexpr const char* kTopic = "keepout_filter_mask";

  std::optional<Pose2> X_KF(const std::string& frame) const {
    if (frame == frame_) return Pose2{};
    return transforms_->lookup_planar(frame_, frame);
  }

  void take(const nav_msgs::msg::OccupancyGrid& message, const Tick& tick) {
    OccupancyGrid mask;
    std::string fault = read_grid(message, mask);
    if (fault.empty() && message.header().frame_id().empty()) fault = "it names no frame";
    if (fault.empty()) fault = zones_.set_mask(mask);
    diagnostics_->set_value(kTopic, fault.empty() ? "as told" : "refused, the one before stays: " + fault);
    if (!fault.empty()) return log_.error("a mask on {} is refused, the one before stays: {}", kTopic, fault);
    frame_ = message.header().frame_id();
    if (on_change_) on_change_(tick);
  }

  std::shared_ptr<const TransformTree> transforms_;
  std::function<void(const Tick&)> on_change_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  KeepoutZones zones_;
  std::string frame_;  ///< of the mask
  Complaint unplaced_;
};

}  // namespace bw
