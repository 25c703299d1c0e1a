#include "components/local_planner/mppi/rollouts.hpp"

#include <cmath>

namespace bw::mppi {
namespace {

constexpr double kSmallRotation = 0.5;  // [rad] up to which the series below are exact to 1e-14

// sin(t) / t and (1 - cos(t)) / t: displacements along and across of an arc of length 1 that rotates by t.
struct Arcs {
  Eigen::ArrayXd along, across, square;

  void of(const Eigen::ArrayXd& rotation) {
    if (rotation.abs().maxCoeff() > kSmallRotation) return of_any(rotation);
    square = rotation.square();
    // Reciprocals: a division takes as long as ten products.
    along =
        1.0 - square * k6 *
                  (1.0 - square * k20 * (1.0 - square * k42 * (1.0 - square * k72 * (1.0 - square * k110))));
    across = 0.5 * rotation *
             (1.0 -
              square * k12 *
                  (1.0 - square * k30 * (1.0 - square * k56 * (1.0 - square * k90 * (1.0 - square * k132)))));
  }

 private:
  static constexpr double k6 = 1.0 / 6.0, k20 = 1.0 / 20.0, k42 = 1.0 / 42.0, k72 = 1.0 / 72.0,
                          k110 = 1.0 / 110.0;
  static constexpr double k12 = 1.0 / 12.0, k30 = 1.0 / 30.0, k56 = 1.0 / 56.0, k90 = 1.0 / 90.0,
                          k132 = 1.0 / 132.0;

  void of_any(const Eigen::ArrayXd& rotation) {
    along.resize(rotation.size());
    across.resize(rotation.size());
    for (Eigen::Index i = 0; i < rotation.size(); ++i) {
      const double t = rotation[i];
      const bool none = std::abs(t) < 1e-6;
      along[i] = none ? 1.0 - t * t / 6.0 : std::sin(t) / t;
      // Not 1 - cos, which has no digits left of a small rotation.
      across[i] = none ? t / 2.0 : 2.0 * std::sin(t / 2.0) * std::sin(t / 2.0) / t;
    }
  }
};

// Commands, no further from what is driven before than `most`; each in the step after.
void drive(const Eigen::ArrayXXd& command, Eigen::ArrayXXd& driven, double now, double most) {
  driven.col(0).setConstant(now);
  for (Eigen::Index k = 0; k + 1 < driven.cols(); ++k)
    driven.col(k + 1) = command.col(k).max(driven.col(k) - most).min(driven.col(k) + most);
}

}  // namespace

void Rollouts::resize(Eigen::Index samples, Eigen::Index steps) {
  for (Eigen::ArrayXXd* array : {&command_v, &command_omega, &v, &omega, &x, &y, &theta})
    array->resize(samples, steps);
}

void cut_commands(Rollouts& rollouts) {
  const Eigen::Index count = rollouts.steps() - 1;
  rollouts.command_v.leftCols(count) = rollouts.v.rightCols(count);
  rollouts.command_omega.leftCols(count) = rollouts.omega.rightCols(count);
}

void roll_out(Rollouts& rollouts, const Twist2& now, const Limits& limits, double dt) {
  drive(rollouts.command_v, rollouts.v, now.v, limits.acc_max * dt);
  drive(rollouts.command_omega, rollouts.omega, now.omega, limits.alpha_max * dt);
  const Eigen::Index samples = rollouts.samples();
  Eigen::ArrayXd x = Eigen::ArrayXd::Zero(samples), y = x, theta = x;
  Eigen::ArrayXd cosine = Eigen::ArrayXd::Ones(samples), sine = x;  // of the heading
  Eigen::ArrayXd rotation(samples), distance(samples), next(samples);
  Arcs arcs;
  for (Eigen::Index k = 0; k < rollouts.steps(); ++k) {
    rotation = dt * rollouts.omega.col(k);
    distance = dt * rollouts.v.col(k);
    arcs.of(rotation);
    x += distance * (arcs.along * cosine - arcs.across * sine);
    y += distance * (arcs.along * sine + arcs.across * cosine);
    theta += rotation;
    // cos(t) = 1 - t across, sin(t) = t along.
    next = cosine - rotation * (arcs.across * cosine + arcs.along * sine);
    sine += rotation * (arcs.along * cosine - arcs.across * sine);
    cosine = next;
    rollouts.x.col(k) = x;
    rollouts.y.col(k) = y;
    rollouts.theta.col(k) = theta;
  }
}

}  // namespace bw::mppi
