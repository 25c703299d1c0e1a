// How good the reported motion of people is, beyond its mean error: whether its covariance tells the truth,
// and where it says people will be. Judged is whoever was followed for 1 s, as the velocity in
// perception_score.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Dense>

#include "components/people/prediction/predictor.hpp"
#include "tests/components/people/perception_trial.hpp"

namespace bw::people::test {

constexpr std::array<double, 2> kAhead{0.8, 1.6};  // [s]

struct Mean {
  double sum = 0.0;
  long count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  void add(const Mean& other) {
    sum += other.sum;
    count += other.count;
  }
  double value() const { return sum / static_cast<double>(count); }
};

struct MotionScore {
  Score score;
  Mean nees;                     ///< of the velocity: 2 when the covariance is true
  Mean nees_steady;              ///< of those who kept theirs for 0.5 s
  Mean inside_95;                ///< share of velocities within 5.99
  std::array<Mean, 2> straight;  ///< error of the position foreseen, velocity kept, at kAhead [m]
  std::array<Mean, 2> rotating;  ///< the same, turn rate kept as the predictor's constant_turn_rate does [m]

  void add(const MotionScore& other) {
    score.add(other.score);
    nees.add(other.nees);
    nees_steady.add(other.nees_steady);
    inside_95.add(other.inside_95);
    for (std::size_t k = 0; k < kAhead.size(); ++k) {
      straight[k].add(other.straight[k]);
      rotating[k].add(other.rotating[k]);
    }
  }
};

/// Listens to one trial.
class MotionJudge {
 public:
  explicit MotionJudge(Trial& trial)
      : trial_(&trial),
        straight_(with(PredictionModel::constant_velocity)),
        rotating_(with(PredictionModel::constant_turn_rate)) {
    trial.keeper().on_followed = [this](const TruePerson& person, const TrackedPerson& track, bool steady) {
      judge(person, track, steady);
      followed_.push_back({person.id, track.id});
    };
    trial.watch = [this](const DetectionSet& detections, const std::vector<TruePerson>& truth,
                         const std::vector<TrackedPerson>& tracks) { look(detections.time, truth, tracks); };
  }

  MotionScore run(double seconds) {
    result_.score = trial_->run(seconds).score;
    return result_;
  }

 private:
  struct Followed {
    std::uint32_t person;
    std::uint32_t track;
  };
  struct Foreseen {
    std::uint32_t person;
    double due;  ///< [s]
    std::size_t ahead;
    Vector2 straight, rotating;  ///< in M
  };

  static PredictionOptions with(PredictionModel model) {
    PredictionOptions options;
    options.model = model;
    options.step = kAhead[0];
    options.horizon = kAhead[1];
    return options;
  }

  void judge(const TruePerson& person, const TrackedPerson& track, bool steady) {
    const Vector2 error = track.velocity - person.velocity;
    const Eigen::Matrix2d P = track.covariance.bottomRightCorner<2, 2>();
    const double square = error.dot(P.ldlt().solve(error));
    result_.nees.add(square);
    if (steady) result_.nees_steady.add(square);
    result_.inside_95.add(square < 5.991464547 ? 1.0 : 0.0);  // chi-square, 2 dof
  }

  void look(Time stamp, const std::vector<TruePerson>& truth, const std::vector<TrackedPerson>& tracks) {
    const Pose2 X_MO = trial_->X_MO();
    const double now = trial_->now();
    std::erase_if(foreseen_, [&](const Foreseen& f) {
      if (f.due > now + 1e-6) return false;
      for (const TruePerson& person : truth) {
        if (person.id != f.person) continue;
        const Vector2 position = X_MO * person.position;
        result_.straight[f.ahead].add((position - f.straight).norm());
        result_.rotating[f.ahead].add((position - f.rotating).norm());
      }
      return true;
    });
    std::vector<TrackedPerson> straight = tracks;
    std::vector<TrackedPerson> rotating = tracks;
    straight_.predict(straight, {}, stamp);
    rotating_.predict(rotating, {}, stamp);
    for (const Followed& f : followed_) {
      for (std::size_t i = 0; i < tracks.size(); ++i) {
        if (tracks[i].id != f.track) continue;
        for (std::size_t k = 0; k < kAhead.size(); ++k)
          foreseen_.push_back({f.person, now + kAhead[k], k, X_MO * straight[i].predictions[k].position,
                               X_MO * rotating[i].predictions[k].position});
      }
    }
    followed_.clear();
  }

  Trial* trial_;
  Predictor straight_;
  Predictor rotating_;
  MotionScore result_;
  std::vector<Followed> followed_;
  std::vector<Foreseen> foreseen_;
};

}  // namespace bw::people::test
