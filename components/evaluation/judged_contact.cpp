#include "components/evaluation/judged_contact.hpp"

#include <algorithm>
#include <map>

namespace bw {
namespace {

constexpr std::size_t kMaxJudged = 20;
constexpr std::int8_t kOccupiedFrom = 65;  // [%] as the map server's usual threshold

/// Paths of all people: one for each stretch without a gap.
std::vector<possible::Walk> walks_of(const std::vector<RecordedMoment>& moments) {
  std::map<std::uint32_t, possible::Walk> open;
  std::vector<possible::Walk> walks;
  for (const RecordedMoment& moment : moments) {
    for (auto walk = open.begin(); walk != open.end();) {
      const bool goes_on = std::any_of(moment.people.begin(), moment.people.end(),
                                       [&](const TruePerson& person) { return person.id == walk->first; });
      if (!goes_on) walks.push_back(std::move(walk->second));
      walk = goes_on ? std::next(walk) : open.erase(walk);
    }
    for (const TruePerson& person : moment.people) {
      possible::Walk& walk = open[person.id];
      walk.radius = person.radius;
      walk.positions.push_back({moment.time, person.position});
    }
  }
  for (auto& [id, walk] : open) walks.push_back(std::move(walk));
  return walks;
}

std::vector<Vector2> occupied_cells(const OccupancyGrid& map) {
  std::vector<Vector2> cells;
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column)
      if (map.at(column, row) >= kOccupiedFrom) cells.push_back(map.center(column, row));
  return cells;
}

/// The time from which on a contact is looked at.
double looked_at_from(const std::vector<JudgedContact>& contacts, std::size_t index) {
  const ContactRecord& contact = contacts[index].record;
  double from = std::max({0.0, contact.there_since, contact.time - kLongestSearch});
  for (std::size_t i = 0; i < index; ++i) {
    const bool was_lost = contacts[i].verdict.avoidance == possible::Avoidance::not_avoidable;
    if (was_lost && contacts[i].record.end < contact.time)
      from = std::max(from, contacts[i].record.end + 1e-3);
  }
  return from;
}

}  // namespace

std::vector<JudgedContact> judge_contacts(const std::vector<ContactRecord>& contacts,
                                          const possible::SearchScene& scene,
                                          const std::vector<possible::MotionState>& drive, double known_until,
                                          const Limits& limits) {
  std::vector<JudgedContact> judged;
  for (const ContactRecord& contact : contacts) judged.push_back({contact, false, {}});
  for (std::size_t i = 0; i < std::min(judged.size(), kMaxJudged); ++i) {
    const ContactRecord& contact = judged[i].record;
    judged[i].is_judged = true;
    if (contact.there_since >= contact.time) {
      judged[i].verdict = {possible::Avoidance::not_avoidable, std::nullopt, contact.time};
      continue;
    }
    judged[i].verdict =
        possible::judge_contact(scene, drive, looked_at_from(judged, i), contact.time, known_until, limits);
  }
  return judged;
}

std::vector<JudgedContact> judge_contacts(const RunRecording& recording) {
  std::vector<JudgedContact> judged;
  if (!recording.limits || recording.moments.empty()) {
    for (const ContactRecord& contact : recording.contacts) judged.push_back({contact, false, {}});
    return judged;
  }
  if (recording.contacts.empty()) return judged;
  possible::SearchScene scene;
  scene.walks = walks_of(recording.moments);
  scene.shapes = recording.shapes;
  scene.outer_radius = recording.robot.radius;
  scene.inner_radius =
      recording.robot.is_polygon() ? inscribed_radius(recording.robot) : recording.robot.radius;
  if (recording.map) {
    scene.squares = occupied_cells(*recording.map);
    scene.square_edge = recording.map->resolution;
  }
  std::vector<possible::MotionState> drive;
  for (const RecordedMoment& moment : recording.moments)
    drive.push_back({moment.time, moment.X_MB, moment.twist});
  return judge_contacts(recording.contacts, scene, drive, recording.moments.back().time, *recording.limits);
}

bool is_excused(const std::vector<JudgedContact>& contacts, int counted) {
  int excused = 0;
  for (const JudgedContact& contact : contacts) {
    const bool is_lost = contact.is_judged && contact.verdict.avoidance == possible::Avoidance::not_avoidable;
    if (!is_lost) return false;
    ++excused;
  }
  return excused > 0 && excused >= counted;
}

}  // namespace bw
