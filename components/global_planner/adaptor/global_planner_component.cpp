// Adaptor of the global planner: plan requests in, plan results and the path out; Nav2's services and actions
// beside them.
#include <bandwagon_msgs/msg/plan_request.hpp>
#include <bandwagon_msgs/msg/plan_result.hpp>

#include "components/global_planner/adaptor/map_planner.hpp"
#include "components/global_planner/adaptor/path_actions.hpp"
#include "components/global_planner/adaptor/plan_messages.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
#include "runtime/component.hpp"

namespace bw {

class GlobalPlannerComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    setup.longest_callback(Duration::milliseconds(5'000));  // a large map
    planner_.configure(setup);
    result_ = setup.output<bandwagon_msgs::msg::PlanResult>("plan_result");
    plan_ = setup.output<nav_msgs::msg::Path>("plan");
    setup.input<bandwagon_msgs::msg::PlanRequest>(
        "plan_request", Qos::standard(),
        [this](const auto& request, const Tick& tick) { answer(request, tick.now); });
    offer_path_actions(setup, planner_, [this](const nav_msgs::msg::Path& path) { plan_.publish(path); });
    with_nav2_layout(setup.ros_distro(),
                     [&]<class Nav2>(Nav2) { offer_path_check<typename Nav2::IsPathValid>(setup); });
  }

 private:
  template <class IsPathValid>
  void offer_path_check(Setup& setup) {
    setup.service<IsPathValid>(
        "is_path_valid", [this](const typename IsPathValid::Request& request, const Tick& tick) {
          const PathCheck check = planner_.check(request.path(), tick.now);
          typename IsPathValid::Response response;
          set_success(response, true);
          response.is_valid(check.valid);
          response.invalid_pose_indices().assign(check.blocked.begin(), check.blocked.end());
          return response;
        });
  }

  void answer(const bandwagon_msgs::msg::PlanRequest& request, Time now) {
    RouteRequest route{.start = std::nullopt, .stops = request.via_poses()};
    if (request.use_start()) route.start = request.start();
    route.stops.push_back(request.goal());
    const PathResult result = planner_.plan(route, now);
    const auto message = to_plan_result(result, request.id(), make_header(planner_.map_frame(), now));
    result_.publish(message);
    if (result.status == PathStatus::ok) plan_.publish(message.path());
  }

  MapPlanner planner_;
  Output<bandwagon_msgs::msg::PlanResult> result_;
  Output<nav_msgs::msg::Path> plan_;
};

BW_COMPONENT(GlobalPlannerComponent, "global_planner")

}  // namespace bw
