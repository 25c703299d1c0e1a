// Walls of a submap that is finished: nothing changes them any more, so whoever copies it shares them.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "components/slam/surface_map.hpp"

namespace bw::slam {

/// A list of surfaces, to be read as one; copied in constant time. Copies may be read by several threads.
class FinishedWalls {
 public:
  FinishedWalls() : FinishedWalls(std::vector<Surface>{}) {}
  FinishedWalls(std::vector<Surface> surfaces)
      : surfaces_(std::make_shared<const std::vector<Surface>>(std::move(surfaces))) {}

  operator const std::vector<Surface>&() const { return *surfaces_; }
  auto begin() const { return surfaces_->begin(); }
  auto end() const { return surfaces_->end(); }
  const Surface* data() const { return surfaces_->data(); }
  std::size_t size() const { return surfaces_->size(); }
  bool empty() const { return surfaces_->empty(); }

 private:
  std::shared_ptr<const std::vector<Surface>> surfaces_;
};

}  // namespace bw::slam
