#include "components/slam/pose_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>

namespace bw::slam {
namespace {

constexpr double kScaling = 7.8;      // chi^2 of three degrees of freedom that 95 % of right loops stay below
constexpr double kGraduation = 30.0;  // from one scaling to the next
constexpr int kMostIterations = 30;   // with one scaling
constexpr int kIterationsOfStep = 3;
constexpr double kTrustRegion = 1e7;  // wide, since each step begins with it again
constexpr double kUntrusted = 0.1;    // share of a loop's weight

// s below the scaling counts as it is, s far above as good as nothing: weight (2 k / (k + s))^2.
class DynamicCovarianceScaling final : public ceres::LossFunction {
 public:
  explicit DynamicCovarianceScaling(double scaling) : scaling_(scaling) {}

  double scaling() const { return scaling_; }
  void set_scaling(double scaling) { scaling_ = scaling; }

  void Evaluate(double s, double out[3]) const override {
    if (s <= scaling_) {
      out[0] = s;
      out[1] = 1.0;
      out[2] = 0.0;
      return;
    }
    const double sum = scaling_ + s;
    out[0] = 4.0 * scaling_ * s / sum - scaling_;
    out[1] = 4.0 * scaling_ * scaling_ / (sum * sum);
    out[2] = -2.0 * out[1] / sum;
  }

 private:
  double scaling_;
};

double weight_of(double s) {
  if (s <= kScaling) return 1.0;
  const double half = 2.0 * kScaling / (kScaling + s);
  return half * half;
}

// Upper triangle U with U^T U = covariance^-1.
Eigen::Matrix3d whitening(const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d information = (covariance + 1e-9 * Eigen::Matrix3d::Identity()).inverse();
  return information.llt().matrixU();
}

// Whitened difference between what an edge says and the poses of its ends.
class EdgeResidual final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  EdgeResidual(const UncertainPose& X, const Eigen::Matrix3d& U) : X_(X.X), U_(U) {}

  bool Evaluate(double const* const* poses, double* residuals, double** jacobians) const override {
    const double* a = poses[0];
    const double* b = poses[1];
    const double c = std::cos(a[2]);
    const double s = std::sin(a[2]);
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const Eigen::Vector3d e{c * dx + s * dy - X_.x, -s * dx + c * dy - X_.y,
                            wrap_angle(b[2] - a[2] - X_.theta)};
    Eigen::Map<Eigen::Vector3d>{residuals} = U_ * e;
    if (jacobians == nullptr) return true;
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Eigen::Matrix3d J;
    if (jacobians[0] != nullptr) {
      J << -c, -s, -s * dx + c * dy, s, -c, -c * dx - s * dy, 0.0, 0.0, -1.0;
      Eigen::Map<RowMajor>{jacobians[0]} = U_ * J;
    }
    if (jacobians[1] != nullptr) {
      J << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
      Eigen::Map<RowMajor>{jacobians[1]} = U_ * J;
    }
    return true;
  }

 private:
  Pose2 X_;
  Eigen::Matrix3d U_;
};

}  // namespace

double disagreement(const Edge& edge, const std::vector<Pose2>& poses) {
  const Eigen::Vector3d e = difference(inverse(poses[edge.from]) * poses[edge.to], edge.X.X);
  return (whitening(edge.X.covariance) * e).squaredNorm();
}

double weight_left(const Edge& loop, const std::vector<Pose2>& poses) {
  return weight_of(disagreement(loop, poses));
}

struct Optimisation::Problem {
  DynamicCovarianceScaling loss{kScaling};
  std::vector<std::array<double, 3>> values;
  ceres::Problem problem{options()};
  int iterations = 0;  // with this scaling
  bool finished = false;

  static ceres::Problem::Options options() {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }
};

Optimisation::~Optimisation() = default;
Optimisation::Optimisation(Optimisation&&) noexcept = default;
Optimisation& Optimisation::operator=(Optimisation&&) noexcept = default;

Optimisation::Optimisation(const std::vector<Edge>& edges, const std::vector<Pose2>& poses)
    : problem_(std::make_unique<Problem>()) {
  Problem& p = *problem_;
  p.finished = poses.size() < 2 || edges.empty();
  p.values.reserve(poses.size());
  for (const Pose2& pose : poses) p.values.push_back({pose.x, pose.y, pose.theta});
  for (auto& value : p.values) p.problem.AddParameterBlock(value.data(), 3);
  double worst = kScaling;
  for (const Edge& edge : edges) {
    if (edge.loop) worst = std::max(worst, disagreement(edge, poses));
    p.problem.AddResidualBlock(new EdgeResidual(edge.X, whitening(edge.X.covariance)),
                               edge.loop ? &p.loss : nullptr, p.values[edge.from].data(),
                               p.values[edge.to].data());
  }
  if (!p.values.empty()) p.problem.SetParameterBlockConstant(p.values.front().data());
  p.loss.set_scaling(worst);
}

bool Optimisation::step() {
  Problem& p = *problem_;
  if (p.finished) return false;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = kIterationsOfStep;
  options.function_tolerance = 1e-5;
  options.initial_trust_region_radius = kTrustRegion;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &p.problem, &summary);
  p.iterations += kIterationsOfStep;
  if (summary.termination_type == ceres::NO_CONVERGENCE && p.iterations < kMostIterations) return true;
  if (p.loss.scaling() <= kScaling) {
    p.finished = true;
    return false;
  }
  p.loss.set_scaling(std::max(kScaling, p.loss.scaling() / kGraduation));
  p.iterations = 0;
  return true;
}

std::vector<Pose2> Optimisation::poses() const {
  std::vector<Pose2> poses;
  poses.reserve(problem_->values.size());
  for (const auto& value : problem_->values) poses.push_back({value[0], value[1], wrap_angle(value[2])});
  return poses;
}

std::vector<UncertainPose> relative_to(std::size_t from, const std::vector<Edge>& edges,
                                       const std::vector<Pose2>& poses) {
  struct Neighbour {
    std::size_t submap = 0;
    UncertainPose X;
  };
  std::vector<std::vector<Neighbour>> neighbours(poses.size());
  for (const Edge& edge : edges) {
    if (edge.loop && weight_left(edge, poses) < kUntrusted) continue;
    // The way goes by the poses as they are; of the edge the covariance alone.
    const Pose2 X = inverse(poses[edge.from]) * poses[edge.to];
    neighbours[edge.from].push_back({edge.to, {X, edge.X.covariance}});
    neighbours[edge.to].push_back({edge.from, inverse(UncertainPose{X, edge.X.covariance})});
  }
  constexpr double kMetresPerRadian = 5.0;
  const auto cost = [](const Eigen::Matrix3d& C) {
    return C(0, 0) + C(1, 1) + kMetresPerRadian * kMetresPerRadian * C(2, 2);
  };
  std::vector<UncertainPose> result(poses.size());
  std::vector<double> best(poses.size(), std::numeric_limits<double>::infinity());
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  best[from] = 0.0;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const auto [so_far, at] = open.top();
    open.pop();
    if (so_far > best[at]) continue;
    for (const Neighbour& neighbour : neighbours[at]) {
      const UncertainPose X = result[at] * neighbour.X;
      const double total = cost(X.covariance);
      if (total >= best[neighbour.submap]) continue;
      best[neighbour.submap] = total;
      result[neighbour.submap] = X;
      open.emplace(total, neighbour.submap);
    }
  }
  return result;
}

}  // namespace bw::slam
