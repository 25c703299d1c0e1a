// Where labelled people were between their labels.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "components/people/score/clear_mot.hpp"

namespace bw::people {

/// Everybody at one labelled instant, in O.
struct LabelledInstant {
  double time = 0.0;  ///< [s]
  std::vector<TruePerson> people;
  /// Confirmed tracks outside of it are not false; nothing: they are, wherever they are.
  std::optional<Disc> judged = std::nullopt;
};

class LabelledPaths {
 public:
  /// `instants` rise in time. People are taken to walk straight on between labels no more than `longest_step`
  /// [s] apart; across more nothing is known of them.
  LabelledPaths(const std::vector<LabelledInstant>& instants, double longest_step);

  /// Everybody known at `time`. Who is counted, or in plain view, is so at both labels around it; velocities
  /// are those of the path from one to the other.
  std::vector<TruePerson> at(double time) const;
  std::optional<TruePerson> at(double time, std::uint32_t id) const;

 private:
  struct Label {
    double time;
    TruePerson person;
  };
  std::optional<TruePerson> on(const std::vector<Label>& path, double time) const;

  double longest_step_;
  std::map<std::uint32_t, std::vector<Label>> paths_;
};

}  // namespace bw::people
