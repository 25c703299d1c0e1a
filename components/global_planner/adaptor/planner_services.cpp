#include "components/global_planner/adaptor/planner_services.hpp"

#include <memory>
#include <utility>

#include <nav2_msgs/srv/get_costmap.hpp>
#include <nav2_msgs/srv/is_path_valid.hpp>

#include "components/messages/costmap.hpp"

namespace bw {

void offer_planner_services(Setup& setup, PlannerAnswers answers) {
  using nav2_msgs::srv::GetCostmap;
  using nav2_msgs::srv::IsPathValid;
  setup.service<IsPathValid>("is_path_valid", [check = std::move(answers.check)](
                                                  const IsPathValid::Request& request, const Tick& tick) {
    const PathCheck result = check(request.path(), tick.now);
    IsPathValid::Response response;
    response.is_valid(result.valid);
    response.invalid_pose_indices().assign(result.blocked.begin(), result.blocked.end());
    return response;
  });
  setup.service<GetCostmap>("global_costmap/get_costmap",
                            [costs = std::move(answers.costs)](const GetCostmap::Request&, const Tick& tick) {
                              GetCostmap::Response response;
                              response.map(costs(tick.now));
                              return response;
                            });
  const auto tell = [log = setup.log(), told = std::make_shared<bool>(false)] {
    if (std::exchange(*told, true)) return;
    log.info("the global costmap holds the map alone: there is nothing to clear");
  };
  offer_clear_services(
      setup, "global_costmap",
      {.entirely = tell, .inside = [tell](double) { tell(); }, .outside = [tell](double) { tell(); }});
}

}  // namespace bw
