#include "components/local_planner/teb/association.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/teb/narrow_passage.hpp"
#include "components/local_planner/teb/nearest_statics.hpp"
#include "components/model/mover_weight.hpp"
#include "components/model/nearest_point.hpp"

namespace bw::teb {
namespace {

constexpr double kAssociationMargin =
    0.4;  // [m] that a pose may move in one solve and still know its obstacles
constexpr int kMaxSamplesPerSegment = 4;
constexpr std::size_t kStretch = 8;  // poses that share one selection of obstacles

struct Near {
  double distance;
  double costly;  // [m] below which it costs
  ClearanceTerm term;
};

// The nearest terms, of each kind in places of their own: possible people take none from the confirmed,
// movers none from walls. Equal distances keep their order, so that equal input gives equal output. Returns
// how many that cost something were left out.
std::size_t keep_nearest(std::vector<Near>& near, std::size_t count, std::vector<ClearanceTerm>& terms) {
  std::stable_sort(near.begin(), near.end(),
                   [](const Near& l, const Near& r) { return l.distance < r.distance; });
  std::size_t statics = 0, confirmed = 0, possible = 0, left_out = 0;
  for (const Near& n : near) {
    std::size_t& kept = !n.term.moving ? statics : n.term.presence < 1.0 ? possible : confirmed;
    if (kept < count) {
      terms.push_back(n.term);
      ++kept;
    } else if (n.distance < n.costly) {
      ++left_out;
    }
  }
  return left_out;
}

Capsule mover_at(const Mover& mover, double time) {
  const Vector2 p = mover.position_at(time);
  return {p, p, mover.radius};
}

// Where the robot drives from a pose to the next one, and when.
struct Step {
  Pose2 from;
  Vector2 offset;
  double rotation;
  double time;  // [s] from now
  double duration;

  Pose2 at(double share) const {
    const Vector2 p = from.position() + share * offset;
    return {p.x(), p.y(), from.theta + share * rotation};
  }
};

struct MovingObstacle {
  const Mover* mover;
  double top_speed;
};

// The poses [first, last] of a band: the middle one, how far they are from it, and how long they take.
struct Stretch {
  Vector2 centre;
  double extent;
  double duration;
};

Stretch stretch_of(const Band& band, std::size_t first, std::size_t last) {
  Stretch stretch{band.poses[(first + last) / 2].position(), 0.0, 0.0};
  for (std::size_t k = first; k <= last; ++k) {
    stretch.extent = std::max(stretch.extent, (band.poses[k].position() - stretch.centre).squaredNorm());
    if (k < last) stretch.duration += band.poses[k].dt;
  }
  stretch.extent = std::sqrt(stretch.extent);
  return stretch;
}

class Association {
 public:
  Association(const Band& band, const ObstacleField& field, const BandOptions& options)
      : band_(band),
        field_(field),
        options_(options),
        near_(options.min_obstacle_dist + options.penalty_epsilon),
        most_(static_cast<std::size_t>(options.max_obstacles_per_pose)),
        statics_(field, std::max(near_, options.inflation_dist) + kAssociationMargin,
                 std::max(near_, options.inflation_dist)) {
    std::vector<MovingObstacle> all;
    all.reserve(field.movers.size());
    for (const Mover& m : field.movers) all.push_back({&m, m.top_speed()});
    select_movers(all, stretch_of(band, 0, band.size() - 1), 0.0, candidates_);
  }

  std::vector<PoseTerms> run() {
    std::vector<PoseTerms> result(band_.size());
    double time = 0.0;
    for (std::size_t k = 0; k + 1 < band_.size(); time += band_.poses[k++].dt) {
      if (k % kStretch == 0) look_around(k, time);
      const Pose2 pose = band_.poses[k].pose();
      const Step step{pose, band_.poses[k + 1].position() - pose.position(),
                      wrap_angle(band_.poses[k + 1].theta - pose.theta), time, band_.poses[k].dt};
      at_pose_.clear();
      along_.clear();
      left_out_ = 0;
      for (const MovingObstacle& m : movers_) add_mover(*m.mover, step, k == 0);
      if (k > 0) add_statics(step, 0.0, at_pose_);
      const int samples = samples_of(step.offset.norm());
      for (int i = 1; i <= samples; ++i) add_statics(step, share_of(i, samples), along_);
      left_out_ += keep_nearest(at_pose_, most_, result[k].at_pose);
      left_out_ += keep_nearest(along_, most_, result[k].along_segment);
      result[k].left_out = left_out_;
      for (auto* terms : {&result[k].at_pose, &result[k].along_segment}) {
        allow_narrow_passages(*terms, field_.footprint, band_.poses[k], band_.poses[k + 1],
                              options_.min_obstacle_dist, options_.narrow_passage_dist);
      }
    }
    return result;
  }

