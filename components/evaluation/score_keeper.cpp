#include "components/evaluation/score_keeper.hpp"

#include <algorithm>
#include <cmath>

#include "components/evaluation/collision_index.hpp"
#include "components/model/rim_gap.hpp"

namespace bw {
namespace {

constexpr std::int64_t kWall = -1;
constexpr double kMovingSpeed = 0.1;  // a contact slower than this is the other's doing [m/s]
constexpr double kSigmaNarrow = 0.45;
constexpr const char* kFalseClaim = "the robot claims the goal but is not there";
constexpr const char* kUnknownPose = "the robot claims the goal, and nothing tells where it was then";
constexpr const char* kMissedLeg = "an earlier goal was not reached";
constexpr const char* kUnknownLeg = "the robot claims an earlier goal, and nothing tells where it was then";

}  // namespace

void ScoreKeeper::start(Time now, const Vector2& goal, const GoalTolerance& tolerance) {
  ScoreKeeper fresh(options_, footprint_);
  fresh.running_ = true;
  fresh.goal_ = goal;
  fresh.tolerance_ = tolerance;
  fresh.started_ = now;
  *this = fresh;
}

void ScoreKeeper::add(const TruthSample& sample) {
  if (!running_ || !is_sound(sample) || (last_ && sample.time <= last_->time)) return;
  const double elapsed = (sample.time - started_).to_seconds();
  const double index = collision_index(sample.X_MB.position(), sample.people, kJudgingSigma);
  card_.max_collision_index = std::max(card_.max_collision_index, index);
  card_.max_collision_index_045 = std::max(
      card_.max_collision_index_045, collision_index(sample.X_MB.position(), sample.people, kSigmaNarrow));

  card_.min_distance = std::min(card_.min_distance, sample.wall_gap);
  for (const TruePerson& person : sample.people) {
    const double gap = rim_gap(footprint_, sample.X_MB, person.position, person.radius);
    card_.min_distance = std::min(card_.min_distance, gap);
    if (!card_.closest || gap < card_.closest->gap) {
      card_.closest = Encounter{elapsed, gap, person.id, person.position, person.radius, sample.X_MB};
    }
  }

  if (last_) {
    const double dt = (sample.time - last_->time).to_seconds();
    card_.path_length += (sample.X_MB.position() - last_->X_MB.position()).norm();
    time_measured_ += dt;
    if (index > kPhysicalLimit) time_above_0_54_ += dt;
    if (index > kComfortLimit) time_above_0_14_ += dt;
    card_.share_ci_above_0_54 = time_above_0_54_ / time_measured_;
    card_.share_ci_above_0_14 = time_above_0_14_ / time_measured_;
  }
  count_contacts(sample);
  if (std::isfinite(sample.twist.v)) jerk_.add(sample.time, sample.twist.v);
  card_.rms_jerk = jerk_.value();
  card_.time_to_goal = elapsed;
  card_.mean_speed = elapsed > 0.0 ? card_.path_length / elapsed : 0.0;
  card_.distance_to_goal = (goal_ - sample.X_MB.position()).norm();
  last_ = sample;
  knows_pose_ = true;
}

void ScoreKeeper::count_contacts(const TruthSample& sample) {
  // A wall takes the speed in the moment of contact, so the sample before it counts too.
  const double before = last_ ? std::abs(last_->twist.v) : 0.0;
  const bool fast = before > kMovingSpeed || std::abs(sample.twist.v) > kMovingSpeed;
  touch(kWall, sample.wall_gap, fast);
  for (const TruePerson& person : sample.people) {
    touch(person.id, rim_gap(footprint_, sample.X_MB, person.position, person.radius), fast);
  }
  for (auto contact = touching_.begin(); contact != touching_.end();) {  // people who left the scene
    const std::int64_t key = contact->first;
    const bool present = key == kWall || std::any_of(sample.people.begin(), sample.people.end(),
                                                     [key](const TruePerson& p) { return p.id == key; });
    contact = present ? std::next(contact) : touching_.erase(contact);
  }

  // The world looks more often than it tells: a touch between two samples is only in its count.
  const int counted =
      last_ && sample.contacts > last_->contacts ? static_cast<int>(sample.contacts - last_->contacts) : 0;
  world_contacts_ += counted;
  if (fast) world_contacts_at_speed_ += counted;
  card_.collisions = std::max(seen_contacts_, world_contacts_);
  card_.collisions_at_speed = std::max(seen_contacts_at_speed_, world_contacts_at_speed_);
}

void ScoreKeeper::touch(std::int64_t key, double gap, bool fast) {
  const auto contact = touching_.find(key);
  if (contact == touching_.end()) {
    if (gap > 0.0) return;
    touching_[key] = Contact{fast};
    ++seen_contacts_;
    if (fast) ++seen_contacts_at_speed_;
    return;
  }
  if (gap > kBodiesApart) {
    touching_.erase(contact);
  } else if (fast && !contact->second.at_speed) {
    contact->second.at_speed = true;
    ++seen_contacts_at_speed_;
  }
}

std::optional<bool> ScoreKeeper::is_there(bool claimed) const {
  if (!claimed) return false;
  if (!knows_pose_) return std::nullopt;
  return card_.distance_to_goal <=
         (options_.goal_tolerance > 0.0 ? options_.goal_tolerance : judged_xy(tolerance_));
}

void ScoreKeeper::end_leg(bool claimed) {
  const std::optional<bool> there = is_there(claimed);
  missed_a_leg_ |= there == false;
  has_unknown_leg_ |= !there;
}

void ScoreKeeper::settle(bool claimed, const std::string& reason) {
  const std::optional<bool> there = is_there(claimed);
  const bool is_missed = there == false || missed_a_leg_;
  card_.reached = there == true && !missed_a_leg_ && !has_unknown_leg_;
  card_.is_outcome_known = card_.reached || is_missed;
  card_.reason = reason;
  if (there == false && claimed) card_.reason = kFalseClaim;
  if (there == true && has_unknown_leg_) card_.reason = kUnknownLeg;
  if (there == true && missed_a_leg_) card_.reason = kMissedLeg;
  if (!there && !is_missed) card_.reason = kUnknownPose;
  if (!knows_pose_) card_.distance_to_goal = std::numeric_limits<double>::quiet_NaN();
}

void ScoreKeeper::close() {
  running_ = false;
  card_.finished = true;
  if (card_.reason.empty()) card_.reason = "the run ended before its goal";
}

void ScoreKeeper::finish(Time now, bool claimed, const std::string& reason) {
  if (!running_) return;
  running_ = false;
  card_.finished = true;
  card_.time_to_goal = (now - started_).to_seconds();
  card_.mean_speed = card_.time_to_goal > 0.0 ? card_.path_length / card_.time_to_goal : 0.0;
  settle(claimed, reason);
}

}  // namespace bw
