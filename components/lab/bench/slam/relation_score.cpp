#include "components/lab/bench/slam/relation_score.hpp"

#include <algorithm>
#include <cmath>

namespace bw::slam {
namespace {

class Moments {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  std::size_t count() const { return count_; }
  double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
  double deviation() const {
    if (count_ == 0) return 0.0;
    return std::sqrt(std::max(0.0, squares_ / static_cast<double>(count_) - mean() * mean()));
  }

 private:
  std::size_t count_ = 0;
  double sum_ = 0.0;
  double squares_ = 0.0;
};

}  // namespace

Pose2 error_of(const Relation& relation, const Pose2& X_from, const Pose2& X_to) {
  return inverse(relation.X) * (inverse(X_from) * X_to);
}

RelationErrors errors_of(const std::vector<Relation>& relations,
                         const std::function<std::optional<Pose2>(Time)>& pose_at) {
  Moments translation;
  Moments rotation;
  for (const Relation& relation : relations) {
    const std::optional<Pose2> from = pose_at(relation.from);
    const std::optional<Pose2> to = pose_at(relation.to);
    if (!from || !to) continue;
    const Pose2 error = error_of(relation, *from, *to);
    translation.add(error.position().norm());
    rotation.add(std::abs(error.theta));
  }
  return {translation.count(), translation.mean(), translation.deviation(), rotation.mean(),
          rotation.deviation()};
}

}  // namespace bw::slam
