// The body of an emulated base, kept from what the simulated world publishes. For the adaptor only.
#pragma once

#include <optional>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/emulators/surroundings.hpp"
#include "runtime/component.hpp"

namespace bw {

class TrueBody {
 public:
  TrueBody(Setup& setup, double radius, double bumper_gap, std::vector<emulators::Beam> beams);

  void count(std::int32_t left, std::int32_t right) {
    left_ = left;
    right_ = right;
  }
  emulators::Body now() const;

 private:
  void rebuild();

  double radius_, bumper_gap_;
  std::vector<emulators::Beam> beams_;
  std::int32_t left_ = 0, right_ = 0;
  StaticObstacles shapes_;
  std::optional<OccupancyGrid> map_;
  StaticScene scene_{{}, std::nullopt};
  Latest<bandwagon_msgs::msg::GroundTruth> truth_;
};

}  // namespace bw
