// Listens to a drive and keeps what a figure of it needs: the true way, people, map and walls.
#pragma once

#include <memory>
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
  /// The recording begins with the first goal. `recorder` is read after the run.
  CourseObserver(std::shared_ptr<RunRecorder> recorder, CourseTopics topics)
      : recorder_(std::move(recorder)), topics_(std::move(topics)) {}

  void configure(Setup& setup) override;

 private:
  void hear_goals(Setup& setup);
  void hear_place(Setup& setup);

  std::shared_ptr<RunRecorder> recorder_;
  CourseTopics topics_;
  std::string goal_id_;
  bool started_ = false;
};

}  // namespace bw
