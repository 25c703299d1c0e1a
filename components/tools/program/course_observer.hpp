// Listens to a drive and keeps what a figure of it needs: the true way, people, map and walls.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "components/evaluation/run_recorder.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Topics of the judge, by the names that the graph gives them.
struct CourseTopics {
  std::string truth = "sim/ground_truth";
  std::string status = "navigation_status";
  std::string map = "map";
  std::string true_map = "sim/map";
  std::string shapes = "sim/obstacles";
};

class CourseObserver final : public Component {
 public:
  /// `course` begins with the first goal, and is read after the run; it has the robot's size and speed from the graph.
  CourseObserver(std::shared_ptr<std::optional<RunRecorder>> course, CourseTopics topics)
      : course_(std::move(course)), topics_(std::move(topics)) {}

  void configure(Setup& setup) override;

 private:
  void hear_goals(Setup& setup);
  void hear_place(Setup& setup);

  std::shared_ptr<std::optional<RunRecorder>> course_;
  CourseTopics topics_;
  std::uint64_t goal_id_ = 0;
  bool started_ = false;
};

}  // namespace bw
