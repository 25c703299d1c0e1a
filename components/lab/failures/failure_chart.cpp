#include "components/lab/failures/failure_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "components/evaluation/picture_view.hpp"
#include "components/model/footprint_outline.hpp"

namespace bw {
namespace {

using report::Color;
using report::Dash;
using report::Look;

constexpr double kBefore = 4.0;     // paths of people so long before the contact [s]
constexpr double kAfter = 1.5;      // and of the robot after it [s]
constexpr double kRoom = 1.0;       // about what is shown [m]
constexpr double kLeastSize = 6.0;  // of the area shown [m]
constexpr double kCrowded = 0.03;   // of its width: numbers are farther apart

using Moments = std::vector<RecordedMoment>;
using Path = std::vector<possible::TimedPosition>;

/// Straight on between moments; the first and last before and after.
Pose2 pose_at(const Moments& moments, double time) {
  const auto after = std::ranges::lower_bound(moments, time, {}, &RecordedMoment::time);
  if (after == moments.begin()) return moments.front().X_MB;
  if (after == moments.end()) return moments.back().X_MB;
  const RecordedMoment& a = *std::prev(after);
  const RecordedMoment& b = *after;
  const double share = (time - a.time) / (b.time - a.time);
  const Vector2 position = a.X_MB.position() + share * (b.X_MB.position() - a.X_MB.position());
  return {position.x(), position.y(),
          a.X_MB.theta + share * std::remainder(b.X_MB.theta - a.X_MB.theta, 2.0 * M_PI)};
}

/// Positions of a person from `from` to `until` [s], as they were looked at.
Path path_of(const Moments& moments, std::uint32_t person, double from, double until) {
  Path path;
  for (const RecordedMoment& moment : moments) {
    if (moment.time < from - 1e-6 || moment.time > until + 1e-6) continue;
    for (const TruePerson& one : moment.people)
      if (one.id == person) path.push_back({moment.time, one.position});
  }
  return path;
}

class FailureDrawing {
 public:
  FailureDrawing(const RunRecording& recording, const std::optional<JudgedContact>& contact)
      : recording_(recording), moments_(recording.moments), contact_(contact) {
    time_ = contact ? contact->record.time : moments_.back().time;
    if (contact && !contact->verdict.motion.empty()) motion_ = &contact->verdict.motion;
    from_ = std::max(moments_.front().time, time_ - kBefore);
    if (motion_ != nullptr) from_ = std::min(from_, motion_->front().time - 1.0);
    if (!contact) from_ = moments_.front().time;
    view_ = find_view();
  }

  report::Chart chart() {
    plan_.show(view_);
    if (recording_.map) plan_.blocks = cell_blocks(*recording_.map, view_, 65, 100);
    plan_.walls = recording_.shapes.segments;
    for (const Disc& disc : recording_.shapes.discs)
      plan_.bodies.push_back({.center = disc.center, .radius = disc.radius, .color = Color::ink});
    for (const Vector2& goal : recording_.goals)
      plan_.marks.push_back({goal, report::Symbol::ring, Color::ink, "goal"});
    add_people();
    add_robot();
    add_escape();
    if (contact_) {
      const Vector2 robot = pose_at(moments_, time_).position();
      plan_.marks.push_back({robot + 0.5 * (touched_person() - robot), report::Symbol::dot, Color::red,
                             fmt::format("contact {:.2f} s", time_)});
    }
    return plan_;
  }

 private:
  Eigen::AlignedBox2d find_view() const {
    Eigen::AlignedBox2d box;
    for (const RecordedMoment& moment : moments_)
      if (moment.time >= from_ - 1e-6 && moment.time <= time_ + kAfter) box.extend(moment.X_MB.position());
    if (motion_ != nullptr)
      for (const possible::MotionState& state : *motion_) box.extend(state.pose.position());
    if (contact_)
      for (const auto& timed : path_of(moments_, contact_->record.person, time_ - kBefore, time_))
        box.extend(timed.position);
    if (!contact_)
      for (const Vector2& goal : recording_.goals) box.extend(goal);
    if (box.isEmpty()) box.extend(moments_.back().X_MB.position());
    box.min().array() -= kRoom;
    box.max().array() += kRoom;
    for (int axis = 0; axis < 2; ++axis) {
      const double missing = std::max(0.0, kLeastSize - box.sizes()[axis]);
      box.min()[axis] -= missing / 2.0;
      box.max()[axis] += missing / 2.0;
    }
    return box;
  }

