// Listens to a drive and keeps what a figure of it needs: the true path, people, map and walls.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <bandwagon_msgs/msg/ground_truth.hpp>

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

/// Fills a recorder from within a component.
class CourseListener {
 public:
  /// `course` begins with the first goal, and is read after the run; it has the robot's size, speed and
  /// limits from the graph.
  CourseListener(std::shared_ptr<std::optional<RunRecorder>> course, CourseTopics topics)
      : course_(std::move(course)), topics_(std::move(topics)) {}

  /// Goals and what stands about. Who calls it hears the truth, and passes it on.
  void listen(Setup& setup);
  void on_truth(const bandwagon_msgs::msg::GroundTruth& truth);
  const CourseTopics& topics() const { return topics_; }

 private:
  void hear_goals(Setup& setup);
  void hear_map(Setup& setup);

  std::shared_ptr<std::optional<RunRecorder>> course_;
  CourseTopics topics_;
  std::uint64_t goal_id_ = 0;
  bool started_ = false;
};

/// A component that does nothing else.
class CourseObserver final : public Component {
 public:
  CourseObserver(std::shared_ptr<std::optional<RunRecorder>> course, CourseTopics topics)
      : listener_(std::move(course), std::move(topics)) {}

  void configure(Setup& setup) override;

 private:
  CourseListener listener_;
};

}  // namespace bw