 private:
  int samples_of(double relative_motion) const {
    return std::min(static_cast<int>(relative_motion / options_.clearance_step), kMaxSamplesPerSegment);
  }
  static double share_of(int i, int samples) { return static_cast<double>(i) / (samples + 1); }

  // Those obstacles that any pose of [first, first + kStretch] or the path between can be in reach of.
  void look_around(std::size_t first, double time) {
    const std::size_t last = std::min(first + kStretch, band_.size() - 1);
    const Stretch stretch = stretch_of(band_, first, last);
    const Segment chord{band_.poses[first].position(), band_.poses[last].position()};
    double aside = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
      const Vector2 p = band_.poses[k].position();
      aside = std::max(aside, (p - nearest_point(chord, p)).norm());
    }
    statics_.look_along(chord, aside);
    select_movers(candidates_, stretch, time, movers_);
  }

  // Those of `from` that can be in reach of the stretch, which begins at `time`.
  void select_movers(const std::vector<MovingObstacle>& from, const Stretch& stretch, double time,
                     std::vector<MovingObstacle>& selected) const {
    selected.clear();
    for (const MovingObstacle& m : from) {
      const double reach =
          moving_reach(*m.mover, time + stretch.duration) + field_.footprint.radius + m.mover->radius;
      const double far = stretch.extent + reach + m.top_speed * stretch.duration + kRounding;
      if ((m.mover->position_at(time) - stretch.centre).squaredNorm() <= far * far) selected.push_back(m);
    }
  }

  double inflation_of_movers() const { return std::max(near_, options_.dynamic_obstacle_inflation_dist); }
  double moving_reach(const Mover& mover, double time) const {
    return inflation_of_movers() + kAssociationMargin + field_.uncertainty.at(mover, time);
  }

  void add_mover(const Mover& mover, const Step& step, bool is_start) {
    const double reach = moving_reach(mover, step.time + step.duration);
    const Vector2 p = step.from.position();
    const Capsule now = mover_at(mover, step.time);
    const Vector2 drift = mover.position_at(step.time + step.duration) - now.a;
    const double motion = (step.offset - drift).norm();
    if ((p - now.a).norm() - (now.radius + field_.footprint.radius) > reach + motion) return;
    if (!is_start) add_in_reach(mover, now, step, 0.0, reach, at_pose_);
    const int samples = samples_of(motion);
    for (int i = 1; i <= samples; ++i) {
      const double share = share_of(i, samples);
      add_in_reach(mover, mover_at(mover, step.time + share * step.duration), step, share, reach, along_);
    }
  }

  // The mover, if the robot is, by the disc around it, in reach of it.
  void add_in_reach(const Mover& mover, const Capsule& then, const Step& step, double share, double reach,
                    std::vector<Near>& near) const {
    const Pose2 pose = step.at(share);
    const double squared = (pose.position() - then.a).squaredNorm();
    const double radius = then.radius + field_.footprint.radius;
    if (squared > (reach + radius) * (reach + radius)) return;
    const double distance =
        field_.footprint.is_polygon() ? gap_to(field_.footprint, pose, then) : std::sqrt(squared) - radius;
    const double unsure = field_.uncertainty.at(mover, step.time + share * step.duration);
    near.push_back({distance, inflation_of_movers() + unsure, {then, share, true, unsure, presence(mover)}});
  }

  void add_statics(const Step& step, double share, std::vector<Near>& near) {
    left_out_ += statics_.find(step.at(share), most_, found_);
    for (const NearStatic& f : found_) {
      near.push_back({f.distance,
                      std::max(near_, options_.inflation_dist),
                      {field_.statics.capsules()[f.index], share, false, 0.0, 1.0}});
    }
  }

  static constexpr double kRounding = 1e-6;  // [m]

  const Band& band_;
  const ObstacleField& field_;
  const BandOptions& options_;
  double near_;  // [m] from which obstacles are kept away
  std::size_t most_;
  NearestStatics statics_;
  std::vector<MovingObstacle> candidates_, movers_;  // that the band meets, and that the stretch does
  std::vector<Near> at_pose_, along_;
  std::vector<NearStatic> found_;
  std::size_t left_out_ = 0;
};

}  // namespace

std::vector<PoseTerms> associate(const Band& band, const ObstacleField& field, const BandOptions& options) {
  return Association(band, field, options).run();
}

}  // namespace bw::teb