  /// Everybody at the time of the contact, and their paths of the seconds before; of who is touched also
  /// after it.
  void add_people() {
    const auto now = std::ranges::min_element(
        moments_, {}, [this](const RecordedMoment& moment) { return std::abs(moment.time - time_); });
    for (const TruePerson& person : now->people) {
      const bool is_touched = contact_ && contact_->record.person == person.id;
      if (!is_touched && view_.exteriorDistance(person.position) > person.radius) continue;
      const Color color = is_touched ? Color::red : Color::violet;
      add_path(is_touched ? "who is touched" : "others, last 4 s",
               {.color = color, .width = is_touched ? 2.5 : 1.6},
               path_of(moments_, person.id, time_ - kBefore, time_), is_touched);
      plan_.bodies.push_back({person.position, person.radius, color, std::to_string(person.id), {0.0, 0.0}});
      if (!is_touched) continue;
      const double end = motion_ != nullptr ? motion_->back().time : time_ + kAfter;
      add_line("", {.color = color, .dash = Dash::dots, .width = 1.4},
               path_of(moments_, person.id, time_, end));
    }
  }

  /// Where the robot drove, a dot and the time every second, and its body at the contact.
  void add_robot() {
    Path all, near;
    for (const RecordedMoment& moment : moments_) {
      all.push_back({moment.time, moment.X_MB.position()});
      if (moment.time >= from_ - 1e-6 && moment.time <= time_ + 1e-6) near.push_back(all.back());
    }
    near.push_back({time_, pose_at(moments_, time_).position()});
    add_line("", {.color = Color::grey, .width = 1.6}, all);
    add_path("robot, a dot each second", {.color = Color::blue, .width = 3.5}, near, true);
    add_body(pose_at(moments_, time_), Color::blue, Dash::none);
  }

  /// The latest state from which a motion is known, and that motion.
  void add_escape() {
    if (motion_ == nullptr) return;
    Path path;
    for (const possible::MotionState& state : *motion_) path.push_back({state.time, state.pose.position()});
    add_path("a motion without contact", {.color = Color::green, .dash = Dash::dashes, .width = 3.0}, path,
             true);
    add_body(motion_->front().pose, Color::green, Dash::dashes);
    add_body(motion_->back().pose, Color::green, Dash::dashes);
    plan_.marks.push_back({motion_->front().pose.position(), report::Symbol::ring, Color::green,
                           fmt::format("avoidable until {:.1f} s", motion_->front().time)});
  }

  /// Centre of who is touched, at the contact; the robot's where nobody knows.
  Vector2 touched_person() const {
    Vector2 person = pose_at(moments_, time_).position();
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& timed : path_of(moments_, contact_->record.person, time_ - 0.3, time_ + 0.3)) {
      if (std::abs(timed.time - time_) >= nearest) continue;
      nearest = std::abs(timed.time - time_);
      person = timed.position;
    }
    return person;
  }

  void add_line(const std::string& name, const Look& look, const Path& path) {
    if (path.size() < 2) return;
    plan_.series.push_back({name, look});
    for (const possible::TimedPosition& timed : path) plan_.series.back().points.push_back(timed.position);
  }

  /// With a dot each whole second, and its number where that is not too near to the one before.
  void add_path(const std::string& name, const Look& look, const Path& path, bool is_numbered) {
    add_line(name, look, path);
    std::optional<Vector2> numbered;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const double second = std::ceil(path[i].time - 1e-6);
      if (second >= path[i + 1].time - 1e-6) continue;
      const double share = std::clamp((second - path[i].time) / (path[i + 1].time - path[i].time), 0.0, 1.0);
      const Vector2 at = path[i].position + share * (path[i + 1].position - path[i].position);
      const bool is_far = !numbered || (*numbered - at).norm() >= kCrowded * view_.sizes().x();
      plan_.marks.push_back(
          {at, report::Symbol::dot, look.color, is_numbered && is_far ? fmt::format("{:.0f}", second) : ""});
      if (is_numbered && is_far) numbered = at;
    }
  }

  /// The robot's outline, or its disc where it has none or the heading is not known.
  void add_body(const Pose2& pose, Color color, Dash dash) {
    const bool has_outline = recording_.robot.is_polygon() && std::isfinite(pose.theta);
    const double radius = recording_.robot.radius;
    if (has_outline) plan_.areas.push_back({outline(recording_.robot, pose, 0), color, dash});
    plan_.bodies.push_back(
        {.center = pose.position(),
         .radius = has_outline ? 0.0 : radius,
         .color = color,
         .arrow = std::isfinite(pose.theta) ? Vector2(radius * direction(pose.theta)) : Vector2(0.0, 0.0)});
  }

  const RunRecording& recording_;
  const Moments& moments_;
  const std::optional<JudgedContact>& contact_;
  double time_ = 0.0;
  double from_ = 0.0;  ///< the robot's path stands out from here on [s]
  const std::vector<possible::MotionState>* motion_ = nullptr;
  Eigen::AlignedBox2d view_;
  report::Chart plan_ = report::floor_plan("");
};

}  // namespace

report::Chart failure_chart(const RunRecording& recording, const std::optional<JudgedContact>& contact) {
  return FailureDrawing(recording, contact).chart();
}

}  // namespace bw
