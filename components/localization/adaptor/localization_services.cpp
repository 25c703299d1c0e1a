// The services of AMCL. Their responses are empty: what they do not do is told in the log.
#include <nav2_msgs/srv/set_initial_pose.hpp>
#include <std_srvs/srv/empty.hpp>

#include "components/localization/adaptor/localization_component.hpp"

namespace bw::localization {

void LocalizationComponent::offer_services(Setup& setup) {
  using nav2_msgs::srv::SetInitialPose;
  using std_srvs::srv::Empty;
  setup.service<SetInitialPose>(
      "set_initial_pose",
      [this](const SetInitialPose::Request& request, const Tick& tick) {
        on_initial_pose(request.pose(), tick);
        return SetInitialPose::Response();
      },
      [](const std::string&) { return SetInitialPose::Response(); });
  setup.service<Empty>(
      "reinitialize_global_localization",
      [this](const Empty::Request&, const Tick& tick) {
        search(tick.now);
        return Empty::Response();
      },
      [](const std::string&) { return Empty::Response(); });
  setup.service<Empty>(
      "request_nomotion_update",
      [this](const Empty::Request&, const Tick&) {
        filter_->use_next_sweep();
        return Empty::Response();
      },
      [](const std::string&) { return Empty::Response(); });
}

}  // namespace bw::localization
