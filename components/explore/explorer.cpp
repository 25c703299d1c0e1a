#include "components/explore/explorer.hpp"

#include <algorithm>

namespace bw::explore {
namespace {

// [m] between centres of a frontier from one map to the next, and between goals that are not worth a new one.
constexpr double kSame = 0.5;

// Until a frontier that was reached is for nothing, and until nothing is left: the map may be of a moment before.
constexpr int kLooks = 3;

constexpr std::string_view kNothingSeen = "nothing more of it is seen from before it";
constexpr std::string_view kOutOfReach = "no known free ground leads to it";

bool are_near(const Vector2& a, const Vector2& b) { return (a - b).norm() <= kSame; }

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
    *this = Explorer(return_to_init_);
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
  const bool looks = state_ == ExploreState::exploring || state_ == ExploreState::returning;
  if (!looks || !search.is_placed || stands_before_it(search.frontiers)) return {};
  const Frontier* next = nearest(search.frontiers);
  if (next == nullptr && !second_chance_ && !blacklist_.empty()) {
    second_chance_ = true;
    next = nearest(search.frontiers);
  }
  take_stock(search);
  if (next == nullptr) return ++empty_looks_ < kLooks ? ExploreStep{} : nothing_left();
  empty_looks_ = 0;
  const bool is_driven_to = target_ && are_near(next->goal.position(), goal_.position());
  state_ = ExploreState::exploring;
  target_ = next->centre;
  if (is_driven_to) return {};
  goal_ = next->goal;
  ++goals_;
  return {.cancels = false, .goal = goal_};
}

void Explorer::goal_ended(GoalEnd end, const std::string& why) {
  if (end == GoalEnd::failed) ++failed_;
  if (state_ == ExploreState::returning && end != GoalEnd::dropped) state_ = ExploreState::complete;
  if (state_ == ExploreState::returning)
    state_ = ExploreState::exploring;  // and it sees that nothing is left
  if (!target_) return;
  if (end == GoalEnd::reached) {
    reached_ = target_;
    looks_ = 0;
  } else if (end == GoalEnd::failed) {
    blacklist(*target_, std::string("not reached: ").append(why));
  }
  target_.reset();
}

// True while it cannot be told yet whether the frontier before which the robot stands has vanished.
bool Explorer::stands_before_it(const std::vector<Frontier>& frontiers) {
  if (!reached_) return false;
  // Unless it can come nearer by now.
  const auto stays = [&](const Frontier& f) {
    const double before = (goal_.position() - f.centre).norm();
    return are_near(f.centre, *reached_) && (f.goal.position() - f.centre).norm() > before - kSame;
  };
  const bool is_there = std::ranges::any_of(frontiers, stays);
  if (is_there && ++looks_ < kLooks) return true;
  if (is_there) blacklist(*reached_, std::string(kNothingSeen));
  reached_.reset();
  return false;
}

void Explorer::blacklist(const Vector2& place, const std::string& why) {
  const auto known = std::ranges::find_if(
      blacklist_, [&](const Failure& failure) { return are_near(failure.place, place); });
  if (known == blacklist_.end()) {
    blacklist_.push_back({.place = place, .why = why, .times = second_chance_ ? 2 : 1});
  } else {
    ++known->times;
    known->why = why;
  }
}

const Explorer::Failure* Explorer::blacklisted(const Frontier& frontier) const {
  const int allowed = second_chance_ ? 1 : 0;
  const auto found = std::ranges::find_if(blacklist_, [&](const Failure& failure) {
    return failure.times > allowed && are_near(failure.place, frontier.centre);
  });
  return found == blacklist_.end() ? nullptr : &*found;
}

const Frontier* Explorer::nearest(const std::vector<Frontier>& frontiers) const {
  const Frontier* nearest = nullptr;
  for (const Frontier& frontier : frontiers) {
    if (blacklisted(frontier) != nullptr) continue;
    if (nearest == nullptr || frontier.path_length < nearest->path_length) nearest = &frontier;
  }
  return nearest;
}

void Explorer::take_stock(const FrontierSearch& search) {
  left_.clear();
  for (const Frontier& frontier : search.frontiers)
    if (const Failure* failure = blacklisted(frontier)) left_.push_back({frontier.centre, failure->why});
  for (const Vector2& centre : search.out_of_reach) {
    LeftFrontier& frontier = left_.emplace_back();
    frontier.centre = centre;
    frontier.why = kOutOfReach;
  }
}

ExploreStep Explorer::nothing_left() {
  if (state_ == ExploreState::returning) return {};
  const bool drives = target_.has_value();
  target_.reset();
  if (!return_to_init_) {
    state_ = ExploreState::complete;
    return {.cancels = drives, .goal = std::nullopt};
  }
  state_ = ExploreState::returning;
  ++goals_;
  return {.cancels = false, .goal = start_};
}

}  // namespace bw::explore
