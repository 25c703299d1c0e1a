#include "components/messages/costmap_clearing.hpp"

#include <cmath>
#include <utility>

#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"

namespace bw {
namespace {

/// Offers one of the two services that name an edge.
template <class S>
void offer_clearing_by_edge(Setup& setup, const std::string& service, std::function<void(double)> clear) {
  const auto answer = [](bool is_done) {
    typename S::Response response;
    set_success(response, is_done);
    return response;
  };
  setup.service<S>(
      service,
      [=, log = setup.log()](const typename S::Request& request, const Tick&) {
        const auto edge = static_cast<double>(request.reset_distance());
        const bool is_edge = std::isfinite(edge) && edge >= 0.0;
        if (is_edge) {
          clear(edge);
        } else {
          log.error("{}: a reset_distance of {} is none: nothing is cleared", service, edge);
        }
        return answer(is_edge);
      },
      [answer](const std::string&) { return answer(false); });
}

}  // namespace

void offer_clear_services(Setup& setup, const std::string& folder, const std::string& name,
                          const CostmapClearing& clearing) {
  with_nav2_layout(setup.ros_distro(), [&]<class Nav2>(Nav2) {
    using Entirely = typename Nav2::ClearEntireCostmap;
    const auto answer = [](bool is_done) {
      typename Entirely::Response response;
      set_success(response, is_done);
      return response;
    };
    setup.service<Entirely>(
        folder + "clear_entirely_" + name,
        [answer, entirely = clearing.entirely](const auto&, const Tick&) {
          entirely();
          return answer(true);
        },
        [answer](const std::string&) { return answer(false); });
    offer_clearing_by_edge<typename Nav2::ClearCostmapAroundRobot>(setup, folder + "clear_around_" + name,
                                                                   clearing.inside);
    offer_clearing_by_edge<typename Nav2::ClearCostmapExceptRegion>(setup, folder + "clear_except_" + name,
                                                                    clearing.outside);
  });
}

}  // namespace bw
