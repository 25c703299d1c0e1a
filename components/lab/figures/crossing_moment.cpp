#include "components/lab/figures/crossing_moment.hpp"

#include <memory>

#include "components/lab/bench/crowd_episode.hpp"

namespace bw::figures {

CrossingMoment crossing_moment(std::string_view planner, const PlannerOptions& options, double time) {
  const std::unique_ptr<LocalPlanner> driver = make_planner(planner, options);
  std::optional<CrossingMoment> moment;
  drive_crowd(
      crossing_scene({}, 1), crossing_rules(), *driver, [] { return 0.0; }, {},
      [&](double now, const PlanningProblem& problem, const PlanningResult& result) {
        if (!moment && now + 1e-9 >= time) moment = CrossingMoment{problem, result};
      });
  return moment.value();
}

}  // namespace bw::figures
