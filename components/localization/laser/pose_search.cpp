#include "components/localization/laser/pose_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bw::localization {
namespace {

constexpr std::size_t kMaxEnds = 120;  // times 255 stays within the bounds' 16 bits
constexpr int kBoundsPerNode = 8;      // bounds come many at a time
constexpr std::int32_t kBoundClass = 16;

BeamEnds thinned(const BeamEnds& ends) {
  if (ends.size() <= kMaxEnds) return ends;
  BeamEnds fewer;
  for (std::size_t i = 0; i < kMaxEnds; ++i) {
    fewer.x.push_back(ends.x[i * ends.size() / kMaxEnds]);
    fewer.y.push_back(ends.y[i * ends.size() / kMaxEnds]);
  }
  return fewer;
}

CellOffsets offsets(const BeamEnds& ends, double heading, double resolution) {
  CellOffsets cells;
  const Vector2 column = direction(heading) / resolution;
  for (std::size_t b = 0; b < ends.size(); ++b) {
    const auto x = static_cast<double>(ends.x[b]);
    const auto y = static_cast<double>(ends.y[b]);
    cells.x.push_back(static_cast<std::int32_t>(std::lround(column.x() * x - column.y() * y)));
    cells.y.push_back(static_cast<std::int32_t>(std::lround(column.y() * x + column.x() * y)));
  }
  const auto [least_x, most_x] = std::minmax_element(cells.x.begin(), cells.x.end());
  const auto [least_y, most_y] = std::minmax_element(cells.y.begin(), cells.y.end());
  if (ends.size() == 0) return cells;
  cells.least_x = *least_x;
  cells.most_x = *most_x;
  cells.least_y = *least_y;
  cells.most_y = *most_y;
  return cells;
}

}  // namespace

PoseSearch::PoseSearch(const LikelihoodField& field, const PoseSearchOptions& options)
    : options_(options),
      tables_(field, options.step, options.clearance),
      headings_(static_cast<std::size_t>(std::ceil(2.0 * std::numbers::pi / options.kAngleStep))) {}

void PoseSearch::begin(const BeamEnds& ends) {
  ends_ = thinned(ends);
  results_.clear();
  open_.clear();
  visited_ = 0;
  next_heading_ = 0;
  phase_ = ends_.size() == 0 ? Phase::finished : Phase::bounding;
  least_score_ = static_cast<std::int32_t>(options_.kLeastFit * 255.0 * static_cast<double>(ends_.size()));
  least_candidate_ = least_score_;
  candidates_ = 0;
  by_bound_.assign(kMaxEnds * 255 / kBoundClass + 2, 0);
  offsets_.resize(headings_);
  for (std::size_t heading = 0; heading < headings_; ++heading) {
    offsets_[heading] = offsets(ends_, heading_of(heading), tables_.resolution());
  }
}

bool PoseSearch::advance(int nodes) {
  const std::int64_t until = visited_ + nodes;
  while (phase_ == Phase::bounding && visited_ < until) bound_heading();
  while (phase_ == Phase::splitting && visited_ < until) split_best();
  return finished();
}

void PoseSearch::bound_heading() {
  bounds_.assign(static_cast<std::size_t>(tables_.blocks_x()) * static_cast<std::size_t>(tables_.blocks_y()),
                 0);
  const CellOffsets& ends = offsets_[next_heading_];
  for (std::size_t b = 0; b < ends_.size(); ++b) tables_.add_bounds(ends.x[b], ends.y[b], bounds_);
  const std::int32_t all_outside = tables_.outside() * static_cast<std::int32_t>(ends_.size());
  const int level = tables_.coarsest();
  for (const std::uint32_t block : tables_.free_blocks()) {
    const std::int32_t bound = all_outside + bounds_[block];
    if (bound < least_candidate_) continue;
    const auto i = static_cast<std::int32_t>(block) % tables_.blocks_x();
    const auto j = static_cast<std::int32_t>(block) / tables_.blocks_x();
    open_.push_back({bound, static_cast<std::uint16_t>(next_heading_), static_cast<std::uint16_t>(level),
                     i << level, j << level});
    note_candidate(bound);
  }
  visited_ += 1 + static_cast<std::int64_t>(tables_.free_blocks().size()) / kBoundsPerNode;
  if (++next_heading_ < headings_) return;
  std::erase_if(open_, [this](const Node& node) { return node.score < least_candidate_; });
  std::make_heap(open_.begin(), open_.end(), worse);
  phase_ = Phase::splitting;
}

// Raises what a candidate must have while there are too many that have more.
void PoseSearch::note_candidate(std::int32_t bound) {
  ++by_bound_[static_cast<std::size_t>(bound / kBoundClass)];
  ++candidates_;
  for (auto least = static_cast<std::size_t>(least_candidate_ / kBoundClass);
       candidates_ - by_bound_[least] >= options_.kCandidates; ++least) {
    candidates_ -= by_bound_[least];
    least_candidate_ = static_cast<std::int32_t>(least + 1) * kBoundClass;
  }
}

