#include "components/emulators/adaptor/true_body.hpp"

#include <utility>

#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/obstacles.hpp"

namespace bw {

TrueBody::TrueBody(Setup& setup, double radius, double bumper_gap, std::vector<emulators::Beam> beams)
    : radius_(radius), bumper_gap_(bumper_gap), beams_(std::move(beams)) {
  truth_ = setup.latest<bandwagon_msgs::msg::GroundTruth>("sim/ground_truth", Qos::standard());
  setup.input<bandwagon_msgs::msg::Obstacles>("sim/obstacles", Qos::latched(),
                                              [this](const auto& message, const Tick&) {
                                                shapes_ = to_obstacles(message, Pose2{});
                                                rebuild();
                                              });
  setup.input<nav_msgs::msg::OccupancyGrid>(
      "sim/map", Qos::latched(),
      [this](const auto& message, const Tick&) {
        OccupancyGrid grid;
        if (!read_grid(message, grid).empty()) return;
        map_ = std::move(grid);
        rebuild();
      },
      Need::optional);
}

void TrueBody::rebuild() { scene_ = StaticScene(shapes_, map_); }

emulators::Body TrueBody::now() const {
  emulators::Body body{.left_ticks = left_, .right_ticks = right_};
  if (!truth_) return body;
  const Pose2 pose = from_pose(truth_->pose());
  body.twist = {truth_->twist().linear().x(), truth_->twist().angular().z()};
  std::vector<Disc> people;
  for (const auto& person : truth_->people())
    people.push_back({{person.position().x(), person.position().y()}, person.radius()});
  body.contacts = emulators::touched(pose, radius_, bumper_gap_, scene_, people);
  for (const emulators::Beam& beam : beams_)
    body.ranges.push_back(emulators::range_of(beam, pose, scene_, people));
  return body;
}

}  // namespace bw
