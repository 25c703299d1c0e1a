#include "components/local_planner/adaptor/planner_markers.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "components/local_planner/adaptor/marker_drawing.hpp"
#include "components/messages/geometry.hpp"
#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MarkerArray;
namespace constants = visualization_msgs::msg::Marker_Constants;

constexpr Color kChosen{0.1F, 0.7F, 0.2F, 1.0F};
constexpr Color kOther{0.5F, 0.5F, 0.5F, 0.6F};
constexpr Color kDot{0.9F, 0.4F, 0.1F, 0.7F};
constexpr Color kSpread{0.9F, 0.4F, 0.1F, 0.15F};
constexpr Color kCone{0.8F, 0.1F, 0.1F, 0.15F};
constexpr Color kLeg{0.8F, 0.1F, 0.1F, 0.8F};
constexpr Color kWanted{0.1F, 0.3F, 0.9F, 0.9F};

constexpr std::size_t kMaxLabels = 12;     // of more candidates only the chosen one can be read
constexpr double kTextHeight = 0.2;         // [m]
constexpr double kPredictionStep = 0.5;     // [s]
constexpr double kPredictionHorizon = 3.0;  // [s]
constexpr double kSpreadDeviations = 2.0;

/// Possible people are drawn paler, by their presence.
Color paled(Color color, const Mover& mover) {
  constexpr float kPalest = 0.2F;
  color[3] *= kPalest + (1.0F - kPalest) * static_cast<float>(presence(mover));
  return color;
}

void draw_candidates(const std::vector<Candidate>& candidates, MarkerDrawing& drawing) {
  for (const Candidate& candidate : candidates) {
    if (candidate.trajectory.size() < 2) continue;
    const Color& color = candidate.chosen ? kChosen : kOther;
    Marker line = drawing.make("candidates", constants::LINE_STRIP, candidate.chosen ? 0.05 : 0.025, color);
    for (const TrajectoryPoint& point : candidate.trajectory)
      line.points().push_back(to_point(point.pose.position()));
    drawing.add(std::move(line));

    if (!candidate.chosen && candidates.size() > kMaxLabels) continue;
    Marker label = drawing.make("candidate_labels", constants::TEXT_VIEW_FACING, kTextHeight, color);
    label.pose().position(to_point(candidate.trajectory[candidate.trajectory.size() / 2].pose.position()));
    label.pose().position().z(kTextHeight);
    label.text(fmt::format("{} {:.2f}", candidate.label, candidate.cost));
    drawing.add(std::move(label));
  }
}

/// The ellipse around a predicted position that it is in with 86 % certainty.
void draw_spread(const PredictedPosition& prediction, const Color& color, MarkerDrawing& drawing) {
  if (!prediction.covariance.allFinite() || prediction.covariance.trace() <= 0.0) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(prediction.covariance);
  const auto diameter = [&](int axis) {
    return 2.0 * kSpreadDeviations * std::sqrt(std::max(axes.eigenvalues()[axis], 0.0));
  };
  Marker ellipse = drawing.make("predictions", constants::CYLINDER, diameter(1), color);
  ellipse.scale().y(std::max(diameter(0), 1e-3));  // rviz2 warns of a scale of zero
  ellipse.scale().z(0.01);
  const Eigen::Vector2d longest = axes.eigenvectors().col(1);
  const Vector2& at = prediction.position;
  ellipse.pose(to_pose({at.x(), at.y(), std::atan2(longest.y(), longest.x())}));
  drawing.add(std::move(ellipse));
}

/// About one prediction each half second; those of constant velocity for a mover that comes with none.
std::vector<PredictedPosition> shown_predictions(const Mover& mover) {
  std::vector<PredictedPosition> shown;
  for (const PredictedPosition& prediction : mover.predictions) {
    if (prediction.time > kPredictionHorizon) break;
    if (shown.empty() || prediction.time > shown.back().time + kPredictionStep - 1e-6)
      shown.push_back(prediction);
  }
  if (!mover.predictions.empty()) return shown;
  const auto steps = static_cast<int>(kPredictionHorizon / kPredictionStep);
  for (int step = 1; step <= steps; ++step) {
    const double time = step * kPredictionStep;
    shown.push_back({.time = time, .position = mover.position_at(time)});
  }
  return shown;
}

void draw_predictions(const Mover& mover, MarkerDrawing& drawing) {
  Marker dots = drawing.make("predictions", constants::SPHERE_LIST, 0.1, paled(kDot, mover));
  for (const PredictedPosition& prediction : shown_predictions(mover)) {
    dots.points().push_back(to_point(prediction.position));
    draw_spread(prediction, paled(kSpread, mover), drawing);
  }
  if (!dots.points().empty()) drawing.add(std::move(dots));
}

void draw_velocities(const PlanningProblem& problem, const PlanningResult& result, MarkerDrawing& drawing) {
  const Vector2 robot = problem.pose.position();
  for (const VelocityCone& cone : result.velocity_cones) {
    // Long enough to leave the disc of the robot's velocities, wherever the apex is.
    const double length = cone.apex.norm() + 1.5 * problem.limits.v_max;
    const auto apex = to_point(robot + cone.apex);
    const auto right = to_point(robot + cone.apex + length * cone.right);
    const auto left = to_point(robot + cone.apex + length * cone.left);
    Marker legs = drawing.make("velocity_cones", constants::LINE_LIST, 0.02, kLeg);
    legs.points() = {apex, right, apex, left};
    drawing.add(std::move(legs));
    Marker inside = drawing.make("velocity_cones", constants::TRIANGLE_LIST, 1.0, kCone);
    inside.points() = {apex, right, left};
    drawing.add(std::move(inside));
  }
  if (!result.velocity_wanted) return;
  Marker arrow = drawing.make("velocity_wanted", constants::ARROW, 0.05, kWanted);
  arrow.scale().y(0.1);
  arrow.scale().z(0.1);
  arrow.points() = {to_point(robot), to_point(robot + *result.velocity_wanted)};
  drawing.add(std::move(arrow));
}

}  // namespace

MarkerArray to_markers(const PlanningProblem& problem, const PlanningResult& result,
                       const std::string& frame) {
  MarkerDrawing drawing(make_header(frame, problem.now));
  draw_candidates(result.candidates, drawing);
  for (const Mover& mover : problem.movers) draw_predictions(mover, drawing);
  draw_velocities(problem, result, drawing);
  return drawing.take();
}

}  // namespace bw
