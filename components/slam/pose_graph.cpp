#include "components/slam/pose_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <queue>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <ceres/ceres.h>

namespace bw::slam {
namespace {

constexpr double kScaling = 7.8;      // chi^2 of three degrees of freedom that 95 % of right loops stay below
constexpr double kGraduation = 30.0;  // from one scaling to the next
constexpr int kMostIterations = 30;   // with one scaling
constexpr int kIterationsOfStep = 3;
constexpr double kTrustRegion = 1e7;  // wide, since each step begins with it again
constexpr double kUntrusted = 0.1;    // share of a loop's weight
constexpr double kFarOff = 1000.0;    // chi^2 of a loop that is looked at twice
constexpr double kAllowed = 100.0;    // chi^2 of what the drive allows

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

namespace {

// Whether the drive allows a loop, by the covariance that its edges sum up to: ten standard deviations.
bool can_be(const Edge& loop, const std::vector<Edge>& edges, const std::vector<Pose2>& poses) {
  std::vector<Edge> drive;
  std::ranges::copy_if(edges, std::back_inserter(drive), [](const Edge& edge) { return !edge.loop; });
  return squared_distance(relative_to(loop.from, drive, poses)[loop.to], loop.X) <= kAllowed;
}

}  // namespace

struct Optimisation::Problem {
  Problem(const std::vector<Edge>& edges, const std::vector<Pose2>& poses);

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
Optimisation::Optimisation(std::vector<Edge> edges, std::vector<Pose2> poses)
    : edges_(std::move(edges)), poses_(std::move(poses)) {}

Optimisation::Problem::Problem(const std::vector<Edge>& edges, const std::vector<Pose2>& poses)
    : finished(poses.size() < 2 || edges.empty()) {
  values.reserve(poses.size());
  for (const Pose2& pose : poses) values.push_back({pose.x, pose.y, pose.theta});
  std::vector<bool> has_edge(poses.size(), false);
  for (const Edge& edge : edges) has_edge[edge.from] = has_edge[edge.to] = true;
  for (std::size_t k = 0; k < poses.size(); ++k)
    if (has_edge[k]) problem.AddParameterBlock(values[k].data(), 3);
  double worst = kScaling;
  for (const Edge& edge : edges) {
    const double s = edge.loop ? disagreement(edge, poses) : 0.0;
    // It would pull the others away before it is judged.
    if (s > kFarOff && !can_be(edge, edges, poses)) continue;
    worst = std::max(worst, s);
    problem.AddResidualBlock(new EdgeResidual(edge.X, whitening(edge.X.covariance)),
                             edge.loop ? &loss : nullptr, values[edge.from].data(), values[edge.to].data());
  }
  const auto first = std::find(has_edge.begin(), has_edge.end(), true);
  if (first != has_edge.end())
    problem.SetParameterBlockConstant(values[static_cast<std::size_t>(first - has_edge.begin())].data());
  loss.set_scaling(worst);
}

bool Optimisation::step() {
  if (!problem_) problem_ = std::make_unique<Problem>(edges_, poses_);
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
  if (!problem_) return poses_;
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
      const double total = spread(X.covariance);
      if (total >= best[neighbour.submap]) continue;
      best[neighbour.submap] = total;
      result[neighbour.submap] = X;
      open.emplace(total, neighbour.submap);
    }
  }
  return result;
}

UncertainPose marginal(std::size_t of, std::size_t in, const std::vector<Edge>& edges,
                       const std::vector<Pose2>& poses) {
  const UncertainPose exact{inverse(poses[in]) * poses[of], Eigen::Matrix3d::Zero()};
  if (of == in) return exact;
  // Unknowns of the submaps that have an edge, but for `in`, which stays.
  std::vector<int> first(poses.size(), -1);
  int unknowns = 0;
  for (const Edge& edge : edges)
    for (const std::size_t end : {edge.from, edge.to})
      if (end != in && first[end] < 0) first[end] = 3 * unknowns++;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(36 * edges.size());
  for (const Edge& edge : edges) {
    const double weight = edge.loop ? weight_left(edge, poses) : 1.0;
    const EdgeResidual residual(edge.X, whitening(edge.X.covariance));
    const std::array ends{edge.from, edge.to};
    std::array<std::array<double, 3>, 2> values{};
    std::array<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>, 2> J;
    for (std::size_t i = 0; i < 2; ++i)
      values[i] = {poses[ends[i]].x, poses[ends[i]].y, poses[ends[i]].theta};
    const std::array<const double*, 2> at{values[0].data(), values[1].data()};
    std::array<double*, 2> jacobians{J[0].data(), J[1].data()};
    Eigen::Vector3d e;
    residual.Evaluate(at.data(), e.data(), jacobians.data());
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        if (first[ends[i]] < 0 || first[ends[j]] < 0) continue;
        const Eigen::Matrix3d block = weight * J[i].transpose() * J[j];
        for (int row = 0; row < 3; ++row)
          for (int column = 0; column < 3; ++column)
            entries.emplace_back(first[ends[i]] + row, first[ends[j]] + column, block(row, column));
      }
  }
  Eigen::SparseMatrix<double> information(3 * unknowns, 3 * unknowns);
  information.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(information);
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(3 * unknowns, 3);
  wanted.block<3, 3>(first[of], 0).setIdentity();
  const Eigen::Matrix3d C = factor.solve(wanted).block<3, 3>(first[of], 0);
  // From the map's axes into those of `in`.
  const Eigen::Matrix3d R = by_second(inverse(poses[in]));
  return {exact.X, R * C * R.transpose()};
}

}  // namespace bw::slam
