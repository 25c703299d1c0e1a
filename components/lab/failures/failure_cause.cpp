#include "components/lab/failures/failure_cause.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "components/evaluation/possible/search_scene.hpp"

namespace bw {
namespace {

constexpr double kAhead = 2.0;  // [s] before the contact
constexpr double kMeanOver =
    0.4;  // [s] of walking that a velocity is taken from: recordings look 2.5 times a second
constexpr double kOffCourse = 0.3;     // [m]: their radius
constexpr double kLastSeconds = 10.0;  // [s] of a drive that was late
constexpr double kHardly = 0.5;        // [m] in that time

possible::Walk walk_of(const RunRecording& recording, std::uint32_t id) {
  possible::Walk walk;
  for (const RecordedMoment& moment : recording.moments)
    for (const TruePerson& person : moment.people)
      if (person.id == id) walk.positions.push_back({moment.time, person.position});
  return walk;
}

/// `walk` has a position.
std::optional<double> off_course(const possible::Walk& walk, const ContactRecord& contact) {
  // Who came between two moments is in the later one.
  const double came = std::max(contact.there_since, walk.positions.front().time);
  const double from = std::max(contact.time - kAhead, came + kMeanOver);
  const std::optional<Vector2> there = walk.at(std::min(contact.time, walk.positions.back().time));
  const std::optional<Vector2> now = walk.at(from);
  const std::optional<Vector2> before = walk.at(from - kMeanOver);
  if (!there || !now || !before || from >= contact.time) return std::nullopt;
  const Vector2 headed = *now + (*now - *before) / kMeanOver * (contact.time - from);
  return (*there - headed).norm();
}

double distance_in_last_seconds(const RunRecording& recording) {
  double distance = 0.0;
  const std::vector<RecordedMoment>& moments = recording.moments;
  for (std::size_t i = 1; i < moments.size(); ++i)
    if (moments[i].time > moments.back().time - kLastSeconds)
      distance += (moments[i].X_MB.position() - moments[i - 1].X_MB.position()).norm();
  return distance;
}

FailureCause by_who(WhoHit who) {
  switch (who) {
    case WhoHit::robot_standing:
      return FailureCause::robot_standing;
    case WhoHit::robot_closing:
      return FailureCause::robot_closing;
    case WhoHit::person_behind:
      return FailureCause::from_behind;
    case WhoHit::person_side:
      return FailureCause::from_side;
    case WhoHit::person_ahead:
      break;
  }
  return FailureCause::from_ahead;
}

}  // namespace

const char* text_of(FailureCause cause) {
  switch (cause) {
    case FailureCause::stuck:
      return "stuck";
    case FailureCause::late:
      return "late";
    case FailureCause::thing:
      return "thing";
    case FailureCause::mid_floor:
      return "mid_floor";
    case FailureCause::robot_closing:
      return "robot_closing";
    case FailureCause::turning_walker:
      return "turning_walker";
    case FailureCause::robot_standing:
      return "robot_standing";
    case FailureCause::from_behind:
      return "from_behind";
    case FailureCause::from_side:
      return "from_side";
    case FailureCause::from_ahead:
      break;
  }
  return "from_ahead";
}

FoundCause cause_of(const RunRecording& recording, const std::optional<ContactRecord>& contact,
                    bool reached) {
  if (!contact) {
    if (reached) return {FailureCause::thing, std::nullopt};
    const bool moved = distance_in_last_seconds(recording) >= kHardly;
    return {moved ? FailureCause::late : FailureCause::stuck, std::nullopt};
  }
  const possible::Walk walk = walk_of(recording, contact->person);
  if (walk.positions.empty()) return {FailureCause::thing, std::nullopt};
  const std::optional<double> off = off_course(walk, *contact);
  const FailureCause hit = by_who(contact->closing.who);
  if (contact->begins_mid_floor || contact->ends_mid_floor) return {FailureCause::mid_floor, off};
  if (hit == FailureCause::robot_closing) return {hit, off};
  return {off && *off > kOffCourse ? FailureCause::turning_walker : hit, off};
}

}  // namespace bw
