#include "components/mapping/adaptor/costmap_services.hpp"

#include <nav2_msgs/srv/get_costmap.hpp>

#include "components/messages/costmap_clearing.hpp"

namespace bw::costmap {

void offer_services(Setup& setup, const std::string& folder, const CostmapAnswers& answers) {
  using nav2_msgs::srv::GetCostmap;
  offer_clear_services(
      setup, folder, "local_costmap",
      {.entirely = [answers] { answers.grid->clear(); },
       .inside = [answers](double edge) { answers.grid->clear_inside(answers.X_OB.position(), edge); },
       .outside = [answers](double edge) { answers.grid->clear_outside(answers.X_OB.position(), edge); }});
  setup.service<GetCostmap>(folder + "get_costmap",
                            [costs = answers.costs](const GetCostmap::Request&, const Tick& tick) {
                              GetCostmap::Response response;
                              response.map(costs(tick.now));
                              return response;
                            });
}

}  // namespace bw::costmap
