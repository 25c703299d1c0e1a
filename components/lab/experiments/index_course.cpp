#include "components/lab/experiments/index_course.hpp"

#include "components/evaluation/collision_index.hpp"

namespace bw {
namespace {

constexpr std::size_t kMost = 200;

}  // namespace

std::vector<Vector2> index_course(const RunRecording& recording) {
  const std::vector<RecordedMoment>& moments = recording.moments;
  const std::size_t stretch = (moments.size() + kMost - 1) / kMost;
  std::vector<Vector2> course;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Vector2 now(moments[i].time,
                      collision_index(moments[i].X_MB.position(), moments[i].people, kJudgingSigma));
    if (i % stretch == 0) {
      course.push_back(now);
    } else if (now.y() > course.back().y()) {
      course.back() = now;
    }
  }
  return course;
}

}  // namespace bw
