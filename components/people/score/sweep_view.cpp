#include "components/people/score/sweep_view.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

constexpr double kBody = 0.35;  // where legs and noise may be, round the position of a person [m]
constexpr int kPlain = 3;       // beams

/// What becomes of one beam on its way to a person.
enum class BeamOutcome { ends_at_them, passes, hidden_by_somebody, barred, unknown };

class View {
 public:
  View(const LaserSweep& sweep, const std::vector<TruePerson>& people) : sweep_(sweep), people_(people) {}

  bool holds(double bearing) const {
    const double last = static_cast<double>(sweep_.ranges.size() - 1);
    const double beam = beam_at(bearing);
    return beam >= 0.0 && beam <= last;
  }

  /// Beams whose path leads within `reach` [m] of the person.
  template <class Look>
  void each_beam(const TruePerson& person, double reach, const Look& look) const {
    const Vector2 to = person.position - sweep_.X_FL.position();
    const double half = std::asin(std::min(reach / std::max(to.norm(), reach), 1.0));
    const double middle = std::round(beam_at(bearing_of(person)));
    const double count = std::max(std::floor(half / std::abs(sweep_.angle_increment)), 1.0);
    const double last = static_cast<double>(sweep_.ranges.size() - 1);
    for (double beam = std::max(middle - count, 0.0); beam <= std::min(middle + count, last); ++beam)
      look(outcome_of(static_cast<std::size_t>(beam), person, to.norm()));
  }

  double bearing_of(const TruePerson& person) const {
    const Vector2 to = person.position - sweep_.X_FL.position();
    return wrap_angle(std::atan2(to.y(), to.x()) - sweep_.X_FL.theta);
  }

 private:
  /// Not rounded; the revolution that lies nearest to the middle of the sweep.
  double beam_at(double bearing) const {
    const double half = 0.5 * static_cast<double>(sweep_.ranges.size() - 1) * sweep_.angle_increment;
    return (half + wrap_angle(bearing - sweep_.angle_min - half)) / sweep_.angle_increment;
  }

  BeamOutcome outcome_of(std::size_t beam, const TruePerson& person, double distance) const {
    const float range = sweep_.ranges[beam];
    const BeamKind kind = kind_of(range, sweep_);
    if (kind == BeamKind::unknown) return BeamOutcome::unknown;
    if (kind == BeamKind::free) return BeamOutcome::passes;
    const double angle =
        sweep_.X_FL.theta + sweep_.angle_min + static_cast<double>(beam) * sweep_.angle_increment;
    const Vector2 end = sweep_.X_FL.position() + static_cast<double>(range) * direction(angle);
    if ((end - person.position).norm() <= kBody) return BeamOutcome::ends_at_them;
    if (static_cast<double>(range) > distance) return BeamOutcome::passes;
    const bool is_somebody = std::ranges::any_of(people_, [&](const TruePerson& other) {
      return other.id != person.id && (end - other.position).norm() <= kBody;
    });
    return is_somebody ? BeamOutcome::hidden_by_somebody : BeamOutcome::barred;
  }

  const LaserSweep& sweep_;
  const std::vector<TruePerson>& people_;
};

}  // namespace

void look_for(const LaserSweep& sweep, double range, std::vector<TruePerson>& people) {
  const View view(sweep, people);
  for (TruePerson& person : people) {
    const bool is_in_view =
        (person.position - sweep.X_FL.position()).norm() <= range && view.holds(view.bearing_of(person));
    int at_them = 0;
    int barred = 0;
    int open = 0;
    view.each_beam(person, kBody,
                   [&](BeamOutcome outcome) { at_them += outcome == BeamOutcome::ends_at_them ? 1 : 0; });
    view.each_beam(person, 0.0, [&](BeamOutcome outcome) {
      barred += outcome == BeamOutcome::barred ? 1 : 0;
      open += outcome != BeamOutcome::barred && outcome != BeamOutcome::unknown ? 1 : 0;
    });
    person.counted = is_in_view && (open > barred || at_them >= kPlain);
    person.unoccluded = person.counted && at_them >= kPlain;
  }
}

}  // namespace bw::people
