#include "components/explore/explorer.hpp"

#include <algorithm>

namespace bw::explore {
namespace {

constexpr double kSameFrontier = 0.5;  // [m] between centres, from one map to the next

constexpr int kLooks = 3;  // until a frontier that was reached is for nothing

bool are_near(const Vector2& a, const Vector2& b) { return (a - b).norm() <= kSameFrontier; }

bool holds(const std::vector<Vector2>& list, const Vector2& place) {
  return std::ranges::any_of(list, [&](const Vector2& other) { return are_near(other, place); });
}

}  // namespace

std::string_view to_string(ExploreState state) {
  switch (state) {
    case ExploreState::paused:
      return "exploration_paused";
    case ExploreState::exploring:
      return "exploration_in_progress";
    case ExploreState::returning:
      return "returning_to_origin";
    case ExploreState::complete:
      return "exploration_complete";
  }
  return "unknown";
}

void Explorer::resume(const Pose2& robot) {
  if (state_ == ExploreState::exploring || state_ == ExploreState::returning) return;
  if (state_ == ExploreState::complete || !start_) {
    const ExplorerOptions options = options_;
    *this = Explorer(options);
    start_ = robot;
  }
  state_ = ExploreState::exploring;
}

ExploreStep Explorer::pause() {
  const bool drives = state_ == ExploreState::returning || target_.has_value();
  if (state_ != ExploreState::complete) state_ = ExploreState::paused;
  target_.reset();
  return {.cancels = drives, .goal = std::nullopt};
}

ExploreStep Explorer::look(const FrontierSearch& search) {
  if (state_ != ExploreState::exploring || !search.is_placed) return {};
  if (reached_) {
    const bool is_there = std::ranges::any_of(
        search.frontiers, [&](const Frontier& f) { return are_near(f.centre, *reached_); });
    // The map may be of a moment before the robot stood there.
    if (is_there && ++looks_since_ < kLooks) return {};
    if (is_there) useless_.push_back(*reached_);
    reached_.reset();
  }
  given_up_ = search.out_of_reach.size() +
              static_cast<std::size_t>(std::ranges::count_if(
                  search.frontiers, [&](const Frontier& f) { return is_blacklisted(f); }));
  if (target_ &&
      std::ranges::any_of(search.frontiers, [&](const Frontier& f) { return are_near(f.centre, *target_); }))
    return {};
  const bool had_target = target_.has_value();
  target_.reset();
  const Frontier* next = best(search.frontiers);
  if (next == nullptr && !second_chance_ && !failures_.empty()) {
    second_chance_ = true;
    failures_.clear();
    next = best(search.frontiers);
  }
  if (next != nullptr) {
    target_ = next->centre;
    ++goals_;
    return {.cancels = false, .goal = next->goal};
  }
  if (options_.return_to_init) {
    state_ = ExploreState::returning;
    ++goals_;
    return {.cancels = false, .goal = start_};
  }
  state_ = ExploreState::complete;
  return {.cancels = had_target, .goal = std::nullopt};
}

void Explorer::goal_ended(bool reached) {
  if (!reached) ++failed_;
  if (state_ == ExploreState::returning) state_ = ExploreState::complete;
  if (!target_) return;
  if (reached) {
    reached_ = target_;
    looks_since_ = 0;
  } else {
    (second_chance_ ? useless_ : failures_).push_back(*target_);
  }
  target_.reset();
}

bool Explorer::is_blacklisted(const Frontier& frontier) const {
  return holds(failures_, frontier.centre) || holds(useless_, frontier.centre);
}

const Frontier* Explorer::best(const std::vector<Frontier>& frontiers) const {
  const Frontier* best = nullptr;
  double least = 0.0;
  for (const Frontier& frontier : frontiers) {
    if (is_blacklisted(frontier)) continue;
    const double cost = frontier.path_length - options_.gain_scale * frontier.length;
    if (best != nullptr && cost >= least) continue;
    best = &frontier;
    least = cost;
  }
  return best;
}

}  // namespace bw::explore
