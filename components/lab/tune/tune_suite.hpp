// Where a planner is tuned and judged: families of episodes from seeds, planners alone.
#pragma once

#include <cstdint>
#include <string>

#include "components/local_planner/planner_registry.hpp"

namespace bw::tune {

enum class TuneSuite {
  crowd,     ///< bench crowd
  crowdnav,  ///< bench crowdnav --scene crowd, by its rule beyond its 500 cases
  corridor,  ///< bench corridor --people 12
};

struct TuneDrive {
  bool success = false;
  double time = 0.0;   ///< [s]
  double limit = 1.0;  ///< after which it would have been late [s]

  /// The objective, fixed before anything is tuned: success, then time.
  double cost() const { return success ? 0.1 * time / limit : 1.0; }
};

TuneDrive drive_episode(TuneSuite suite, std::uint64_t episode, const std::string& planner,
                        const PlannerOptions& options);

}  // namespace bw::tune