void PoseSearch::split_best() {
  if (open_.empty() || results_.size() >= static_cast<std::size_t>(options_.kHypotheses)) return finish();
  std::pop_heap(open_.begin(), open_.end(), worse);
  const Node node = open_.back();
  open_.pop_back();
  ++visited_;
  if (node.score < least_score_) return finish();
  const double half_diagonal = std::numbers::sqrt2 / 2.0 * tables_.resolution() * (1 << node.level);
  const Pose2 X_MB = pose_of(node);
  if (near_result(X_MB, node.level == tables_.finest() ? 0.0 : half_diagonal)) return;
  if (node.level == tables_.finest()) {
    const Scored best = refined({X_MB, score(X_MB)});
    results_.push_back({best.X_MB, fit_of(best.score)});
    const double least_fit = std::max(options_.kLeastFit, results_.front().fit - options_.kMargin);
    least_score_ = static_cast<std::int32_t>(least_fit * 255.0 * static_cast<double>(ends_.size()));
    return;
  }
  const auto level = static_cast<std::uint16_t>(node.level - 1);
  const std::array<std::int32_t, 4> scores = tables_.sums(level, node.x, node.y, offsets_[node.heading]);
  visited_ += 4;
  for (std::int32_t quarter = 0; quarter < 4; ++quarter) {
    const Node child{scores[static_cast<std::size_t>(quarter)], node.heading, level,
                     node.x + ((quarter & 1) << level), node.y + ((quarter >> 1) << level)};
    if (child.score < least_score_ || !tables_.free(level, child.x, child.y)) continue;
    open_.push_back(child);
    std::push_heap(open_.begin(), open_.end(), worse);
  }
}

// Better by a finer step, as long as a neighbour is better.
PoseSearch::Scored PoseSearch::refined(Scored from) const {
  double step = options_.step / 2.0;
  double angle = options_.kAngleStep / 2.0;
  for (int halvings = 0; halvings < 3; ++halvings, step /= 2.0, angle /= 2.0) {
    for (int moves = 0; moves < 10; ++moves) {
      Scored best = from;
      for (const Pose2& by :
           {Pose2{step, 0, 0}, {-step, 0, 0}, {0, step, 0}, {0, -step, 0}, {0, 0, angle}, {0, 0, -angle}}) {
        const Pose2 X_MB{from.X_MB.x + by.x, from.X_MB.y + by.y, wrap_angle(from.X_MB.theta + by.theta)};
        const std::int32_t there = score(X_MB);
        if (there > best.score) best = {X_MB, there};
      }
      if (best.score <= from.score) break;
      from = best;
    }
  }
  return from;
}

void PoseSearch::finish() {
  // Refinement may have changed the order, and led two to the same position.
  std::vector<PoseHypothesis> found;
  found.swap(results_);
  std::stable_sort(found.begin(), found.end(),
                   [](const PoseHypothesis& a, const PoseHypothesis& b) { return a.fit > b.fit; });
  for (const PoseHypothesis& pose : found) {
    if (pose.fit >= found.front().fit - options_.kMargin && !near_result(pose.X_MB, 0.0))
      results_.push_back(pose);
  }
  open_.clear();
  phase_ = Phase::finished;
}

bool PoseSearch::near_result(const Pose2& X_MB, double margin) const {
  return std::any_of(results_.begin(), results_.end(), [&](const PoseHypothesis& result) {
    return (result.X_MB.position() - X_MB.position()).norm() + margin < options_.kApart &&
           std::abs(wrap_angle(result.X_MB.theta - X_MB.theta)) < options_.kApartAngle;
  });
}

std::int32_t PoseSearch::score(const Pose2& X_MB) const {
  const Vector2 column = direction(X_MB.theta);
  std::int32_t sum = 0;
  for (std::size_t b = 0; b < ends_.size(); ++b) {
    const auto x = static_cast<double>(ends_.x[b]);
    const auto y = static_cast<double>(ends_.y[b]);
    sum += tables_.at(0, tables_.column_of(X_MB.x + column.x() * x - column.y() * y),
                      tables_.row_of(X_MB.y + column.y() * x + column.x() * y));
  }
  return sum;
}

// By score; among equals the finer first, then in a fixed order, so that a search repeats itself.
bool PoseSearch::worse(const Node& a, const Node& b) {
  if (a.score != b.score) return a.score < b.score;
  if (a.level != b.level) return a.level > b.level;
  if (a.heading != b.heading) return a.heading > b.heading;
  if (a.y != b.y) return a.y > b.y;
  return a.x > b.x;
}

double PoseSearch::heading_of(std::size_t index) const {
  return -std::numbers::pi +
         2.0 * std::numbers::pi * static_cast<double>(index) / static_cast<double>(headings_);
}

Pose2 PoseSearch::pose_of(const Node& node) const {
  const double half = ((1 << node.level) - 1) / 2.0;
  const Vector2 center = tables_.center(node.x + half, node.y + half);
  return {center.x(), center.y(), wrap_angle(heading_of(node.heading))};
}

double PoseSearch::fit_of(std::int32_t score) const {
  return static_cast<double>(score) / (255.0 * static_cast<double>(ends_.size()));
}

}  // namespace bw::localization
