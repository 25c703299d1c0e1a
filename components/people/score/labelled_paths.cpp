#include "components/people/score/labelled_paths.hpp"

#include <algorithm>

namespace bw::people {
namespace {

constexpr double kSameLabelTime = 1e-6;  // [s]

}  // namespace

LabelledPaths::LabelledPaths(const std::vector<LabelledInstant>& instants, double longest_step)
    : longest_step_(longest_step) {
  for (const LabelledInstant& instant : instants) {
    for (const TruePerson& person : instant.people) paths_[person.id].push_back({instant.time, person});
  }
}

std::optional<TruePerson> LabelledPaths::on(const std::vector<Label>& path, double time) const {
  const auto is_before = [](const Label& label, double t) { return label.time < t - kSameLabelTime; };
  const auto next = std::lower_bound(path.begin(), path.end(), time, is_before);
  if (next == path.end()) return std::nullopt;
  const auto is_step = [&](auto to) {
    return to != path.begin() && to != path.end() && to->time - (to - 1)->time <= longest_step_;
  };
  const auto velocity = [](auto to) -> Vector2 {
    return (to->person.position - (to - 1)->person.position) / (to->time - (to - 1)->time);
  };
  TruePerson person = next->person;
  if (next->time <= time + kSameLabelTime) {
    if (is_step(next)) {
      person.velocity = velocity(next);
    } else if (is_step(next + 1)) {
      person.velocity = velocity(next + 1);
    }
    return person;
  }
  if (!is_step(next)) return std::nullopt;
  const TruePerson& before = (next - 1)->person;
  person.velocity = velocity(next);
  person.position -= (next->time - time) * person.velocity;
  person.counted = person.counted && before.counted;
  person.unoccluded = person.unoccluded && before.unoccluded;
  return person;
}

std::vector<TruePerson> LabelledPaths::at(double time) const {
  std::vector<TruePerson> people;
  for (const auto& [id, path] : paths_) {
    if (const auto person = on(path, time)) people.push_back(*person);
  }
  return people;
}

std::optional<TruePerson> LabelledPaths::at(double time, std::uint32_t id) const {
  const auto path = paths_.find(id);
  return path == paths_.end() ? std::nullopt : on(path->second, time);
}

}  // namespace bw::people
