#include "components/people/tracker/matching.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace bw::people {
namespace {

/// Symmetric 2 x 2.
struct Spread {
  double xx, xy, yy;
  double determinant() const { return xx * yy - xy * xy; }
  double squared_distance(const Vector2& d) const {
    return (yy * d.x() * d.x() - 2.0 * xy * d.x() * d.y() + xx * d.y() * d.y()) / determinant();
  }
};

}  // namespace

void Matching::match(const std::vector<Detection>& detections, const std::vector<PersonTrack>& people,
                     const std::vector<ClusterTrack>& clusters, double now,
                     const AssociationOptions& options) {
  likeness_.clear();
  for (const Detection& d : detections)
    likeness_.push_back(-std::log(std::clamp(d.human_score(), 0.02, 1.0)));

  assignment_.begin(detections.size());
  const double slack = options.kSlack * options.kSlack;
  const auto offer = [&](const Vector2& expected, const Eigen::Matrix2d& spread, double reach, bool person) {
    assignment_.add_row(options.gate);
    for (std::size_t j = 0; j < detections.size(); ++j) {
      const Detection& d = detections[j];
      const Vector2 miss = d.position - expected;
      if (miss.squaredNorm() > reach * reach) continue;
      const Spread s{spread(0, 0) + d.covariance(0, 0) + slack, spread(0, 1) + d.covariance(0, 1),
                     spread(1, 1) + d.covariance(1, 1) + slack};
      const double distance = s.squared_distance(miss);
      if (distance > options.gate) continue;
      const Spread best{d.covariance(0, 0) + slack, d.covariance(0, 1), d.covariance(1, 1) + slack};
      const double vague = std::log(s.determinant() / best.determinant());
      assignment_.allow(j,
                        distance + vague +
                            (person ? options.kUnlike * likeness_[j] + (d.on_static ? options.kOnStatic : 0.0)
                                    : options.kPeopleFirst));
    }
  };
  const auto reach_after = [&](double seconds) {
    return std::min(options.kReach, options.kStep + options.kPace * seconds);
  };
  for (const PersonTrack& person : people) {
    for (const auto& [leg, unseen] : {std::pair{BodyPart::first_leg, person.unseen[0]},
                                      std::pair{BodyPart::second_leg, person.unseen[1]}})
      offer(person.walker.expected(leg), person.walker.spread(leg), reach_after(unseen), true);
  }
  for (const ClusterTrack& cluster : clusters)
    offer(cluster.position(), cluster.variance() * Eigen::Matrix2d::Identity(),
          reach_after(now - cluster.last().time), false);

  const std::vector<int>& chosen = assignment_.solve();
  taken_.assign(detections.size(), 0);
  for (const int j : chosen)
    if (j >= 0) taken_[static_cast<std::size_t>(j)] = 1;
  people_.clear();
  for (std::size_t i = 0; i < people.size(); ++i) people_.push_back({chosen[2 * i], chosen[2 * i + 1]});
  clusters_.assign(chosen.begin() + static_cast<std::ptrdiff_t>(2 * people.size()), chosen.end());
}

}  // namespace bw::people
