#include "components/people/tracker/external_detections.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "components/people/tracker/assignment.hpp"
#include "components/people/tracker/gait.hpp"

namespace bw::people {
namespace {

bool is_usable(const HeardPerson& person) {
  return person.position.allFinite() && person.velocity.allFinite() && person.reliability >= 0.0 &&
         person.reliability <= 1.0;
}

Eigen::Matrix2d isotropic(double deviation) { return deviation * deviation * Eigen::Matrix2d::Identity(); }

}  // namespace

std::vector<HeardPerson> without_doubles(std::vector<HeardPerson> heard, double apart) {
  std::erase_if(heard, [](const HeardPerson& person) { return !is_usable(person); });
  std::ranges::stable_sort(heard, std::ranges::greater{}, &HeardPerson::reliability);
  std::vector<HeardPerson> kept;
  for (HeardPerson& person : heard) {
    const auto is_same = [&](const HeardPerson& other) {
      return (other.position - person.position).norm() < apart;
    };
    if (std::ranges::none_of(kept, is_same)) kept.push_back(std::move(person));
  }
  return kept;
}

std::vector<int> match_heard(const std::vector<HeardPerson>& heard, const std::vector<PersonTrack>& people,
                             double late, double deviation, const AssociationOptions& options) {
  Assignment assignment;
  assignment.begin(people.size());
  for (const HeardPerson& told : heard) {
    assignment.add_row(options.gate);
    for (std::size_t i = 0; i < people.size(); ++i) {
      const Vector2 miss = told.position - people[i].walker.position() + late * people[i].walker.velocity();
      if (miss.norm() > options.kReach) continue;
      const Eigen::Matrix2d S =
          people[i].walker.spread(BodyPart::middle) + isotropic(deviation) + isotropic(options.kSlack);
      const double distance = miss.dot(S.ldlt().solve(miss));
      if (distance <= options.gate) assignment.allow(i, distance);
    }
  }
  return assignment.solve();
}

double believed(double belief, double reliability, const ExternalDetectionOptions& options) {
  return 1.0 - (1.0 - belief) * (1.0 - options.kTrust * reliability);
}

NearLegs legs_near(const Vector2& position, double now, const std::vector<ClusterTrack>& clusters,
                   const ExternalDetectionOptions& options) {
  std::vector<int> near;
  const double reach = 2.0 * options.kPositionDeviation;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Sighting& last = clusters[i].last();
    if (now - last.time <= options.kSeen && last.human_score() >= options.kLegScore &&
        (clusters[i].position() - position).norm() <= reach)
      near.push_back(static_cast<int>(i));
  }
  const auto at = [&](int i) -> const ClusterTrack& { return clusters[static_cast<std::size_t>(i)]; };
  NearLegs best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < near.size(); ++k) {
    for (std::size_t l = k + 1; l < near.size(); ++l) {
      const ClusterTrack& a = at(near[k]);
      const ClusterTrack& b = at(near[l]);
      if ((a.position() - b.position()).norm() > BirthOptions::kStandingSeparation) continue;
      const double miss = ((a.position() + b.position()) / 2.0 - position).norm();
      if (miss >= least || CommonSightings(a, b).count == 0) continue;
      least = miss;
      best = {near[k], near[l]};
    }
  }
  if (best.first >= 0) return best;
  for (const int i : near) {
    const double miss = (at(i).position() - position).norm();
    if (miss >= least) continue;
    least = miss;
    best = {i, -1};
  }
  return best;
}

PersonTrack person_of(const HeardPerson& heard, double deviation, Time now, const TrackerOptions& options) {
  const bool is_told = heard.velocity.squaredNorm() > 0.0;
  const double speed =
      is_told ? ExternalDetectionOptions::kToldSpeed : ExternalDetectionOptions::kUntoldSpeed;
  PersonTrack person{.walker = Walker(options.walker, BodyPart::middle, heard.position, heard.velocity,
                                      deviation * deviation, speed * speed),
                     .born = now,
                     .confirmed = now,
                     .last_seen = now - Duration::seconds(options.hidden.kRemembered),
                     .score = 0.0};
  person.existence.prior = Existence::kUnseen;
  Eigen::Vector4d motion;
  motion << person.walker.position(), person.walker.velocity();
  person.heading = HeadingFilter(motion, person.walker.covariance(), options.heading);
  return person;
}

void correct_by(const HeardPerson& heard, double deviation, const TrackerOptions& options,
                PersonTrack& person) {
  person.heading.correct({heard.position, isotropic(deviation)}, options.heading);
  person.walker.correct(BodyPart::middle, heard.position, isotropic(deviation), options.walker);
}

}  // namespace bw::people
